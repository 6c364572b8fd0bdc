// SPDX-License-Identifier: GPL-3.0-or-later
// Each number in the words of lesson, notes and sheet is computed. A number without a row here fails, in every language.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { before, test } from "node:test";
import { close, experiment, grain, granumJson, root, startModule, texts } from "./native.mjs";

const folder = path.join(root, "web/page/texts");
const languages = fs.readdirSync(folder).map((file) => [file, JSON.parse(fs.readFileSync(path.join(folder, file), "utf8"))]);
const paragraphs = (text, place = "") => (typeof text === "string" ? [[place, text]]
  : Object.entries(text).flatMap(([key, inner]) => paragraphs(inner, place ? `${place}.${key}` : key)));
/// Numbers of a text: neither those that the page fills in, nor those of exponents in alpha, which are formulas.
const numbersIn = (text) => text.replace(/\{\w{2,}\}|\{z\d\}/g, "").replace(/1\/\(1\+α\)|1\+1\/α|1\/α|\{1\}\/\{1\+α\}|α\/\(1\+α\)|u_0|2a/g, "")
  .match(/\d+(?:[.,]\d+)?(?:\/\d+)?/g)?.map((number) => number.replace(",", ".")) ?? [];

let granum, dense, loose, verify;
before(async () => {
  granum = await startModule();
  [dense, loose] = await Promise.all([experiment(false, 1), experiment(true, 1)]);
  verify = granumJson("verify", ..."contacts=sphere densities=dense grains=100 pressures=25kPa,50kPa,100kPa probe_pressures=100kPa".split(" ").flatMap((setting) => ["--set", `study.${setting}`]));
});

const near = (value, wanted, apart, what = "it") => assert.ok(Math.abs(value - wanted) <= apart, `${what} is ${wanted}, not ${value}`);
const value = (text) => text.split("/").reduce((a, b) => a / b);
/// What a number may be, each a function of its text.
const is = (wanted, apart = 1e-9) => (text) => near(value(text), typeof wanted === "function" ? wanted() : wanted, apart);
const step = (name) => (text) => assert.ok(texts.steps[text - 1].title.match(name), `step ${text} is another one`);
const curve = (shape) => granum.contactCurve({ ...grain, shape }, 1e-6, 2);
/// The exponent of force over overlap, between two overlaps.
const forceExponent = (shape) => () => Math.log2(curve(shape).points[1].force / curve(shape).points[0].force);
/// s of uniform strain with contacts of a shape.
const sOf = (shape, stressV = 1e5, numbers = {}) => granum.closedForms({ ...grain, shape, numbers }, { voidRatio: 0.6, coordinationNumber: 5.7, stressV }).uniformStrain.exponent;
const roughLimit = (stress) => () => sOf("rough", stress, { roughness: 1e-7 });
const change = (roughness, radius = grain.radius) => granum.closedForms({ ...grain, radius, shape: "rough", numbers: { roughness } }, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: 1e5 }).transitionPressure;
const lesson = fs.readFileSync(path.join(root, "web/page/lesson.js"), "utf8");
const inScript = (pattern, unit = 1) => is(() => Number(lesson.match(pattern)[1]) * unit);
const shearScript = fs.readFileSync(path.join(root, "web/page/shear.js"), "utf8");
const experimentScript = fs.readFileSync(path.join(root, "web/page/runs.js"), "utf8").match(/experimentPressures = \[([^\]]*)\]/)[1].split(",").map(Number);
const [first, last] = [is(experimentScript[0]), is(experimentScript.at(-1))];
const chance = (deviations) => { // of a normal distribution, within so many deviations
  let sum = 0;
  for (let k = 0; k < 1000; ++k) sum += Math.exp(-0.5 * (((k + 0.5) / 1000) * deviations) ** 2) * (deviations / 1000);
  return 2 * sum / Math.sqrt(2 * Math.PI);
};

/// What each number of a text is, by its place; a sentence of numbers in words has a function that looks at it all.
const claims = {
  "steps.0.text": [is(forceExponent("sphere"), 1e-3), is(forceExponent("cone"), 1e-3), (text) => asStiffAt(Number(text))],
  "steps.0.guess.answer": [is(() => sOf("sphere"), 1e-6)],
  "steps.2.guess.answer": [is(() => sOf("sphere"), 1e-6)],
  "steps.3.guess.question": [inScript(/this\.form\(granum, grain, ([\d.]+)\)/)],
  "steps.4.guess.question": [inScript(/\[([\d.]+), 6\]\.map\(\(z\) => 100 \* this\.leftAt/)],
  "steps.4.guess.answer": [inScript(/\[4\.1, ([\d.]+)\]\.map\(\(z\) => 100 \* this\.leftAt/)],
  "steps.5.text": [is(() => Number(fs.readFileSync(path.join(root, "include/granum/sands/pooled_law.hpp"), "utf8").match(/(\d+) tests of/)[1])),
    inScript(/\[([\d.]+), 0\.9\]\.map\(\(e\) => written\(sandExponent/), inScript(/\[0\.5, ([\d.]+)\]\.map\(\(e\) => written\(sandExponent/)],
  "steps.5.guess.question": [first, last],
  "steps.6.guess.answer": [is(() => Math.log10(change(1e-6) / change(1e-7)))],
  "steps.2.text": [is(() => sOf("cone"), 1e-6), is(() => sOf("sphere"), 1e-6), is(() => sOf("flat"), 1e-6), step(/gain contacts/), step(/Rough/)],
  "steps.2.finding": [inScript(/pressure: \[(\d+),/), inScript(/pressure: \[10, (\d+)/)],
  "steps.5.finding": [inScript(/pressure: (\d+) \* kPa \}, 100 \* kPa/), inScript(/\}, (\d+) \* kPa, 12/)],
  "steps.6.title": [is(roughLimit(1), 2e-3), is(roughLimit(1e10), 2e-3)],
  "steps.6.text": [is(roughLimit(1), 2e-3), is(roughLimit(1e10), 2e-3), is(roughLimit(1), 2e-3), is(roughLimit(1e10), 2e-3),
    is(() => Math.log2(change(2e-7) / change(1e-7))), is(() => 1e3 * grain.radius), is(() => roughShare, 0.01), step(/gain contacts/),
    (text) => assert.ok(sOf("rough", 1e5, { roughness: 5e-8 }) < value(text) && sOf("rough", 1e5, { roughness: 3e-7 }) > value(text) && sOf("cone") >= value(text) - 1e-6 && loose.s > value(text), "all can give it")],
  "steps.6.finding": [is(1), is(100), is(10)].map((_, k) => (text) => assert.match(lesson, [/s\(at\.roughness, 1\)/, /s\(at\.roughness, 100\)/, /s\(at\.roughness, 1e4\)/][k], text)),
  "experiment.text": [first, last, is(() => Number(fs.readFileSync(path.join(root, "web/page/experiment.js"), "utf8").match(/paperSixGrains = (\d+)/)[1]))],
  "experiment.narrow": [is(0.2)],
  "experiment.wide": [is(0.35)],
  "shear.text": [is(() => 100 * Number(shearScript.match(/beginningOfShear = ([\d.]+)/)[1]))],
  "notes.text": [step(/power of pressure/)],
  "notes.planTitle": [is(() => texts.notes.plan.reduce((sum, part) => sum + Number(part.match(/^\d+/)[0]), 0))],
  "notes.plan.0": [is(5)],
  "notes.plan.1": [is(10), step(/^A contact/), step(/power of pressure/)],
  "notes.plan.2": [is(5), step(/relax/), step(/gain contacts/), step(/Rough/)],
  "notes.plan.3": [is(15)],
  "notes.plan.4": [is(10)],
  "notes.questions.0.0": [is(() => sOf("flat"))],
  "notes.questions.1.0": [is(() => sands().reduce((sum, s) => sum + s / 2, 0), 0.05)],
  "notes.questions.1.1": [is(() => sOf("cone"), 1e-6), step(/Rough/), is(roughLimit(1), 2e-3), is(roughLimit(1e10), 2e-3), step(/gain contacts/)],
  "notes.questions.2.1": [is(() => dense.rows[0][3], 0.05), is(() => loose.rows[0][3], 0.05), first],
  "notes.questions.3.0": [is(1), is(2)],
  "notes.questions.4.0": [is(() => dense.s, 0.01), is(() => ofTable("verify_default", /\| sphere, dense \|(?:[^|]*\|){2} ([\d.]+)/)), is(() => verify.exponents[0].paper), is(() => sOf("sphere"), 1e-6)],
  "notes.questions.4.1": [is(() => sOf("sphere"), 1e-6), first, last, is(() => sOf("sphere"), 1e-6)],
  "notes.questions.5.1": [(text) => assert.ok(granum.call("ladder", 1, grain.shearModulus, grain.poissonRatio, grain.radius, NaN, NaN, 0.6, 0, 1e5, 1e5, 5.7, 5.8).notes.includes(`rung ${text}`))],
  "sheet.answersText": [is(1000)],
  "sheet.print": [is(2)],
  "sheet.predict": [is(1)], "sheet.measure": [is(2)], "sheet.seeds": [is(3)], "sheet.compare": [is(4)],
  "sheet.questions.4": [is(0.5)],
  "sheet.answers.0": [is(2)],
  "sheet.answers.1": [is(() => curve("cone").alpha), is(() => sOf("cone"), 1e-6)],
};
/// Numbers in words: where they are, the words, and what holds then.
const worded = [
  ["notes.questions.2.1", /factor of about four/, () => near(dense.rows[0][7] / loose.rows[0][7], 4, 0.5, "G of dense over that of loose")],
  ["notes.questions.2.1", /nearly the same e/, () => near(dense.rows[0][1], loose.rows[0][1], 0.01, "e")],
  ["notes.questions.4.1", /some thousandths/, () => near(granum.call("exponent_scatter", 1, 0, 600).numbers[0], 0.003, 0.002, "the scatter of s")],
  ["sheet.answers.3", /Two in three .* nineteen in twenty .* two/, () => [[1, 2 / 3], [2, 19 / 20]].forEach(([deviations, share]) => near(chance(deviations), share, 0.02, "the share"))],
  ["steps.6.text", /s is halfway from 1 to 1\/3/, () => near(sOf("rough", change(1e-7), { roughness: 1e-7 }), 2 / 3, 0.05, "s at p*")],
  ["steps.6.sketch", /a thirtieth of p\* and at thirty times/, () => inScript(/apart: (\d+)/)("30")],
  ["steps.5.text", /Sands are different/, () => near(granum.call("sand_answer", -1, NaN, NaN, NaN, 0.5, 1e5, 1e5, 2650, 0, NaN).numbers[sandS()], granum.call("sand_answer", -1, NaN, NaN, NaN, 0.9, 1e5, 1e5, 2650, 0, NaN).numbers[sandS()], 1e-12, "s of loose sand")],
  ["steps.5.guess.answer", /s is \{loose\} for the loose/, () => assert.ok(loose.s > dense.s + 2 * loose.error)],
  ["steps.3.guess.question", /Vertical contacts prevail/, () => { const { vh, hh } = granum.closedForms(grain, { voidRatio: 0.6, coordinationNumber: 5.7, anisotropy: 0.3, stressV: 1e5 }).uniformStrain; assert.ok(vh > hh); }],
  ["shear.text", /void ratios are nearly the same/, () => near(dense.rows.at(-1)[1], loose.rows.at(-1)[1], 0.01, "e")],
  ["notes.questions.4.1", /one of each kind unless/, () => assert.match(fs.readFileSync(path.join(root, "src/studies/scene/scene.hpp"), "utf8"), /grains = 1000;\s+std::size_t seeds = 1;/)],
  ["sheet.answersText", /1000 grains/, () => assert.match(fs.readFileSync(path.join(root, "src/studies/verify/seed_mean.cpp"), "utf8"), /measured_grains = 1000/)],
  ["steps.6.text", /many decades/, () => assert.ok(sOf("rough", 1e4, { roughness: 1e-7 }) > 0.7 && sOf("rough", 1e6, { roughness: 1e-7 }) < 0.45 && sOf("rough", 1e3, { roughness: 1e-7 }) < 0.99)],
];

/// The place of s among the values of an answer.
const sandS = () => 3 * granum.call("answer_keys").notes.indexOf("stress_exponent");
const sands = () => granum.call("sand_exponents").numbers;
/// A number of the table of results in a folder of validation.
const ofTable = (name, row) => Number(fs.readFileSync(path.join(root, "validation", name, "README.md"), "utf8").match(row)[1]);
/// u0 over the rms height of both surfaces, as the library's own help has it.
const roughShare = Number(fs.readFileSync(path.join(root, "src/contact/laws.cpp"), "utf8").match(/([\d.]+) times the combined rms height/)[1]);

/// Shapes are as stiff as spheres at the force that the first step names.
function asStiffAt(force) {
  const stiffnessAt = (shape, numbers) => granum.contactCurve({ ...grain, shape, numbers }, 2e-6, 4000).points.find((point) => point.force >= force).stiffness;
  for (const [shape, place, key, start] of [["cone", 0, "cone_slope", 0.4], ["flat", 2, "punch_radius", 5.7e-6]]) {
    const [number] = granum.call("law_as_stiff", place, grain.shearModulus, grain.poissonRatio, grain.radius, start, NaN, force).numbers;
    close(stiffnessAt(shape, { [key]: number }), stiffnessAt("sphere", {}), 2e-3, shape);
  }
}

const parts = ["question", "intro", "steps", "experiment", "shear", "notes", "sheet"];
for (const [file, all] of languages)
  test(`each number in the words of ${file} is computed`, () => {
    let count = 0;
    for (const [place, text] of parts.flatMap((part) => paragraphs(all[part], part))) {
      const numbers = numbersIn(text), known = claims[place] ?? [];
      assert.equal(numbers.length, known.length, `${place} has the numbers ${numbers.join(", ")}`);
      known.forEach((check, k) => {
        try {
          check(numbers[k]);
        } catch (error) {
          error.message = `${place}, number ${k + 1}, "${numbers[k]}": ${error.message}`;
          throw error;
        }
      });
      count += numbers.length;
    }
    assert.ok(count > 50, `${count} numbers`);
    for (const [place, words, check] of worded) {
      if (file === "en.json") assert.match(paragraphs(all).find(([name]) => name === place)[1], words);
      check();
    }
  });

test("step 6 and the experiment agree, and the line of s goes through the points", () => {
  // The same e and rattlers, contacts predicted or counted.
  const specimens = [...lesson.matchAll(/voidRatio: ([\d.]+), mechanicalCoordinationNumber: ([\w.]+), rattlerFraction: ([\d.]+)/g)];
  assert.equal(specimens.length, 2);
  for (const [k, specimen] of [dense, loose].entries()) {
    const [e, z, rattlers] = specimens[k].slice(1).map(Number), counted = specimen.rows[0];
    assert.ok(Math.abs(counted[1] - e) < 0.005 && Math.abs(counted[4] - rattlers) < 0.02 && !(Math.abs(counted[3] - z) > 0.1), `the specimen has ${counted}`);
    const { states, slope } = granum.carriedPath(grain, { voidRatio: e, mechanicalCoordinationNumber: counted[3], rattlerFraction: rattlers, pressure: 1e4 }, 1e5, 12);
    near(states.at(-1).z, specimen.rows.at(-1)[3], 0.1, "z* at the last pressure");
    // The formula's own slope, for dense packings smaller by two hundredths.
    assert.ok(Math.abs(slope.relaxed - specimen.s) < 2 * specimen.error + (specimen === dense ? 0.02 : 0), `step 6 says ${slope.relaxed}, the experiment ${specimen.s} +- ${specimen.error}`);
  }
  for (const { rows, s } of [dense, loose]) {
    const [from, to] = [rows[0], rows.at(-1)];
    close(Math.log(to[16] / to[15]) / Math.log(to[0] / from[0]), s, 1e-9, "slope of the line");
    assert.ok(Math.abs(Math.log(to[16] / to[7])) < 0.1 && Math.abs(Math.log(to[15] / from[7])) < 0.1);
    close(to[20], 1 / 3, 1e-12, "exponent of the contact alone");
  }
});

test("s of rough spheres falls from 1 to 1/3, and the transition pressure grows as roughness over radius to the power 3/2", () => {
  let before = 1;
  for (let k = 0; k <= 100; ++k) {
    const s = sOf("rough", 10 ** (10 * (k / 100)), { roughness: 1e-7 });
    assert.ok(s <= before + 1e-12 && s >= 1 / 3, `s ${s} after ${before}`);
    before = s;
  }
  // The line of the picture, by rung 0, is what rung 2 has.
  const line = granum.call("exponent_path", 4, grain.shearModulus, grain.poissonRatio, grain.radius, 1e-7, NaN, 0.6, 5.7, 1e3, 1e7, 5).numbers;
  line.forEach((s, k) => close(s, sOf("rough", 10 ** (3 + k), { roughness: 1e-7 }), 1e-8, `s at 10^${3 + k} Pa`));
  close(change(3e-7) / change(1e-7), 3 ** 1.5, 1e-12, "roughness");
  close(change(1e-7, 1e-3) / change(1e-7, 5e-4), 0.5 ** 1.5, 1e-12, "radius");
  assert.ok(Number.isNaN(granum.closedForms(grain, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: 1e5 }).transitionPressure));
});
