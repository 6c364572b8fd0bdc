// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that give the calculator's numbers on the command line, in Python and in C++.
"use strict";

/// In a unit, without the last digit, which may be wrong after a division.
const inUnit = (value, unit) => Number((value / unit).toPrecision(13));
/// The exact number, as read by Python and C++.
const literal = (value) => (value !== 0 && (Math.abs(value) >= 1e5 || Math.abs(value) < 1e-2) ? value.toExponential().replace("e+", "e") : String(value));
const isotropic = (known) => known.stressRatio === 1;
const stressesOf = (known) => {
  const vertical = isotropic(known) ? known.pressure : (3 * known.pressure) / (1 + 2 * known.stressRatio);
  return [vertical, isotropic(known) ? vertical : known.stressRatio * vertical];
};

/// A name and a value for each given input.
const keywords = (pairs, before, between) => pairs.filter(([, value]) => value !== undefined).map(([name, value]) => `${before}${name}${between}${value}`);

/// Options of the grains, those of the keys that are given.
function commandLineGrains(known, given = () => true) {
  return Object.entries({ grainModulus: `--grain-shear-modulus ${inUnit(known.grainModulus, 1e9)}GPa`, poissonRatio: `--grain-poisson-ratio ${known.poissonRatio}`,
    radius: `--radius ${inUnit(known.radius, 1e-3)}mm`, density: `--grain-density ${known.density}kg/m3` }).filter(([key]) => given(key)).map(([, option]) => option);
}
/// Inputs that granum assumes if they are not given, by its names, and the standard deviations of the assumptions.
const assumedNames = { grainModulus: "grain_shear_modulus", poissonRatio: "grain_poisson_ratio", density: "grain_density" };
function pythonUncertainty(known) {
  const assumed = Object.entries(assumedNames).filter(([key]) => isAssumed(known, key)).map(([, name]) => `"${name}": ${literal(assumedDeviations[name])}`);
  return assumed.length ? `{${assumed.join(", ")}}` : undefined;
}
const pythonLaw = (known) => `granum.sphere(shear_modulus=${literal(known.grainModulus)}, poisson_ratio=${literal(known.poissonRatio)}, radius=${literal(known.radius)})`;
const cppState = (known, stresses) => [
  `  const contact::GrainMaterial grain{.shear_modulus = ${literal(known.grainModulus)}, .poisson_ratio = ${literal(known.poissonRatio)}};`,
  `  const effective::State state{.law = contact::PowerLaw::sphere(grain, ${literal(known.radius)}),`,
  `                               .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),`,
  ...keywords([["radius", literal(known.radius)], ["void_ratio", literal(known.voidRatio)],
    ["mechanical_coordination_number", Number.isFinite(known.z) ? literal(known.z) : undefined], ["fabric_anisotropy", known.anisotropy ? literal(known.anisotropy) : undefined],
    ["stress_v", literal(stresses[0])], ["stress_h", literal(stresses[1])]], "                               .", " = ").map((line, k, all) => line + (k + 1 < all.length ? "," : "};")),
].join("\n");

const sameAnswer = {
  commandLine(known) {
    const [vertical, horizontal] = stressesOf(known).map((stress) => `${inUnit(stress, 1e3)}kPa`);
    const words = ["granum estimate", `--void-ratio ${known.voidRatio}`, ...(isotropic(known) ? [`--pressure ${vertical}`] : [`--stress-v ${vertical}`, `--stress-h ${horizontal}`]),
      ...commandLineGrains(known, (key) => key === "radius" || !isAssumed(known, key)), ...(isAssumed(known, "anisotropy") ? [] : [`--fabric ${known.anisotropy}`])];
    if (known.saturation > 0) words.push(`--saturation ${known.saturation}`);
    if (known.preparation !== "unknown") words.push(`--preparation ${known.preparation}`);
    if (Number.isFinite(known.z)) words.push(`--mechanical-coordination-number ${known.z}`);
    return words.join(" ");
  },
  python(known) {
    const [vertical, horizontal] = stressesOf(known).map(literal);
    const given = keywords([["law", pythonLaw(known)], ["radius", literal(known.radius)], ["void_ratio", literal(known.voidRatio)],
      ...(isotropic(known) ? [["pressure", vertical]] : [["stress_v", vertical], ["stress_h", horizontal]]),
      ["fabric_anisotropy", isAssumed(known, "anisotropy") ? undefined : literal(known.anisotropy)], ["grain_density", literal(known.density)],
      ["uncertainty", pythonUncertainty(known)], ["saturation", known.saturation > 0 ? literal(known.saturation) : undefined], ["preparation", known.preparation === "unknown" ? undefined : `"${known.preparation}"`],
      ["mechanical_coordination_number", Number.isFinite(known.z) ? literal(known.z) : undefined]], "    ", "=");
    return `import granum\n\npacking = granum.packing_answer(\n${given.join(",\n")})\nG = packing.shear_modulus\nprint(G.value, G.low, G.high)`;
  },
  cpp(known) {
    const [vertical, horizontal] = stressesOf(known).map(literal);
    const given = keywords([["void_ratio", literal(known.voidRatio)], ...(isotropic(known) ? [["pressure", vertical]] : [["stress_v", vertical], ["stress_h", horizontal]]),
      ...Object.entries({ ...assumedNames, anisotropy: "fabric" }).map(([key, name]) => [name, isAssumed(known, key) ? undefined : literal(known[key])]), ["radius", literal(known.radius)],
      ["saturation", known.saturation > 0 ? literal(known.saturation) : undefined], ["preparation", known.preparation === "unknown" ? undefined : `"${known.preparation}"`],
      ["mechanical_coordination_number", Number.isFinite(known.z) ? literal(known.z) : undefined]], "  known.give(Input::", ", ").map((line) => `${line});`);
    return ["#include <cstdio>", "", "#include <granum/estimate/answer.hpp>", "#include <granum/estimate/input_values.hpp>", "", "int main() {", "  using namespace granum;",
      "  using estimate::Input;", "  estimate::InputValues known;", ...given, "  known.give(Input::contact, \"sphere\");", "  known = completed(known);",
      "  const estimate::Answer packing =", "      estimate::answer(question_of(known), uncertain_inputs(known, estimate::Deviations{}));",
      "  const estimate::Range& G = packing[estimate::Field::shear_modulus];", '  std::printf("%.17g %.17g %.17g\\n", G.value, G.low, G.high);', "}"].join("\n");
  },
};

/// Measurable quantities: index in granum's list, unit, option, and names in Python and C++.
const measurable = {
  G: { place: 0, unit: 1e6, symbol: "MPa", option: "--shear-modulus", cpp: "G_vh" },
  V_s: { place: 3, unit: 1, symbol: "m/s", option: "--vs", cpp: "V_s" },
  V_p: { place: 5, unit: 1, symbol: "m/s", option: "--vp", cpp: "V_p" },
};

const sameInference = {
  commandLine(known) {
    const { unit, symbol, option } = measurable[known.quantity];
    return ["granum infer", `--void-ratio ${known.voidRatio}`, `--pressure ${inUnit(known.pressure, 1e3)}kPa`, ...commandLineGrains(known), "--fabric 0",
      `${option} ${inUnit(known.value, unit)}${symbol}+-${inUnit(known.error, 0.01)}%`, `--predict-pressure ${inUnit(known.otherPressure, 1e3)}kPa`].join(" ");
  },
  python(known) {
    const given = keywords([["law", pythonLaw(known)], ["radius", literal(known.radius)], ["void_ratio", literal(known.voidRatio)], ["pressure", literal(known.pressure)],
      [known.quantity, literal(known.value)], ["relative_error", literal(known.error)], ["grain_density", literal(known.density)]], "    ", "=");
    return `import granum\n\nfound = granum.infer(\n${given.join(",\n")})\nz = found.mechanical_coordination_number\nG = found.predict("G", pressure=${literal(known.otherPressure)})\n` +
      "print(z.value, z.standard_error, G.value, G.standard_error)";
  },
  cpp(known) {
    return ["#include <cstdio>", "#include <span>", "", "#include <granum/inverse/inference.hpp>", "", "int main() {", "  using namespace granum;",
      cppState({ ...known, anisotropy: 0 }, [known.pressure, known.pressure]),
      `  const inverse::Observation measured{.quantity = inverse::Quantity::${measurable[known.quantity].cpp},`,
      `                                      .value = {${literal(known.value)}, ${literal(known.error)} * ${literal(known.value)}},`, "                                      .state = state};",
      `  const inverse::InferenceAnswer found = inverse::infer(std::span(&measured, 1), {.grain_density = ${literal(known.density)}});`,
      "  if (!found.together)", "    return 1; // no coordination number explains it", "  const Measured z = found.together->packing(state).mechanical_coordination_number;",
      "  effective::State there = state;", `  there.stress_v = there.stress_h = ${literal(known.otherPressure)};`, "  there.void_ratio = found.together->void_ratio_at(there.stress_v);",
      "  const Measured G = found.together->predict(inverse::Quantity::G_vh, there);", '  std::printf("%.17g %.17g %.17g %.17g\\n", z.value, z.standard_error, G.value, G.standard_error);', "}"].join("\n");
  },
};
