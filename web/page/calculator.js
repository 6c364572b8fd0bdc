// SPDX-License-Identifier: GPL-3.0-or-later
// The best answer to what is known of a packing, with its range.
"use strict";

const preparations = ["unknown", "dense", "loose"];

/// Inputs: key, unit in SI, least, most, start; not a number where it is not given.
const calculatorInputs = {
  voidRatio: [1, 0.2, 3, 0.6], pressure: [1e3, 0.001, 1e6, 100], grainModulus: [1e9, 1e-3, 1e4, 30], poissonRatio: [1, -0.9, 0.5, 0.15],
  radius: [1e-3, 1e-6, 1e4, 0.5], density: [1, 1, 3e4, 2650], saturation: [0.01, 0, 100, 0], z: [1, 0, 12, NaN],
};

/// {rows: [{value, low, high}], shares: [{input, share}], notes}
function answerOf(granum, known) {
  const { numbers, notes } = granum.call("answer", ...grainNumbers({ ...defaultGrain, shearModulus: known.grainModulus, poissonRatio: known.poissonRatio, radius: known.radius }),
    known.voidRatio, known.pressure, preparations.indexOf(known.preparation), known.z, known.density, known.saturation);
  const rows = [], shares = [];
  for (let k = 0; k < 21; k += 3) rows.push({ value: numbers[k], low: numbers[k + 1], high: numbers[k + 2] });
  numbers.slice(21).forEach((share, k) => shares.push({ input: notes[k], share }));
  return { rows, shares, notes: notes.slice(shares.length) };
}

/// What one types to get the same elsewhere.
function commandOf(known) {
  const units = (value, unit) => Number((value / unit).toPrecision(13));
  const words = ["granum estimate", `--void-ratio ${known.voidRatio}`, `--pressure ${units(known.pressure, 1e3)}kPa`,
    `--grain-shear-modulus ${units(known.grainModulus, 1e9)}GPa`, `--grain-poisson-ratio ${known.poissonRatio}`, `--radius ${units(known.radius, 1e-3)}mm`, `--grain-density ${known.density}kg/m3`, "--fabric 0"];
  if (known.saturation > 0) words.push(`--saturation ${known.saturation}`);
  if (known.preparation !== "unknown") words.push(`--preparation ${known.preparation}`);
  if (Number.isFinite(known.z)) words.push(`--mechanical-coordination-number ${known.z}`);
  return words.join(" ");
}

function addCalculator(granum, texts) {
  const words = texts.calculator;
  const known = { preparation: address.choice("cpreparation", "unknown", preparations) };
  const result = element("div", { id: "answer" });
  const show = () => {
    try {
      const { rows, shares, notes } = answerOf(granum, known);
      const scale = [1e6, 1e6, 1e6, 1, 1, 1, 1];
      result.replaceChildren(
        element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": words.quantity }, element("table", {},
          element("thead", {}, element("tr", {}, ...[words.quantity, words.value, words.range].map((name) => element("th", { scope: "col" }, name)))),
          element("tbody", {}, ...rows.map((row, k) => element("tr", {}, element("th", { scope: "row" }, words.rows[k]),
            element("td", { class: "answer" }, written(row.value / scale[k])),
            element("td", {}, `${written(row.low / scale[k])} – ${written(row.high / scale[k])}`)))))),
        element("p", {}, `${words.why}: ${shares.filter((s) => s.share >= 0.005).map((s) => `${s.input} ${Math.round(100 * s.share)} %`).join(", ")}.`),
        ...(notes.length ? [element("p", { class: "remarks" }, `${words.notes}: ${notes.join("; ")}.`)] : []),
        element("p", {}, `${words.same}:`), element("pre", { tabindex: 0 }, commandOf(known)));
    } catch (error) {
      result.replaceChildren(element("p", { class: "finding", role: "alert" }, error.message));
    }
  };
  const inputs = Object.entries(calculatorInputs).map(([key, [unit, min, max, start]]) => {
    const shown = address.number(`c${key}`, start, min, max);
    known[key] = shown * unit;
    const input = element("input", { type: "number", id: `c${key}`, min, max, step: "any", value: Number.isNaN(shown) ? "" : shown, oninput: () => {
      known[key] = input.value === "" ? NaN : Number(input.value) * unit;
      address.put(`c${key}`, input.value);
      show();
    } });
    return element("label", {}, words[key], input);
  });
  const choice = element("select", { id: "cpreparation", onchange: () => {
    known.preparation = choice.value;
    address.put("cpreparation", choice.value);
    show();
  } }, ...preparations.map((name) => element("option", { value: name, selected: name === known.preparation }, words[name])));
  document.getElementById("calculator").append(element("p", {}, words.text),
    element("div", { class: "form" }, ...inputs, element("label", {}, words.preparation, choice)), result);
  show();
}
