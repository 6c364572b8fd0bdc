// SPDX-License-Identifier: GPL-3.0-or-later
// The view of the calculator: fields, tables, pictures, and equivalent lines for program, Python and C++.
"use strict";

/// A picture with its button.
function savedPicture(texts, name, drawn) {
  const picture = element("div", { class: "picture" });
  picture.innerHTML = drawn;
  return element("div", { class: "saved" }, picture, saveButton(texts, picture, name));
}

function tableOf(label, headings, rows) {
  return element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": label }, element("table", {},
    element("thead", {}, element("tr", {}, ...headings.map((name) => element("th", { scope: "col" }, ...worded(name))))),
    element("tbody", {}, ...rows.map(([name, value, ...more]) => element("tr", {}, element("th", { scope: "row" }, ...worded(name)), element("td", { class: "answer" }, value), ...more.map((text) => element("td", {}, text)))))));
}

/// The ladder: each closed form with its stated error, and the answer with its range.
function ladderChart(words, ladder, answer) {
  const row = answer.rows[0];
  const rungs = ladder.map((rung, k) => ({ ...rung, label: term(words, rung.label), x: k, low: rung.value * (1 - (rung.error || 0)), high: rung.value * (1 + (rung.error || 0)) }));
  const isClosed = (rung) => Number.isFinite(rung.error);
  const part = (all) => ({ points: all.map((rung) => [rung.x, rung.value / MPa]), ranges: all.map((rung) => [rung.low / MPa, rung.high / MPa]), line: false, dots: true });
  const tops = [...rungs.map((rung) => rung.high), row.high].filter(Number.isFinite);
  return chart({
    title: words.ladder, finding: filled(words.ladderFinding, { rungs: rungs.map((rung) => `${rung.label} ${written(rung.value / MPa)}`).join(", "), value: written(row.value / MPa), low: written(row.low / MPa), high: written(row.high / MPa) }),
    x: { label: words.rung, min: -0.6, max: rungs.length + 0.6, names: [...rungs.map((rung) => [rung.x, rung.label]), [rungs.length, words.answer]] },
    y: { label: words.rows[0], min: 0, max: (1.1 * Math.max(MPa, ...tops)) / MPa },
    series: [
      { label: words.bounds, colour: colours.uniform_strain, ...part(rungs.filter((rung) => !isClosed(rung))) },
      { label: words.relaxed, colour: colours.closed_form, ...part(rungs.filter(isClosed)) },
      { label: words.answerRange, colour: colours.grey, points: [[rungs.length, row.value / MPa]], ranges: [[row.low / MPa, row.high / MPa]], line: false, dots: true },
    ],
  });
}

/// The measurement and its prediction at the other pressure, in one picture of G or of a speed.
function inferenceChart(granum, texts, known, found) {
  const words = texts.calculator, { unit } = measurable[known.quantity];
  const low = Math.min(known.pressure, known.otherPressure) / 1.5, high = 1.5 * Math.max(known.pressure, known.otherPressure);
  const points = inferredPath(granum, known, low, high, 25).map((at) => [at.pressure, at]);
  const line = (of) => points.map(([p, there]) => [p / kPa, of(there) / unit]);
  const there = found.there[known.quantity];
  const heights = points.flatMap(([, at]) => [at.value - at.error, at.value + at.error]).concat(known.value * (1 - known.error), known.value * (1 + known.error)).map((y) => y / unit).filter((y) => y > 0);
  return chart({
    title: words.inference, finding: filled(words.inferenceFinding, { quantity: words.measured[known.quantity], value: written(there.value / unit), error: written(there.error / unit, 2), p: written(known.otherPressure / kPa) }),
    x: { label: texts.axis.pressure, min: low / kPa, max: high / kPa, log: true },
    y: { label: words.measured[known.quantity], min: 0.95 * Math.min(...heights), max: 1.05 * Math.max(...heights), log: true },
    series: [
      { label: texts.legend.relaxed, colour: colours.closed_form, points: line((at) => at.value) },
      { colour: colours.closed_form, faint: true, points: line((at) => at.value - at.error) },
      { colour: colours.closed_form, faint: true, points: line((at) => at.value + at.error) },
      { label: words.predicted, colour: colours.closed_form, points: [[known.otherPressure / kPa, there.value / unit]], ranges: [[(there.value - there.error) / unit, (there.value + there.error) / unit]], line: false, dots: true },
      { label: words.measuredHere, colour: colours.measured, points: [[known.pressure / kPa, known.value / unit]], ranges: [[(known.value * (1 - known.error)) / unit, (known.value * (1 + known.error)) / unit]], line: false, dots: true },
    ],
  });
}

/// A choice of the language, the equivalent lines, and a button that copies them.
function samePart(words, name, lines) {
  const shown = element("pre", { tabindex: 0, id: `${name}lines` });
  let chosen = address.choice(`${name}same`, "commandLine", Object.keys(lines));
  let known;
  const show = () => { shown.textContent = lines[chosen](known); };
  const choices = Object.keys(lines).map((where) => element("label", {}, element("input", { type: "radio", name: `${name}same`, value: where, checked: where === chosen, onchange: () => {
    chosen = where;
    address.put(`${name}same`, where);
    show();
  } }), ` ${words.where[where]}`));
  const copy = element("button", { onclick: async () => {
    try {
      await navigator.clipboard.writeText(shown.textContent);
      copy.textContent = words.copied;
    } catch {
      getSelection().selectAllChildren(shown); // for copying by hand
    }
  } }, words.copy);
  return {
    place: element("div", {}, element("fieldset", {}, element("legend", {}, words.same), ...choices), shown, copy),
    show(what) {
      known = what;
      copy.textContent = words.copy;
      show();
    },
  };
}

/// The page's word for a name of granum.
const term = (words, name) => words.terms[name] ?? name;
const sharesText = (words, title, shares) => `${title}: ${shares.filter((s) => s.share >= 0.005).map((s) => `${Math.round(100 * s.share)} % ${term(words, s.input)}`).join(", ")}.`;
const remarks = (words, notes) => (notes.length ? [element("p", { class: "remarks" }, `${words.notes}: ${notes.join("; ")}.`)] : []);
const plusMinus = (number, unit = 1) => `${written(number.value / unit)} ± ${written(number.error / unit, 2)}`;

function answerParts(granum, texts, known) {
  const words = texts.calculator, slips = slipsOf(granum, known), answer = answerOf(granum, known);
  const scale = [MPa, MPa, MPa, MPa, 1, 1, 1, 1];
  const rows = answer.rows.map((row, k) => [words.rows[k], written(row.value / scale[k]), `${written(row.low / scale[k])} – ${written(row.high / scale[k])}`]);
  return [...slips.map((slip) => element("p", { class: "slip", role: "alert" }, slip)), element("div", { class: "panes" },
    element("div", {}, tableOf(words.quantity, [words.quantity, words.value, words.range], rows), element("p", {}, sharesText(words, words.why, answer.shares))),
    savedPicture(texts, "ladder", ladderChart(words, ladderOf(granum, known, answer), answer))), ...remarks(words, answer.notes)];
}

function inferenceParts(granum, texts, known) {
  const words = texts.calculator, found = inferenceOf(granum, known);
  if (!found.explained) return [element("p", { class: "finding", role: "alert" }, words.unexplained), ...remarks(words, found.notes)];
  const at = (p) => filled(words.at, { p: written(p / kPa) });
  const rows = [[`z* ${at(known.pressure)}`, plusMinus(found.z)], [`C_n ${at(known.pressure)}`, plusMinus(found.contacts)],
    [`z* ${at(known.otherPressure)}`, plusMinus(found.there.z)],
    ...Object.keys(measurable).map((name) => [`${words.measured[name]} ${at(known.otherPressure)}`, plusMinus(found.there[name], measurable[name].unit)])];
  return [element("div", { class: "panes" },
    element("div", {}, tableOf(words.inference, [words.quantity, words.valueError], rows), element("p", {}, sharesText(words, words.whyContacts, found.shares))),
    savedPicture(texts, "inference", inferenceChart(granum, texts, known, found))), ...remarks(words, found.notes)];
}

/// Input of an inference from the fields above it.
const sharedByBoth = ["voidRatio", "pressure", "grainModulus", "poissonRatio", "radius", "density"];

function addCalculator(granum, texts) {
  const words = texts.calculator;
  const known = {};
  const answer = element("div", { id: "answer" }), inference = element("div", { id: "inference" });
  const same = samePart(words, "c", sameAnswer), sameInferred = samePart(words, "i", sameInference);
  const filledWith = (place, parts, lines) => {
    const own = parts === inferenceParts ? [...sharedByBoth, ...Object.keys(inferenceInputs)] : Object.keys(calculatorInputs).filter((key) => key !== "z");
    const empty = own.filter((key) => !Number.isFinite(known[key]));
    if (empty.length) {
      place.replaceChildren(element("p", { class: "finding", role: "status" }, filled(words.empty, { names: empty.map((key) => words[key]).join(", ") })));
      return;
    }
    try {
      place.replaceChildren(...parts(granum, texts, known));
      lines.show(known);
    } catch (error) {
      place.replaceChildren(element("p", { class: "finding", role: "alert" }, error.message));
    }
  };
  const show = () => {
    filledWith(answer, answerParts, same);
    filledWith(inference, inferenceParts, sameInferred);
  };
  const unitOf = (key, unit) => (key === "value" ? measurable[known.quantity].unit : unit);
  const field = (key, [unit, min, max, start]) => {
    const shown = address.number(`c${key}`, start, min, max);
    known[key] = shown * unitOf(key, unit);
    const input = element("input", { type: "number", id: `c${key}`, min, max, step: "any", value: Number.isNaN(shown) ? "" : shown, oninput: () => {
      known[key] = input.value === "" ? NaN : Number(input.value) * unitOf(key, unit);
      address.put(`c${key}`, input.value);
      show();
    } });
    return element("label", {}, words[key], input);
  };
  const choice = (key, label, names, textOf, change = () => {}) => {
    known[key] = address.choice(`c${key}`, names[0], names);
    const select = element("select", { id: `c${key}`, onchange: () => {
      known[key] = select.value;
      address.put(`c${key}`, select.value);
      change();
      show();
    } }, ...names.map((name) => element("option", { value: name, selected: name === known[key] }, textOf(name))));
    return element("label", {}, label, select);
  };
  const preparation = choice("preparation", words.preparation, preparations, (name) => words[name]);
  const fields = Object.entries(calculatorInputs).map(([key, range]) => field(key, range));
  const quantity = choice("quantity", words.quantityMeasured, ["V_s", "V_p", "G"], (name) => words.measured[name], () => {
    known.value = Number(document.getElementById("cvalue").value) * measurable[known.quantity].unit;
  });
  const measuredFields = Object.entries(inferenceInputs).map(([key, range]) => field(key, range));
  document.getElementById("calculator").append(element("p", {}, words.text), element("div", { class: "form" }, ...fields, preparation), answer, same.place,
    element("h3", {}, words.inference), element("p", {}, words.inferenceText), element("div", { class: "form" }, quantity, ...measuredFields), inference, sameInferred.place);
  drawnToSize(show);
}
