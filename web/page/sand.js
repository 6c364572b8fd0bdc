// SPDX-License-Identifier: GPL-3.0-or-later
// The calculator for sands: its questions to granum, and the equivalent lines on the command line, in Python and in C++. The lines in
// Python and C++ leave out that the modulus of quartz is assumed: the numbers that they print do not depend on it.
"use strict";

/// Sands with a name, granum's table: [{key, name, leastVoidRatio, largestVoidRatio}]
let knownSands = [];
function readKnownSands(granum) {
  const { numbers, notes } = granum.call("known_sands");
  knownSands = notes.map((line, k) => {
    const [key, name] = line.split("\t");
    return { key, name, leastVoidRatio: numbers[2 * k], largestVoidRatio: numbers[2 * k + 1] };
  });
}

/// Numbers of a sand without a name; NaN if not given.
const sandNumbers = ["uniformity", "leastVoidRatio", "largestVoidRatio"];
const isNamed = (known) => known.sand !== "unnamed";
const limitsOf = (known) => (isNamed(known) ? knownSands.find(({ key }) => key === known.sand) : known);
const byRelativeDensity = (known) => known.densityBy === "relativeDensity";
const sandArguments = (known) => [knownSands.findIndex(({ key }) => key === known.sand), ...sandNumbers.map((key) => known[key])];
function sandVoidRatio(granum, known) {
  const { leastVoidRatio, largestVoidRatio } = limitsOf(known);
  return byRelativeDensity(known) ? granum.call("void_ratio", known.relativeDensity, leastVoidRatio, largestVoidRatio).numbers[0] : known.voidRatio;
}

/// As answerOf, for a sand.
const sandAnswerOf = (granum, known) => readAnswer(granum, granum.call("sand_answer", ...sandArguments(known), sandVoidRatio(granum, known), ...stressesOf(known),
  known.density, known.saturation, known.strain));

/// As slipsOf, for a sand.
const sandSlipsOf = (granum, known) => granum.call("slips", ...Array(6).fill(NaN), byRelativeDensity(known) ? NaN : known.voidRatio,
  isNamed(known) || Number.isNaN(known.uniformity) ? 0 : 1, ...stressesOf(known), NaN, known.density).notes;

/// G of the answer over the mean stress, from a tenth of it to ten times: [{pressure, value, low, high}]
function sandPath(granum, known, points) {
  return Array.from({ length: points }, (_, k) => {
    const pressure = known.pressure * 10 ** ((2 * k) / (points - 1) - 1);
    return { pressure, ...sandAnswerOf(granum, { ...known, pressure }).rows.shear_modulus };
  });
}

/// Published laws beside the answer: [{name, here, tested, path: [[pressure, G]]}]; `here` is not a number where the law has no modulus.
function sandLaws(granum, known, points) {
  const voidRatio = sandVoidRatio(granum, known), [place, uniformity] = sandArguments(known), low = known.pressure / 10, high = known.pressure * 10;
  return granum.call("sand_laws").notes.map((name, law) => {
    try {
      const { numbers } = granum.call("sand_law", law, place, uniformity, voidRatio, low, high, points);
      return { name, here: numbers[points], tested: numbers[points + 1] === 1, path: numbers.slice(0, points).map((G, k) => [low * (high / low) ** (k / (points - 1)), G]) };
    } catch (error) {
      if (!(error instanceof GranumError)) throw error;
      return { name, here: NaN, tested: false, path: [] };
    }
  });
}

/// {level, exponent, poissonRatio: {value, error}, z, softness: {value, low, high}, there: {G, V_s, V_p}, tellsContacts, notes}
function sandInferenceOf(granum, known) {
  const { numbers, notes } = granum.call("infer_sand", ...sandArguments(known), sandVoidRatio(granum, known), known.pressure, known.density,
    measurable[known.quantity].place, known.value, known.error, known.otherPressure);
  const [level, exponent, poissonRatio, , , , G, V_s, V_p] = Array.from({ length: 9 }, (_, k) => ({ value: numbers[2 * k], error: numbers[2 * k + 1] }));
  const [z, softness] = rowsOf(numbers.slice(6, 12));
  return { explained: true, level, exponent, poissonRatio, z, softness, there: { G, V_s, V_p }, tellsContacts: numbers[18] === 1, notes };
}

/// What is given of a sand without a name, by option or keyword.
const givenNumbers = (known, names) => (isNamed(known) ? [] : sandNumbers.map((key, k) => [names[k], Number.isFinite(known[key]) ? literal(known[key]) : undefined]));

function commandLineSand(known) {
  return [isNamed(known) ? `--sand ${known.sand}` : "--grain-shape sand",
    byRelativeDensity(known) ? `--relative-density ${inUnit(known.relativeDensity, 0.01)}%` : `--void-ratio ${known.voidRatio}`,
    ...keywords(givenNumbers(known, ["uniformity", "least-void-ratio", "largest-void-ratio"]), "--", " ")];
}

function pythonSand(known) {
  const { leastVoidRatio, largestVoidRatio } = limitsOf(known);
  const voidRatio = byRelativeDensity(known) ? `granum.void_ratio_of_relative_density(relative_density=${literal(known.relativeDensity)}, least_void_ratio=${literal(leastVoidRatio)}, largest_void_ratio=${literal(largestVoidRatio)})` : literal(known.voidRatio);
  return [["law", "granum.sphere(shear_modulus=quartz.shear_modulus, poisson_ratio=quartz.poisson_ratio, radius=0.1e-3)"], ["radius", "0.1e-3"],
    isNamed(known) ? ["sand", `"${known.sand}"`] : ["grain_shape", '"sand"'], ["void_ratio", voidRatio], ...givenNumbers(known, ["uniformity", "least_void_ratio", "largest_void_ratio"])];
}
const pythonBegin = ["import granum", "", 'quartz = granum.minerals()["quartz"]'];

function cppSand(known, stresses, more) {
  const { leastVoidRatio, largestVoidRatio } = limitsOf(known);
  const voidRatio = byRelativeDensity(known) ? `sands::void_ratio_of_relative_density(${[known.relativeDensity, leastVoidRatio, largestVoidRatio].map(literal).join(", ")})` : literal(known.voidRatio);
  const numbers = keywords(givenNumbers(known, ["uniformity", "least_void_ratio", "largest_void_ratio"]), ".", " = ");
  const question = keywords([["state", "state"], ["grain_density", literal(known.density)], ...more, ["grain_shape", "estimate::GrainShape::sand"],
    ["sand", isNamed(known) ? `sands::sand_of(sands::known_sand("${known.sand}"))` : `{${numbers.join(", ")}}`],
    ["shear_strain", Number.isFinite(known.strain) && more.length ? literal(known.strain) : undefined]], ".", " = ");
  return ["int main() {", "  using namespace granum;", '  const contact::GrainMaterial quartz = contact::mineral("quartz").material;',
    "  const effective::State state{.law = contact::PowerLaw::sphere(quartz, 0.1e-3),", "                               .tangential_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio),",
    "                               .radius = 0.1e-3,", `                               .void_ratio = ${voidRatio},`,
    `                               .stress_v = ${literal(stresses[0])},`, `                               .stress_h = ${literal(stresses[1])}};`,
    `  const estimate::Question question{${question.join(",\n                                    ")}};`];
}

const sameSand = {
  commandLine(known) {
    const [vertical, horizontal] = stressesOf(known).map((stress) => `${inUnit(stress, 1e3)}kPa`);
    return ["granum estimate", ...commandLineSand(known), ...(isotropic(known) ? [`--pressure ${vertical}`] : [`--stress-v ${vertical}`, `--stress-h ${horizontal}`]),
      `--grain-density ${known.density}kg/m3`, ...(known.saturation > 0 ? [`--saturation ${known.saturation}`] : []),
      ...(Number.isFinite(known.strain) ? [`--strain ${inUnit(known.strain, 0.01)}%`] : [])].join(" ");
  },
  python(known) {
    const [vertical, horizontal] = stressesOf(known).map(literal);
    const given = keywords([...pythonSand(known), ...(isotropic(known) ? [["pressure", vertical]] : [["stress_v", vertical], ["stress_h", horizontal]]),
      ["grain_density", literal(known.density)], ["saturation", known.saturation > 0 ? literal(known.saturation) : undefined],
      ["shear_strain", Number.isFinite(known.strain) ? literal(known.strain) : undefined]], "    ", "=");
    return [...pythonBegin, `sand = granum.packing_answer(\n${given.join(",\n")})`, "G = sand.shear_modulus", "print(G.value, G.low, G.high)"].join("\n");
  },
  cpp(known) {
    return ["#include <cstdio>", "", "#include <granum/contact/grains.hpp>", "#include <granum/estimate/answer.hpp>", "",
      ...cppSand(known, stressesOf(known), [["saturation", literal(known.saturation)]]), "  const estimate::Answer sand = estimate::answer(question);",
      "  const estimate::Range& G = sand[estimate::Field::shear_modulus];", '  std::printf("%.17g %.17g %.17g\\n", G.value, G.low, G.high);', "}"].join("\n");
  },
};

const sameSandInference = {
  commandLine(known) {
    const { unit, symbol, option } = measurable[known.quantity];
    return ["granum infer", ...commandLineSand(known), `--pressure ${inUnit(known.pressure, 1e3)}kPa`, `--grain-density ${known.density}kg/m3`,
      `${option} ${inUnit(known.value, unit)}${symbol}+-${inUnit(known.error, 0.01)}%`, `--predict-pressure ${inUnit(known.otherPressure, 1e3)}kPa`].join(" ");
  },
  python(known) {
    const given = keywords([...pythonSand(known), ["pressure", literal(known.pressure)], ["grain_density", literal(known.density)],
      [known.quantity, literal(known.value)], ["relative_error", literal(known.error)]], "    ", "=");
    return [...pythonBegin, `found = granum.infer(\n${given.join(",\n")})`, `G = found.predict("G", pressure=${literal(known.otherPressure)})`,
      "print(found.level.value, found.level.standard_error, G.value, G.standard_error)"].join("\n");
  },
  cpp(known) {
    return ["#include <cstdio>", "#include <span>", "", "#include <granum/contact/grains.hpp>", "#include <granum/inverse/sand_inference.hpp>", "",
      ...cppSand(known, [known.pressure, known.pressure], []), `  const inverse::Observation measured{.quantity = inverse::Quantity::${measurable[known.quantity].cpp},`,
      `                                      .value = {${literal(known.value)}, ${literal(known.error)} * ${literal(known.value)}},`, "                                      .state = state};",
      "  const inverse::SandInference found = inverse::infer_sand(std::span(&measured, 1), question);", "  effective::State there = state;",
      `  there.stress_v = there.stress_h = ${literal(known.otherPressure)};`, "  const Measured G = found.predict(inverse::Quantity::G_vh, there);", "  const Measured& level = found.level();",
      '  std::printf("%.17g %.17g %.17g %.17g\\n", level.value, level.standard_error, G.value, G.standard_error);', "}"].join("\n");
  },
};
