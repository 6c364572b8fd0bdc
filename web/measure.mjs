// SPDX-License-Identifier: GPL-3.0-or-later
// How long the page takes:  node web/measure.mjs [<rounds>]
// Experiments of 1,000 spheres from nothing to 100 kPa with networks at ten pressures, in Node on one thread, each round
// another seed, and in turn with them the native program on the same specimens, on one thread too (processor time of
// both, the program's start and the module's compilation included); in Chromium the time from the opening of the page, by its own
// clock, until the first step can be used, all parts can, and all pictures are drawn, that of the paper's six specimens, and frames a second of 1,000 grains that turn.
import { execFileSync } from "node:child_process";
import { pathToFileURL } from "node:url";
import { grain, launched, pageFile, program, startModule } from "./tests/native.mjs";

const rounds = Number(process.argv[2] ?? 5);
const median = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const line = (what, all, unit) => console.log(`${what}: ${median(all).toFixed(2)} ${unit} (${Math.min(...all).toFixed(2)} to ${Math.max(...all).toFixed(2)}, ${all.length} rounds)`);

const pressures = [10, 13, 17, 22, 28, 36, 46, 60, 77, 100];

/// Seconds until the first pressure and the last, and of the processor.
async function byModule(loose, seed) {
  const granum = await startModule();
  const begin = performance.now(), processor = process.cpuUsage();
  let first;
  granum.call("experiment_begin", 1, grain.shearModulus, grain.poissonRatio, grain.radius, NaN, NaN,
    grain.frictionAngle, loose, 0, 1000, seed, 1e4);
  granum.call("experiment_prepare");
  for (const pressure of pressures) {
    granum.call("experiment_compress", pressure * 1e3);
    first ??= (performance.now() - begin) / 1e3;
  }
  const { user, system } = process.cpuUsage(processor);
  return { first, whole: (performance.now() - begin) / 1e3, processor: (user + system) / 1e6 };
}

/// Seconds of the processor that the native program takes for the same.
function byProgram(loose, seed) {
  const settings = ["contacts=sphere", `densities=${loose ? "loose" : "dense"}`, "grains=1000", "threads=1", `first_seed=${seed}`, "probe_pressures=",
    `pressures=${pressures.map((p) => `${p}kPa`)}`].map((setting) => `--set study.${setting}`).join(" ");
  const said = execFileSync("bash", ["-c", `TIMEFORMAT="%U %S"; { time "$0" verify ${settings} --json --quiet >/dev/null 2>&1; } 2>&1`, program], { encoding: "utf8" });
  return said.trim().split(" ").reduce((sum, text) => sum + Number(text), 0);
}

for (const loose of [0, 1]) {
  const name = loose ? "loose" : "dense";
  const modules = [], programs = [];
  for (let seed = 1; seed <= rounds; ++seed) {
    modules.push(await byModule(loose, seed));
    programs.push(byProgram(loose, seed));
  }
  line(`${name}, first point`, modules.map((m) => m.first), "s");
  line(`${name}, ten pressures`, modules.map((m) => m.whole), "s");
  line(`${name}, ten pressures, processor`, modules.map((m) => m.processor), "s");
  line(`${name}, ten pressures, processor, native`, programs, "s");
  line(`${name}, speed over native`, programs.map((native, k) => native / modules[k].processor), "");
}

const browser = await launched();
const top = [], ready = [], all = [], frames = [], six = [];
for (let round = 0; round < rounds; ++round) {
  let page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  await page.goto(pathToFileURL(pageFile).href);
  await page.waitForSelector("html[data-ready=yes]");
  const at = (mark) => page.evaluate((name) => performance.getEntriesByName(name)[0].startTime / 1e3, mark);
  top.push(await at("first step"));
  ready.push(await at("ready"));
  all.push(await at("drawn"));
  await page.close();
  page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  await page.goto(`${pathToFileURL(pageFile).href}#xgrains=1000&xdensity=dense`);
  await page.waitForSelector("html[data-ready=yes]");
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#experiment tbody tr").length === 1, null, { timeout: 0 });
  await page.locator("#experiment canvas").scrollIntoViewIfNeeded();
  frames.push(await page.evaluate(() => new Promise((done) => {
    const canvas = document.querySelector("#experiment canvas");
    let count = 0;
    const begin = performance.now();
    const turn = () => {
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
      canvas.getContext("webgl2").finish();
      if (++count < 40) requestAnimationFrame(turn);
      else done((count * 1e3) / (performance.now() - begin));
    };
    requestAnimationFrame(turn);
  })));
  await page.click("#xclear");
  const begin = performance.now();
  await page.click("#xsix");
  await page.waitForFunction(() => document.querySelectorAll("#xruns tbody tr").length === 6, null, { timeout: 0 });
  six.push((performance.now() - begin) / 1e3);
  await page.close();
}
await browser.close();
line("first step can be used", top, "s");
line("all of the page can be used", ready, "s");
line("all pictures are drawn", all, "s");
line("the paper's six of 300 grains", six, "s");
line("1,000 grains that turn", frames, "frames a second");
