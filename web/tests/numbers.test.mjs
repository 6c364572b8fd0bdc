// SPDX-License-Identifier: GPL-3.0-or-later
// The module's numbers are those of the native program.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { execFileSync, spawnSync } from "node:child_process";
import { answerOf, close, experiment, found, grain, granumJson, inferenceOf, inferredPath, ladderOf, prepared, pressures, program, root, sameAnswer, sameInference, sameSand, sameSandInference,
  sandAnswerOf, sandInferenceOf, sandLaws, sandPath, sandSlipsOf, shearPoint, slipsOf, startModule } from "./native.mjs";

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
    const shape = ["cone", "sphere", "flat", "power-law", "rough"][k % 5];
    const packing = { voidRatio: within(0.5, 0.8), coordinationNumber: within(4.5, 6.5), anisotropy: within(-0.4, 0.4), stressV: within(1e4, 1e6) };
    packing.stressH = packing.stressV * within(0.5, 1.5);
    packing.mechanicalCoordinationNumber = packing.coordinationNumber * within(1, 1.1);
    const native = granumJson("estimate", "--contact", shape, "--void-ratio", packing.voidRatio, "--coordination-number", packing.coordinationNumber,
      "--fabric", packing.anisotropy, "--stress-v", `${packing.stressV}Pa`, "--stress-h", `${packing.stressH}Pa`,
      "--mechanical-coordination-number", packing.mechanicalCoordinationNumber,
      ...{ cone: ["--slope", 0.37], sphere: [], flat: ["--punch-radius", "6um"], "power-law": ["--alpha", 1.4, "--profile-constant", 90], rough: ["--roughness", "30nm"] }[shape]);
    const numbers = { cone_slope: 0.37, punch_radius: 6e-6, alpha: 1.4, profile_constant: 90, roughness: 30e-9 };
    const forms = granum.closedForms({ ...grain, shape, numbers }, packing);
    for (const [ours, theirs] of [["uniformStrain", "uniform_strain"], ["uniformStress", "uniform_stress"], ["relaxed", "relaxed"]]) {
      const form = found(native, theirs);
      close(forms[ours].vh, form.G_vh, 1e-12, `${shape} ${theirs} G_vh`);
      close(forms[ours].hh, form.G_hh, 1e-12, `${shape} ${theirs} G_hh`);
      close(forms[ours].bulk, form.K, 1e-12, `${shape} ${theirs} K`);
      assert.ok(Math.abs(forms[ours].exponent - form.s) < 1e-9, `${shape} ${theirs} s`);
    }
  }
});

/// What the calculator may be told: each adds to the first.
const asked = [{}, { preparation: "dense" }, { preparation: "loose", saturation: 1 }, { z: 5.1 }, { voidRatio: 0.9 },
  { stressRatio: 0.5, anisotropy: 0.15, preparation: "dense" }, { stressRatio: 1.7, anisotropy: -0.2, z: 4.8 }, { grainModulus: 30e9, poissonRatio: 0.15, density: 2650 },
  { stressRatio: 0.5, grainModulus: 30e9 }].map((change) => ({
  grains: "sphere", voidRatio: 0.62, pressure: 2.5e5, stressRatio: 1, anisotropy: 0, grainModulus: 26e9, poissonRatio: 0.22, radius: 3e-4, density: 2480, saturation: 0, z: NaN,
  preparation: "unknown", quantity: "V_s", value: 320, error: 0.02, otherPressure: 8e5, ...change }));
const inferred = [{}, { quantity: "V_p", value: 560, error: 0.01 }, { quantity: "G", value: 1.7e8, error: 0.05, otherPressure: 5e4 }].map((change) => ({ ...asked[0], ...change }));
/// The same for sands.
const sandsAsked = [{}, { uniformity: 2.3 }, { uniformity: 5.2, stressRatio: 0.5 }, { leastVoidRatio: 0.55, largestVoidRatio: 0.85 }, { leastVoidRatio: 0.55 }, { sand: "toyoura", voidRatio: 0.72, strain: 1e-4 },
  { sand: "hostun", densityBy: "relativeDensity" }, { densityBy: "relativeDensity", leastVoidRatio: 0.5, largestVoidRatio: 0.9, uniformity: 1.7, saturation: 1 },
  { sand: "ottawa", stressRatio: 1.6, pressure: 3e4, saturation: 0.4 }, { voidRatio: 1.9, pressure: 4e6 }].map((change) => ({
  grains: "sand", sand: "unnamed", densityBy: "voidRatio", voidRatio: 0.62, relativeDensity: 0.63, uniformity: NaN, leastVoidRatio: NaN, largestVoidRatio: NaN,
  pressure: 2.5e5, stressRatio: 1, density: 2640, saturation: 0, strain: NaN, quantity: "V_s", value: 320, error: 0.02, otherPressure: 8e5, ...change }));
const sandsInferred = [sandsAsked[0], { ...sandsAsked[1], quantity: "V_p", value: 560, error: 0.01 }, { ...sandsAsked[5], quantity: "G", value: 1.7e8, error: 0.05, otherPressure: 3e4 }, sandsAsked[6]];
const typed = (line) => line.split(" ").slice(1);

/// Every number of an answer, and the shares of its range.
function equalAnswers(ours, native, what) {
  const numbers = Object.entries(native).filter(([, number]) => number !== null && Number.isFinite(number.value));
  assert.deepEqual(Object.keys(ours.rows), numbers.map(([name]) => name), what);
  for (const [name, number] of numbers)
    for (const part of ["value", "low", "high"]) close(ours.rows[name][part], number[part], 1e-12, `${what} ${name} ${part}`);
  assert.deepEqual(ours.shares.map(({ input }) => input), Object.keys(native.shares), what);
  for (const { input, share } of ours.shares) close(share, native.shares[input], 1e-10, `${what} share of ${input}`);
}

test("the calculator's answers equal those of the shown command to 1e-12", async () => {
  const granum = await startModule();
  for (const known of asked) {
    equalAnswers(answerOf(granum, known), granumJson(...typed(sameAnswer.commandLine(known))).answer, JSON.stringify(known));
  }
});

test("exponents of measured sands equal the native ones to 1e-12", async () => {
  const ours = (await startModule()).call("sand_exponents").numbers;
  assert.equal(ours.length, 2);
  [1, 8].forEach((uniformity, k) => {
    const native = granumJson("estimate", "--grain-shape", "sand", "--void-ratio", 0.6, "--uniformity", uniformity, "--pressure", "100kPa").answer;
    close(ours[k], native.stress_exponent.value, 1e-12, `C_u ${uniformity}`);
  });
});

test("answers for sands equal those of the shown command to 1e-12, published laws too", async () => {
  const granum = await startModule();
  for (const known of sandsAsked) {
    const ours = sandAnswerOf(granum, known), what = JSON.stringify(known), native = granumJson(...typed(sameSand.commandLine(known)));
    assert.equal(native.answer.grain_shape, "sand");
    equalAnswers(ours, native.answer, what);
    const laws = sandLaws(granum, known, 3);
    assert.deepEqual(laws.map(({ name }) => name), native.measured_sands.map(({ law }) => law));
    native.measured_sands.forEach(({ law, shear_modulus: G, notes }, k) => {
      if (G === null) assert.ok(Number.isNaN(laws[k].here), law);
      else close(laws[k].here, G, 1e-12, `${what} ${law}`);
      assert.equal(laws[k].tested, G !== null && notes.length === 0, `${what} ${law}`);
      if (G !== null) close(laws[k].path[1][1], G, 1e-12, `${what} ${law}, the middle of its line`);
    });
    // The line of the picture: other pressures, of the same command.
    const path = sandPath(granum, known, 3), G = granumJson(...typed(sameSand.commandLine({ ...known, pressure: known.pressure * 10 }))).answer.shear_modulus;
    for (const part of ["value", "low", "high"]) {
      close(path[1][part], ours.rows.shear_modulus[part], 1e-12, `${what} ${part}`);
      close(path[2][part], G[part], 1e-12, `${what} ${part}, ten times the pressure`);
    }
  }
  assert.ok(sandLaws(granum, sandsAsked.at(-1), 3).some(({ here }) => Number.isNaN(here)), "a law ends before this void ratio");
});

test("a forecast for a sand equals that of the shown command to 1e-12, its errors to 1e-9", async () => {
  const granum = await startModule();
  for (const known of sandsInferred) {
    const ours = sandInferenceOf(granum, known), what = JSON.stringify(known), native = granumJson(...typed(sameSandInference.commandLine(known))).sand;
    const same = (number, theirs, name) => {
      close(number.value, theirs.value, 1e-12, `${what} ${name}`);
      close(number.error, theirs.standard_error, 1e-9, `${what} error of ${name}`); // by numerical derivatives
    };
    same(ours.level, native.level, "level");
    same(ours.exponent, native.stress_exponent, "s");
    same(ours.poissonRatio, native.poisson_ratio, "Poisson's ratio");
    for (const [mine, theirs] of [["z", "mechanical_coordination_number"], ["softness", "contact_softness"]]) {
      close(ours[mine].value, native[theirs].value, 1e-9, `${what} ${mine}`); // solved to 1e-10
      for (const part of ["low", "high"]) close(ours[mine][part], native[theirs][part], 1e-7, `${what} ${mine} ${part}`);
    }
    for (const [mine, theirs] of [["G", "G"], ["V_s", "V_s"], ["V_p", "V_p"]]) same(ours.there[mine], native.predictions[0][theirs], `${theirs} elsewhere`);
    assert.equal(ours.tellsContacts, native.tells_contacts);
    const path = inferredPath(granum, known, known.pressure, known.otherPressure, 3);
    for (const part of ["value", "error"]) close(path.at(-1)[part], ours.there[known.quantity][part], 1e-9, `the path's last ${part}`);
  }
  assert.match(sandInferenceOf(granum, { ...sandsInferred[0], value: 1500 }).notes.join(), /cemented/);
  assert.throws(() => sandInferenceOf(granum, { ...sandsInferred[0], value: -1 }), /V_s = -1/);
  assert.throws(() => inferredPath(granum, sandsInferred[0], 1e5, 2e5, 3), /nothing was inferred/);
  for (const [change, message] of [[{ voidRatio: 3.2 }, /void_ratio = 3\.2/], [{ uniformity: 0.5 }, /uniformity = 0\.5/], [{ strain: 0.2 }, /strain = 0\.2/],
    [{ leastVoidRatio: 0.9, largestVoidRatio: 0.5 }, /largest_void_ratio = 0\.5/], [{ densityBy: "relativeDensity", sand: "toyoura", relativeDensity: 1.4 }, /relative_density = 1\.4/]])
    assert.throws(() => sandAnswerOf(granum, { ...sandsAsked[0], ...change }), message);
});

test("likely mistakes give the warnings of the program, and correct numbers none", async () => {
  const granum = await startModule();
  for (const known of asked) assert.deepEqual(slipsOf(granum, known), [], JSON.stringify(known));
  for (const known of sandsAsked) assert.deepEqual(sandSlipsOf(granum, known), [], JSON.stringify(known));
  for (const change of [{ voidRatio: 0.38 }, { pressure: 50 }, { stressRatio: 0.5, pressure: 60 }, { density: 2.48 }]) {
    const known = { ...sandsAsked[0], ...change }, ours = sandSlipsOf(granum, known);
    assert.ok(ours.length > 0, JSON.stringify(change));
    const { stderr } = spawnSync(program, typed(sameSand.commandLine(known)), { encoding: "utf8" });
    for (const slip of ours) assert.ok(stderr.includes(slip), `${slip} is not in ${stderr}`);
  }
  assert.deepEqual(sandSlipsOf(granum, { ...sandsAsked[1], voidRatio: 0.38 }), [], "grains of several sizes can be so dense");
  const slips = [{ voidRatio: 0.38 }, { voidRatio: 0.05 }, { pressure: 50 }, { pressure: 5e8 }, { stressRatio: 0.5, pressure: 60 }, { radius: 0.3 }, { grainModulus: 26e3 }, { density: 2.48 }, { z: 9 }];
  for (const change of slips) {
    const known = { ...asked[0], ...change }, ours = slipsOf(granum, known);
    assert.ok(ours.length > 0, JSON.stringify(change));
    const { stderr } = spawnSync(program, typed(sameAnswer.commandLine(known)), { encoding: "utf8" });
    for (const slip of ours) assert.ok(stderr.includes(slip), `${slip} is not in ${stderr}`);
  }
});

test("every rung of the ladder equals the native one to 1e-12", async () => {
  const granum = await startModule();
  for (const known of asked) {
    const answer = answerOf(granum, known), ladder = ladderOf(granum, known, answer);
    assert.deepEqual(ladder.map((rung) => rung.label), ["rung 0", "rung 1", "rung 2", "rung 3", "uniform-stress"]);
    const native = granumJson(...typed(sameAnswer.commandLine({ ...known, z: answer.rows.mechanical_coordination_number.value })), "--coordination-number", answer.rows.coordination_number.value);
    for (const [place, name] of [[2, "uniform_strain"], [3, "relaxed"], [4, "uniform_stress"]])
      close(ladder[place].value, found(native, name).G_vh, 1e-12, `${JSON.stringify(known)} ${name}`);
    assert.ok(ladder[3].error > 0 && ladder[3].error < 0.5, "rung 3 states its error");
    assert.ok(Number.isNaN(ladder[0].error));
    // Without fabric and with equal stresses the first three rungs are one.
    if (known.stressRatio === 1 && known.anisotropy === 0) for (const rung of [0, 1]) close(ladder[rung].value, ladder[2].value, 1e-9, "rungs 0 to 2");
    else assert.ok(Math.abs(ladder[0].value / ladder[2].value - 1) > 1e-3, "rung 2 knows of directions");
  }
});

test("contacts inferred from a measurement, and predictions, equal the native ones to 1e-9", async () => {
  const granum = await startModule();
  for (const known of inferred) {
    const ours = inferenceOf(granum, known), native = granumJson(...typed(sameInference.commandLine(known)));
    const name = JSON.stringify(known);
    const same = (number, theirs, what) => {
      close(number.value, theirs.value, 1e-9, `${name} ${what}`);
      close(number.error, theirs.standard_error, 1e-6, `${name} error of ${what}`); // by numerical derivatives
    };
    assert.ok(ours.explained);
    const packing = native.answer;
    same(ours.z, packing.mechanical_coordination_number, "z*");
    same(ours.contacts, packing.coordination_number, "C_n");
    const there = native.predictions[0];
    for (const [mine, theirs] of [["G", "G"], ["V_s", "V_s"], ["V_p", "V_p"]]) same(ours.there[mine], there[theirs], `${theirs} elsewhere`);
    assert.ok(Math.abs(ours.shares.reduce((sum, { share }) => sum + share, 0) - 1) < 1e-9);
  }
  for (const known of inferred) {
    const { there } = inferenceOf(granum, known), path = inferredPath(granum, known, known.pressure, known.otherPressure, 3);
    for (const part of ["value", "error"]) close(path.at(-1)[part], there[known.quantity][part], 1e-9, `the path's last ${part}`);
    close(path[0].value, known.value, 1e-6, "the path where it was measured");
  }
  assert.equal(inferenceOf(granum, { ...inferred[0], value: 5000 }).explained, false);
  assert.throws(() => inferredPath(granum, inferred[0], 1e5, 2e5, 3), /nothing was inferred/);
});

/// What a program prints, as numbers.
const printed = (command, args, options) => execFileSync(command, args, { encoding: "utf8", ...options }).trim().split(/\s+/).map(Number);
const build = path.dirname(program);
const sandInferredNumbers = ({ level, there }) => [level.value, level.error, there.G.value, there.G.error];
const inferredNumbers = ({ z, there }) => [z.value, z.error, there.G.value, there.G.error];

const pythonPackage = path.join(build, "python/granum");
const pythonBuilt = fs.existsSync(pythonPackage) && fs.readdirSync(pythonPackage).some((name) => name.endsWith(".so"));
test("the lines in Python run, and print the page's numbers", { skip: !pythonBuilt && "no package of Python was built" }, async () => {
  const granum = await startModule();
  // The interpreter that the package was built for.
  const [, python] = fs.readFileSync(path.join(build, "CMakeCache.txt"), "utf8").match(/^_Python_EXECUTABLE:INTERNAL=(.+)$/m);
  const run = (lines) => printed(python, ["-c", lines], { env: { ...process.env, PYTHONPATH: path.join(build, "python") } });
  for (const known of asked) {
    const { value, low, high } = answerOf(granum, known).rows.shear_modulus;
    run(sameAnswer.python(known)).forEach((number, k) => close(number, [value, low, high][k], 1e-12, `${JSON.stringify(known)}, number ${k}`));
  }
  for (const known of sandsAsked) {
    const { value, low, high } = sandAnswerOf(granum, known).rows.shear_modulus;
    run(sameSand.python(known)).forEach((number, k) => close(number, [value, low, high][k], 1e-12, `${JSON.stringify(known)}, number ${k}`));
  }
  for (const known of sandsInferred)
    run(sameSandInference.python(known)).forEach((number, k) => close(number, sandInferredNumbers(sandInferenceOf(granum, known))[k], k % 2 ? 1e-9 : 1e-12, `${JSON.stringify(known)}, number ${k}`));
  for (const known of inferred)
    run(sameInference.python(known)).forEach((number, k) => close(number, inferredNumbers(inferenceOf(granum, known))[k], k % 2 ? 1e-6 : 1e-9, `${JSON.stringify(known)}, number ${k}`));
});

test("the lines in C++ compile, run, and print the page's numbers", async () => {
  const granum = await startModule();
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "granum-page-"));
  try {
    const run = (lines, name) => {
      const source = path.join(folder, `${name}.cpp`), made = path.join(folder, name);
      fs.writeFileSync(source, lines);
      const library = (part) => path.join(build, "src", `libgranum_${part}.a`);
      execFileSync("g++", ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-I", path.join(root, "include"), "-isystem", "/usr/include/eigen3", source, "-o", made,
        library("fit"), library("theory"), "-lgsl", "-lgslcblas"]);
      return printed(made, []);
    };
    for (const known of [asked[2], asked[6]]) {
      const { value, low, high } = answerOf(granum, known).rows.shear_modulus;
      run(sameAnswer.cpp(known), `answer${known.z}`).forEach((number, k) => close(number, [value, low, high][k], 1e-12, `${JSON.stringify(known)}, number ${k}`));
    }
    for (const known of [sandsAsked[3], sandsAsked[5], sandsAsked[6]]) {
      const { value, low, high } = sandAnswerOf(granum, known).rows.shear_modulus;
      run(sameSand.cpp(known), `sand${known.sand}`).forEach((number, k) => close(number, [value, low, high][k], 1e-12, `${JSON.stringify(known)}, number ${k}`));
    }
    run(sameSandInference.cpp(sandsInferred[1]), "forecast").forEach((number, k) => close(number, sandInferredNumbers(sandInferenceOf(granum, sandsInferred[1]))[k], k % 2 ? 1e-9 : 1e-12, `number ${k}`));
    run(sameInference.cpp(inferred[2]), "inference").forEach((number, k) => close(number, inferredNumbers(inferenceOf(granum, inferred[2]))[k], k % 2 ? 1e-6 : 1e-9, `number ${k}`));
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
});

test("errors have granum's messages, and the module continues", async () => {
  const granum = await startModule();
  const packing = { voidRatio: 0.6, coordinationNumber: 5.7, stressV: 1e5 };
  const before = granum.closedForms(grain, packing);
  assert.throws(() => granum.closedForms({ ...grain, poissonRatio: 0.6 }, packing), /grain_poisson_ratio = 0.6/);
  assert.deepEqual(granum.closedForms(grain, packing), before);
  assert.throws(() => granum.call("experiment_shear"), /the experiment has not begun/);
  granum.call("experiment_begin", 1, grain.shearModulus, grain.poissonRatio, grain.radius, NaN, NaN, grain.frictionAngle, 0, 0, 200, 1, 1e4);
  assert.throws(() => granum.call("experiment_shear_begin", 0.01), /sheared only after its compression/);
});

for (const density of ["dense", "loose"])
  test(`the experiment, ${density}: the same bits twice, and s of the native program`, async () => {
    const loose = density === "loose";
    const once = await experiment(loose, 1);
    assert.deepEqual(await experiment(loose, 1), once);
    assert.notDeepEqual((await experiment(loose, 2)).rows, once.rows);
    assert.ok(once.rows.every((row) => row[18] === 1), "not at rest");
    const out = fs.mkdtempSync(path.join(os.tmpdir(), "granum-page-"));
    try {
      const native = granumJson("verify", ...["contacts=sphere", `densities=${density}`, "grains=300", `pressures=${pressures.map((p) => `${p / 1e3}kPa`)}`,
        "probe_pressures=100kPa"].flatMap((setting) => ["--set", `study.${setting}`]), "--out", path.join(out, "verify"));
      const s = native.exponents[0].network;
      console.log(`${density}: s ${once.s} +- ${once.error}, native ${s.value} +- ${s.standard_error}`);
      const betweenSpecimens = { dense: 0.0017, loose: 0.0198 }[density] * Math.sqrt(1000 / 300); // seed_mean.cpp
      assert.ok(once.error >= betweenSpecimens * (1 - 1e-12), `error ${once.error}`);
      // Last digits of logarithms and powers differ; loose grains then go other ways, so that these are two specimens.
      assert.ok(Math.abs(once.s - s.value) < 3 * Math.hypot(once.error, s.standard_error), `s ${once.s}, native ${s.value}`);
    } finally {
      fs.rmSync(out, { recursive: true });
    }
  });

/// The curve of triaxial compression after compression through all pressures: its points.
async function sheared(loose, seed, largestStrain) {
  const granum = await prepared(loose, seed);
  for (const pressure of pressures) granum.call("experiment_compress", pressure);
  granum.call("experiment_shear_begin", largestStrain);
  const points = [];
  do points.push(shearPoint(granum.call("experiment_shear").numbers));
  while (points.at(-1).event === 0);
  return points;
}

/// A column over axial strain, at a strain: between the points on either side.
function at(rows, strain) {
  const k = rows.findIndex(([x]) => x >= strain);
  const [[x0, y0], [x1, y1]] = [rows[k - 1], rows[k]];
  return y0 + ((y1 - y0) * (strain - x0)) / (x1 - x0);
}

test("shear: the same bits twice, stresses of the path, and work as stress times strain", async () => {
  for (const loose of [false, true]) {
    const points = await sheared(loose, 1, 0.01), last = points.at(-1);
    assert.deepEqual(await sheared(loose, 1, 0.01), points);
    assert.equal(last.event, 1);
    assert.ok(last.axialStrain >= 0.01);
    assert.ok(last.pathError < 0.1, `sigma_h strays by ${last.pathError}`);
    let work = 0, before = { axialStrain: 0, volumetricStrain: 0, stressV: 1e5, stressH: 1e5 };
    for (const point of points) {
      close(point.deviator, point.stressV - point.stressH, 1e-12, "q");
      close(point.ratio, (3 * point.deviator) / (point.stressV + 2 * point.stressH), 1e-12, "eta");
      const mean = (name) => (point[name] + before[name]) / 2, step = (name) => point[name] - before[name];
      work += mean("stressV") * step("axialStrain") + mean("stressH") * (step("volumetricStrain") - step("axialStrain"));
      before = point;
    }
    close(last.work, work, 0.05, "work"); // of the volume at the start, and between points by straight lines
    close(Math.sin(last.peakAngle), last.peakDeviator / (last.peakDeviator + 2e5), 0.05, "friction angle at sigma_h = 100 kPa");
    assert.equal(last.peakRatio, Math.max(...points.map((point) => point.peakRatio)));
    assert.ok(loose ? points.at(-1).deviator > 0 : last.volumetricStrain < 0, "a dense packing dilates");
  }
});

test("shear: the curve of the native program on the same specimens", async () => {
  const strains = [2e-5, 5e-5, 1e-4, 2e-4, 4e-4]; // q near its peak then
  const out = fs.mkdtempSync(path.join(os.tmpdir(), "granum-page-"));
  try {
    const worst = [];
    for (const seed of [1, 2, 3]) {
      const folder = path.join(out, `seed${seed}`);
      granumJson("reproduce", ...["study.contacts=sphere", "study.densities=dense", "study.grains=300", `study.first_seed=${seed}`,
        `study.pressures=${pressures.map((p) => `${p / 1e3}kPa`)}`, "study.probe_pressures=", "shear.paths=TXC", "shear.probe_eta_step=0", "shear.loop_strain=0",
        "shear.largest_strain=0.01"].flatMap((setting) => ["--set", setting]), "--out", folder);
      const native = (figure) => fs.readFileSync(path.join(folder, "figures", `${figure}_sphere_dense.csv`), "utf8").trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
      const points = await sheared(false, seed, 0.01);
      const page = (name) => [[0, 0], ...points.map((point) => [point.axialStrain, point[name]])];
      const largest = (name, figure) => Math.max(...strains.map((strain) => Math.abs(at(page(name), strain) - at(native(figure), strain))));
      worst.push([largest("ratio", "fig06"), largest("volumetricStrain", "fig07")]);
    }
    console.log(`differences of eta and volumetric strain, by seed: ${worst.map((pair) => pair.map((number) => number.toExponential(1)).join(" ")).join(", ")}`);
    // Powers and logarithms differ in their last digit. Most dense specimens forget it, some take another way.
    const middle = (k) => worst.map((pair) => pair[k]).sort((a, b) => a - b)[1];
    assert.ok(middle(0) < 1e-3 && middle(1) < 1e-6, "the engine shears in another way than the native one");
    for (const [ratio, volume] of worst) assert.ok(ratio < 0.05 && volume < 2e-5, "a specimen differs by more than specimens scatter");
  } finally {
    fs.rmSync(out, { recursive: true });
  }
});
