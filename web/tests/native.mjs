// SPDX-License-Identifier: GPL-3.0-or-later
// The page's module beside the native program, and what both are given.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import vm from "node:vm";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
export const pageFile = path.join(root, "web/dist/granum.html");
export const page = fs.readFileSync(pageFile, "utf8");

/// The program that was built; GRANUM_PROGRAM names another.
export const program =
  process.env.GRANUM_PROGRAM ?? ["ci", "release"].map((preset) => path.join(root, "build", preset, "granum")).find((file) => fs.existsSync(file));
if (!program) throw new Error("no native granum in build/ci or build/release; GRANUM_PROGRAM can name one");

export function granumJson(...args) {
  return JSON.parse(execFileSync(program, [...args, "--json"], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }));
}

/// The first object of that name, however deep.
export function found(json, name) {
  if (json === null || typeof json !== "object") return undefined;
  if (json[name] !== undefined) return json[name];
  for (const inner of Object.values(json)) {
    const there = found(inner, name);
    if (there !== undefined) return there;
  }
  return undefined;
}

/// The scripts and the module as the page carries them.
const block = (id) => page.match(new RegExp(`<script id="${id}"[^>]*>([^]*?)</script>`))[1];
export const texts = JSON.parse(block("texts"));
const script = (name) => fs.readFileSync(path.join(root, "web/page", name), "utf8");
export const { Granum, grain, answerOf, inferenceOf, inferredPath, ladderOf, readKnownSands, sameAnswer, sameInference, sameSand, sameSandInference, sandAnswerOf, sandInferenceOf, sandLaws, sandPath, sandSlipsOf, shearPoint, slipsOf } = vm.runInThisContext(`(() => { ${block("worker-source").split("const view = ")[0]}
  ${page.match(/const defaultGrain = \{[^]*?\};/)[0]}
  ${script("same.js")}
  ${script("sand.js")}
  ${script("calculator.js")}
  return { Granum, grain: defaultGrain, answerOf, inferenceOf, inferredPath, ladderOf, readKnownSands, sameAnswer, sameInference, sameSand, sameSandInference, sandAnswerOf, sandInferenceOf, sandLaws, sandPath, sandSlipsOf, shearPoint, slipsOf }; })()`);

export async function startModule(onFrame) {
  const packed = new Blob([Buffer.from(block("wasm"), "base64")]).stream().pipeThrough(new DecompressionStream("gzip"));
  const granum = await Granum.create(await WebAssembly.compile(await new Response(packed).arrayBuffer()), onFrame);
  readKnownSands(granum);
  return granum;
}

export const close = (a, b, relative, what) => assert.ok(Math.abs(a - b) <= relative * Math.abs(b), `${what}: ${a} is not ${b}`);

/// Of the experiments of the tests [Pa].
export const pressures = [1e4, 2e4, 3e4, 5e4, 7e4, 1e5];

/// A module that is about to compress a specimen, made.
export async function prepared(loose, seed, onFrame) {
  const granum = await startModule(onFrame);
  granum.call("experiment_begin", 1, grain.shearModulus, grain.poissonRatio, grain.radius, NaN, NaN,
    grain.frictionAngle, loose ? 1 : 0, 0, 300, seed, pressures[0]);
  granum.call("experiment_prepare");
  return granum;
}

/// s of the network and its error, and every number on the way.
export async function experiment(loose, seed) {
  let frames = 0;
  const granum = await prepared(loose, seed, () => ++frames);
  const rows = pressures.map((p) => granum.call("experiment_compress", p).numbers);
  assert.ok(frames > 0, "nothing was shown");
  return { rows, s: rows.at(-1)[11], error: rows.at(-1)[12], z: rows.at(-1)[3], e: rows.at(-1)[1] };
}

/// A browser that draws without a graphics processor; each of its steps may take as long as a busy machine needs.
export async function launched() {
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    timeout: patience,
  });
  const opens = browser.newContext.bind(browser);
  browser.newContext = async (options) => {
    const context = await opens(options);
    context.setDefaultTimeout(patience);
    return context;
  };
  return browser;
}

const patience = 300000; // [ms]
/// Until a condition holds, however slow the machine; false once the patience is over.
export async function until(condition) {
  for (const end = Date.now() + patience; Date.now() < end; await new Promise((next) => setTimeout(next, 100)))
    if (await condition()) return true;
  return false;
}
