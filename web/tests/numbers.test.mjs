// SPDX-License-Identifier: GPL-3.0-or-later
// The module's numbers are those of the native program.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { answerOf, commandOf, found, grain, granumJson, startModule } from "./native.mjs";

const close = (a, b, relative, what) => assert.ok(Math.abs(a - b) <= relative * Math.abs(b), `${what}: ${a} is not ${b}`);

/// Numbers in [0, 1), the same each time.
function* randoms(seed) {
  for (let state = seed; ; ) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 2 ** 32;
  }
}

test("closed forms equal the native ones to 1e-12", async () => {
  const granum = await startModule();
  const random = randoms(1);
  const within = (low, high) => low + (high - low) * random.next().value;
  for (let k = 0; k < 30; ++k) {
    const shape = ["cone", "sphere", "flat"][k % 3];
    const packing = { voidRatio: within(0.5, 0.8), coordinationNumber: within(4.5, 6.5), anisotropy: within(-0.4, 0.4), stressV: within(1e4, 1e6) };
    packing.stressH = packing.stressV * within(0.5, 1.5);
    packing.mechanicalCoordinationNumber = packing.coordinationNumber * within(1, 1.1);
    const native = granumJson("estimate", "--contact", shape, "--void-ratio", packing.voidRatio, "--coordination-number", packing.coordinationNumber,
      "--fabric", packing.anisotropy, "--stress-v", `${packing.stressV}Pa`, "--stress-h", `${packing.stressH}Pa`,
      "--mechanical-coordination-number", packing.mechanicalCoordinationNumber,
      ...{ cone: ["--slope", grain.coneSlope], sphere: [], flat: ["--punch-radius", `${grain.punchRadius}m`] }[shape]);
    const forms = granum.closedForms({ ...grain, shape }, packing);
    for (const [ours, theirs] of [["uniformStrain", "uniform_strain"], ["uniformStress", "uniform_stress"], ["relaxed", "relaxed"]]) {
      const form = found(native, theirs);
      close(forms[ours].vh, form.G_vh, 1e-12, `${shape} ${theirs} G_vh`);
      close(forms[ours].hh, form.G_hh, 1e-12, `${shape} ${theirs} G_hh`);
      close(forms[ours].bulk, form.K, 1e-12, `${shape} ${theirs} K`);
      assert.ok(Math.abs(forms[ours].exponent - form.s) < 1e-9, `${shape} ${theirs} s`);
    }
  }
});

test("the calculator's answers equal the native ones to 1e-12, by the command that it shows", async () => {
  const granum = await startModule();
  const base = { voidRatio: 0.62, pressure: 2.5e5, grainModulus: 26e9, poissonRatio: 0.22, radius: 3e-4, density: 2480, saturation: 0, z: NaN, preparation: "unknown" };
  for (const change of [{}, { preparation: "dense" }, { preparation: "loose", saturation: 1 }, { z: 5.1 }, { voidRatio: 0.9 }]) {
    const known = { ...base, ...change };
    const ours = answerOf(granum, known);
    const native = granumJson(...commandOf(known).split(" ").slice(1)).answer;
    const names = ["shear_modulus", "bulk_modulus", "young_modulus", "poisson_ratio", "shear_wave_speed", "compression_wave_speed"];
    names.forEach((name, k) => {
      for (const part of ["value", "low", "high"]) close(ours.rows[k][part], native[name][part], 1e-12, `${JSON.stringify(change)} ${name} ${part}`);
    });
  }
});

test("errors are granum's own, and the module goes on", async () => {
  const granum = await startModule();
  const packing = { voidRatio: 0.6, coordinationNumber: 5.7, stressV: 1e5 };
  const before = granum.closedForms(grain, packing);
  assert.throws(() => granum.closedForms({ ...grain, poissonRatio: 0.6 }, packing), /grain_poisson_ratio = 0.6/);
  assert.deepEqual(granum.closedForms(grain, packing), before);
});

const pressures = [1e4, 2e4, 3e4, 5e4, 7e4, 1e5];

/// s of the network and its error, and every number on the way.
async function experiment(loose, seed) {
  let frames = 0;
  const granum = await startModule(() => ++frames);
  granum.call("experiment_begin", 1, grain.shearModulus, grain.poissonRatio, grain.radius, grain.coneSlope, grain.punchRadius,
    grain.frictionAngle, loose ? 1 : 0, 0, 300, seed, pressures[0]);
  granum.call("experiment_prepare");
  const rows = pressures.map((p) => granum.call("experiment_compress", p).numbers);
  assert.ok(frames > 0, "nothing was shown");
  return { rows, s: rows.at(-1)[11], error: rows.at(-1)[12], z: rows.at(-1)[3], e: rows.at(-1)[1] };
}

for (const density of ["dense", "loose"])
  test(`the experiment, ${density}: the same bits twice, and s of the native program`, async () => {
    const loose = density === "loose";
    const once = await experiment(loose, 1);
    assert.deepEqual(await experiment(loose, 1), once);
    assert.notDeepEqual((await experiment(loose, 2)).rows, once.rows);
    assert.ok(once.rows.every((row) => row.at(-1) === 1), "not at rest");
    const out = fs.mkdtempSync(path.join(os.tmpdir(), "granum-page-"));
    try {
      const native = granumJson("verify", ...["contacts=sphere", `densities=${density}`, "grains=300", `pressures=${pressures.map((p) => `${p / 1e3}kPa`)}`,
        "probe_pressures=100kPa"].flatMap((setting) => ["--set", `study.${setting}`]), "--out", path.join(out, "verify"));
      const s = native.exponents[0].network;
      console.log(`${density}: s ${once.s} +- ${once.error}, native ${s.value} +- ${s.standard_error}`);
      // Last digits of logarithms and powers differ; loose grains then go other ways, so that these are two specimens.
      assert.ok(Math.abs(once.s - s.value) < 3 * Math.hypot(once.error, s.standard_error), `s ${once.s}, native ${s.value}`);
    } finally {
      fs.rmSync(out, { recursive: true });
    }
  });
