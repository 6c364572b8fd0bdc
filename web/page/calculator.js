// SPDX-License-Identifier: GPL-3.0-or-later
// The calculator: the best estimate for a packing, with its range and the ladder; and the contacts inferred from a
// measurement, with predictions for another pressure.
"use strict";

const preparations = ["unknown", "dense", "loose"];

const grainKinds = ["sphere", "sand"];

/// Inputs: key, unit in SI, least, most, start; NaN if not given.
const calculatorInputs = {
  voidRatio: [1, 0.2, 3, 0.6], relativeDensity: [0.01, 0, 120, 60], uniformity: [1, 1, 1000, NaN], leastVoidRatio: [1, 0.1, 3, NaN], largestVoidRatio: [1, 0.1, 3, NaN],
  pressure: [1e3, 0.001, 1e6, 100], stressRatio: [1, 0.2, 5, 1], anisotropy: [1, -0.6, 0.6, 0],
  grainModulus: [1e9, 1e-3, 1e4, 30], poissonRatio: [1, -0.9, 0.5, 0.15], radius: [1e-3, 1e-6, 1e4, 0.5], density: [1, 1, 3e4, 2650],
  saturation: [0.01, 0, 100, 0], z: [1, 0, 12, NaN], strain: [0.01, 1e-5, 5, NaN],
};
const inferenceInputs = { value: [1, 1e-6, 1e6, 280], error: [0.01, 0, 50, 2], otherPressure: [1e3, 0.001, 1e6, 400] };

const grainNumbersOf = (known) => grainNumbers({ ...defaultGrain, shearModulus: known.grainModulus, poissonRatio: known.poissonRatio, radius: known.radius });
/// Choices and inputs that only one kind of grains has, or that one needs; of a sand, not all at once.
const ofSpheres = ["anisotropy", "grainModulus", "poissonRatio", "radius", "z", "preparation"];
function ofSand(known) {
  if (isNamed(known)) return ["sand", "densityBy", known.densityBy, "strain"];
  return ["sand", "densityBy", known.densityBy, ...sandNumbers, "strain"];
}
const ofBoth = ["grains", "pressure", "stressRatio", "density", "saturation"];
const isSand = (known) => known.grains === "sand";
/// All choices and inputs that the answer uses.
const inUse = (known) => [...ofBoth, ...(isSand(known) ? ofSand(known) : ["voidRatio", ...ofSpheres])];
/// The inputs without which there is no answer.
function needed(known) {
  const limits = isSand(known) && byRelativeDensity(known) ? ["leastVoidRatio", "largestVoidRatio"] : [];
  return inUse(known).filter((key) => key in calculatorInputs && (!Number.isNaN(calculatorInputs[key][3]) || limits.includes(key)));
}
/// The same for an inference: all stresses are equal, and the pores dry.
const neededToInfer = (known) => [...needed(known).filter((key) => !["stressRatio", "anisotropy", "saturation"].includes(key)), ...Object.keys(inferenceInputs)];

const rowsOf = (numbers) => Array.from({ length: numbers.length / 3 }, (_, k) => ({ value: numbers[3 * k], low: numbers[3 * k + 1], high: numbers[3 * k + 2] }));
const sharesOf = (numbers, notes) => numbers.map((share, k) => ({ input: notes[k], share }));

/// An answer of granum: {rows: {key: {value, low, high}}, shares: [{input, share}], notes}; keys are those of granum's JSON, and a number
/// that does not exist for the packing has no row.
function readAnswer(granum, { numbers, notes }) {
  const keys = granum.call("answer_keys").notes;
  const rows = Object.fromEntries(rowsOf(numbers.slice(0, 3 * keys.length)).map((row, k) => [keys[k], row]).filter(([, { value }]) => Number.isFinite(value)));
  const shares = sharesOf(numbers.slice(3 * keys.length), notes);
  return { rows, shares, notes: notes.slice(shares.length) };
}

/// A number that is as it was at the start, and was not typed, is not given: granum assumes it, with the deviation of that.
const isAssumed = (known, key) => !known.typed?.has(key) && known[key] === calculatorInputs[key][3] * calculatorInputs[key][0];
const givenOr = (known, key) => (isAssumed(known, key) ? NaN : known[key]);
function answerOf(granum, known) {
  const [shape, , , ...grain] = grainNumbersOf(known);
  return readAnswer(granum, granum.call("answer", shape, givenOr(known, "grainModulus"), givenOr(known, "poissonRatio"), ...grain, known.voidRatio, givenOr(known, "anisotropy"),
    ...stressesOf(known), preparations.indexOf(known.preparation), known.z, givenOr(known, "density"), known.saturation));
}

/// Likely mistakes in unit or symbol, as reported by the program with the names of its options.
function slipsOf(granum, known) {
  return granum.call("slips", ...grainNumbersOf(known), known.voidRatio, 0, ...stressesOf(known), known.z, known.density).notes;
}

/// G_vh of every closed form at the contacts of an answer: [{label, value, error}], error relative or not a number.
function ladderOf(granum, known, answer) {
  const { mechanical_coordination_number: z, coordination_number: contacts } = answer.rows;
  const { numbers, notes } = granum.call("ladder", ...grainNumbersOf(known), known.voidRatio, known.anisotropy, ...stressesOf(known), contacts.value, z.value);
  return notes.map((label, k) => ({ label, value: numbers[2 * k], error: numbers[2 * k + 1] }));
}

/// The measured quantity of the last inference of these grains, from one pressure to another: [{pressure, value, error}]
function inferredPath(granum, known, low, high, points) {
  const { numbers } = granum.call(isSand(known) ? "inferred_sand_path" : "inferred_path", measurable[known.quantity].place, low, high, points);
  return Array.from({ length: points }, (_, k) => ({ pressure: numbers[3 * k], value: numbers[3 * k + 1], error: numbers[3 * k + 2] }));
}

/// {explained, z, contacts, there: {z, voidRatio, G, V_s, V_p}, shares, notes}; each {value, error} but the void ratio.
function inferenceOf(granum, known) {
  const { numbers, notes } = granum.call("infer", ...grainNumbersOf(known), known.voidRatio, known.pressure, known.density, measurable[known.quantity].place,
    known.value, known.error, known.otherPressure);
  if (numbers[0] === 0) return { explained: false, notes };
  const [z, contacts, zThere] = [1, 3, 5].map((k) => ({ value: numbers[k], error: numbers[k + 1] }));
  const [G, V_s, V_p] = [8, 10, 12].map((k) => ({ value: numbers[k], error: numbers[k + 1] }));
  const shares = sharesOf(numbers.slice(14), notes);
  return { explained: true, z, contacts, there: { z: zThere, voidRatio: numbers[7], G, V_s, V_p }, shares, notes: notes.slice(shares.length) };
}
