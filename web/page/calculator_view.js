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
  const row = answer.rows.shear_modulus;
  const rungs = ladder.map((rung, k) => ({ ...rung, label: term(words, rung.label), x: k, low: rung.value * (1 - rung.error), high: rung.value * (1 + rung.error) })); // no bar where no error is stated
  const isClosed = (rung) => Number.isFinite(rung.error);
  const part = (all) => ({ points: all.map((rung) => [rung.x, rung.value / MPa]), ranges: all.map((rung) => [rung.low / MPa, rung.high / MPa]), line: false, dots: true });
  const tops = [...rungs.flatMap((rung) => [rung.value, rung.high]), row.high].filter(Number.isFinite);
  return chart({
    title: words.ladder, finding: filled(words.ladderFinding, { rungs: rungs.map((rung) => `${rung.label} ${written(rung.value / MPa)}`).join(", "), value: written(row.value / MPa), low: written(row.low / MPa), high: written(row.high / MPa) }),
    x: { label: words.rung, min: -0.6, max: rungs.length + 0.6, names: [...rungs.map((rung) => [rung.x, rung.label]), [rungs.length, words.answer]] },
    y: { label: words.rows.shear_modulus, min: 0, max: (1.1 * Math.max(MPa, ...tops)) / MPa },
    series: [
      { label: words.bounds, colour: colours.uniform_strain, ...part(rungs.filter((rung) => !isClosed(rung))) },
      { label: words.relaxed, colour: colours.closed_form, ...part(rungs.filter(isClosed)) },
      { label: words.answerRange, colour: colours.grey, points: [[rungs.length, row.value / MPa]], ranges: [[row.low / MPa, row.high / MPa]], line: false, dots: true },
    ],
  });
}

/// G of a sand over the pressure, with its range, and published laws.
function sandChart(granum, words, known, laws) {
  const path = sandPath(granum, known, 25), [{ pressure: low }, { pressure: high }] = [path[0], path.at(-1)];
  const points = (part) => path.map((at) => [at.pressure / kPa, at[part] / MPa]);
  const heights = [...path.flatMap((at) => [at.low, at.high]), ...laws.flatMap((law) => law.path.map(([, G]) => G))].filter((G) => G > 0).map((G) => G / MPa);
  const here = path[12];
  const p = written(known.pressure / kPa), answer = { p, value: written(here.value / MPa), low: written(here.low / MPa), high: written(here.high / MPa) };
  return chart({
    title: words.sandChart, finding: filled(words.sandFinding, { ...answer, laws: laws.filter((law) => law.here > 0).map((law) => `${law.name} ${written(law.here / MPa)}`).join(", ") }),
    x: { label: words.pressure, min: low / kPa, max: high / kPa, log: true },
    y: { label: words.rows.shear_modulus, min: 0.9 * Math.min(...heights), max: 1.1 * Math.max(...heights), log: true },
    bands: [{ label: words.range, colour: colours.closed_form, points: [...points("low"), ...points("high").reverse()] }],
    series: [
      ...laws.map((law, k) => ({ label: k === 0 ? words.laws : undefined, colour: colours.grey, faint: true, points: law.path.map(([at, G]) => [at / kPa, G / MPa]) })),
      { label: words.sandLaw, colour: colours.closed_form, points: points("value") },
      { label: words.answer, colour: colours.closed_form, points: [[known.pressure / kPa, here.value / MPa]], line: false, dots: true },
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
      { label: isSand(known) ? words.sandLaw : texts.legend.relaxed, colour: colours.closed_form, points: line((at) => at.value) },
      { colour: colours.closed_form, faint: true, points: line((at) => at.value - at.error) },
      { colour: colours.closed_form, faint: true, points: line((at) => at.value + at.error) },
      { label: words.predicted, colour: colours.closed_form, points: [[known.otherPressure / kPa, there.value / unit]], ranges: [[(there.value - there.error) / unit, (there.value + there.error) / unit]], line: false, dots: true },
      { label: words.measuredHere, colour: colours.measured, points: [[known.pressure / kPa, known.value / unit]], ranges: [[(known.value * (1 - known.error)) / unit, (known.value * (1 + known.error)) / unit]], line: false, dots: true },
    ],
  });
}

/// A choice of the language, the equivalent lines of beads or of a sand, and a button that copies them.
function samePart(words, name, lines) {
  const shown = element("pre", { tabindex: 0, id: `${name}lines` });
  let chosen = address.choice(`${name}same`, "commandLine", Object.keys(words.where));
  let known;
  const show = () => {
    shown.textContent = lines[known.grains][chosen](known);
    copy.textContent = words.copy;
  };
  const choices = Object.keys(words.where).map((where) => element("label", {}, element("input", { type: "radio", name: `${name}same`, value: where, checked: where === chosen, onchange: () => {
    chosen = where;
    address.put(`${name}same`, where);
    show();
  } }), ` ${words.where[where]}`));
  const copy = element("button", { onclick: async () => {
    try {
      await navigator.clipboard.writeText(shown.textContent);
      copy.textContent = words.copied;
      say(words.copied);
    } catch {
      getSelection().selectAllChildren(shown); // for copying by hand
    }
  } }, words.copy);
  return {
    place: element("div", {}, element("fieldset", {}, element("legend", {}, words.same), ...choices), shown, copy),
    show(what) {
      known = what;
      show();
    },
  };
}

/// The page's word for a name of granum.
const term = (words, name) => words.terms[name] ?? name;
const sharesText = (words, title, shares) => `${title}: ${shares.filter((s) => s.share >= 0.005).map((s) => `${Math.round(100 * s.share)} % ${term(words, s.input)}`).join(", ")}.`;
const remarks = (words, notes) => (notes.length ? [element("p", { class: "remarks" }, `${words.notes}: ${notes.join("; ")}.`)] : []);
const plusMinus = (number, unit = 1) => `${written(number.value / unit)} ± ${written(number.error / unit, 2)}`;

/// Numbers of an answer that are shown, by granum's keys, and their units.
const shownOfBoth = { shear_modulus: 1e6, horizontal_shear_modulus: 1e6, bulk_modulus: 1e6, young_modulus: 1e6, poisson_ratio: 1, shear_wave_speed: 1, compression_wave_speed: 1 };
const shownRows = {
  sphere: { ...shownOfBoth, mechanical_coordination_number: 1 },
  sand: { ...shownOfBoth, stress_exponent: 1, strained_shear_modulus: 1e6, modulus_ratio: 1, damping_ratio: 0.01, mechanical_coordination_number: 1, contact_softness: 1 },
};
const rangeText = (row, unit = 1) => `${written(row.low / unit)} – ${written(row.high / unit)}`;

function answerParts(granum, texts, known) {
  const words = texts.calculator, sand = isSand(known);
  const slips = (sand ? sandSlipsOf : slipsOf)(granum, known), answer = (sand ? sandAnswerOf : answerOf)(granum, known);
  const rows = Object.entries(shownRows[known.grains]).filter(([key]) => answer.rows[key])
    .map(([key, unit]) => [(sand && words.inferredRows[key]) || words.rows[key], written(answer.rows[key].value / unit), rangeText(answer.rows[key], unit)]);
  const laws = sand ? sandLaws(granum, known, 25) : [];
  return [...slips.map((slip) => element("p", { class: "slip", role: "alert" }, slip)), element("div", { class: "panes" },
    element("div", {}, tableOf(words.quantity, [words.quantity, words.value, words.range], rows), element("p", {}, sharesText(words, words.why, answer.shares))),
    element("div", {}, sand ? savedPicture(texts, "sand", sandChart(granum, words, known, laws)) : savedPicture(texts, "ladder", ladderChart(words, ladderOf(granum, known, answer), answer)),
      ...(sand ? [lawsTable(words, known, laws)] : []))), ...remarks(words, answer.notes)];
}

/// G of published laws at the pressure of the answer.
const lawsTable = (words, known, laws) => element("details", {}, element("summary", {}, filled(words.lawsHere, { p: written(known.pressure / kPa) })),
  tableOf(words.laws, [words.law, words.rows.shear_modulus, words.tested], laws.map((law) => [law.name, written(law.here / MPa), law.tested ? words.yes : words.no])));

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

function sandInferenceParts(granum, texts, known) {
  const words = texts.calculator, found = sandInferenceOf(granum, known);
  const at = (p) => filled(words.at, { p: written(p / kPa) });
  const inferred = ({ value, low, high }) => `${written(value)} (${rangeText({ low, high })})`;
  const rows = [[words.level, plusMinus(found.level)], [words.rows.stress_exponent, plusMinus(found.exponent)],
    [`${words.rows.poisson_ratio} ${at(known.pressure)}`, plusMinus(found.poissonRatio)],
    [`${words.inferredRows.mechanical_coordination_number} ${at(known.pressure)}`, inferred(found.z)], [words.inferredRows.contact_softness, inferred(found.softness)],
    ...Object.keys(measurable).map((name) => [`${words.measured[name]} ${at(known.otherPressure)}`, plusMinus(found.there[name], measurable[name].unit)])];
  return [element("div", { class: "panes" },
    element("div", {}, tableOf(words.sandInference, [words.quantity, words.valueError], rows), ...(found.tellsContacts ? [] : [element("p", {}, words.fewOrSoft)])),
    savedPicture(texts, "inference", inferenceChart(granum, texts, known, found))), ...remarks(words, found.notes)];
}

function addCalculator(granum, texts) {
  const words = texts.calculator;
  const known = { typed: new Set() };
  readKnownSands(granum);
  const answer = element("div", { id: "answer" }), inference = element("div", { id: "inference" });
  const about = element("p", { id: "cabout" }), aboutInference = element("p", {}), titleOfInference = element("h3", {});
  const same = samePart(words, "c", { sphere: sameAnswer, sand: sameSand }), sameInferred = samePart(words, "i", { sphere: sameInference, sand: sameSandInference });
  const filledWith = (place, required, parts, lines) => {
    const odd = [...document.querySelectorAll("#calculator input[aria-invalid]")].filter((input) => input.getClientRects().length > 0);
    if (odd.length) {
      place.replaceChildren(element("p", { class: "finding", role: "alert" }, odd.map((input) => filled(words.notNumber, { value: input.value })).join(" ")));
      return;
    }
    const empty = required.filter((key) => !Number.isFinite(known[key]));
    if (empty.length) {
      place.replaceChildren(element("p", { class: "finding", role: "status" }, ...worded(filled(words.empty, { names: empty.map((key) => words[key].split(",")[0]).join(", ") }))));
      return;
    }
    try {
      place.replaceChildren(...parts(granum, texts, known));
      lines.show(known);
    } catch (error) {
      place.replaceChildren(element("p", { class: "finding", role: "alert" }, error.message));
    }
  };
  const labels = {};
  const show = () => {
    const used = inUse(known);
    for (const [key, label] of Object.entries(labels)) label.hidden = !used.includes(key);
    about.textContent = words.about[known.grains];
    titleOfInference.textContent = isSand(known) ? words.sandInference : words.inference;
    aboutInference.textContent = words.aboutInference[known.grains];
    filledWith(answer, needed(known), answerParts, same);
    filledWith(inference, neededToInfer(known), isSand(known) ? sandInferenceParts : inferenceParts, sameInferred);
  };
  const unitOf = (key, unit) => (key === "value" ? measurable[known.quantity].unit : unit);
  const field = (key, [unit, min, max, start]) => {
    const shown = address.number(`c${key}`, start, min, max);
    known[key] = shown * unitOf(key, unit);
    if (address.values.get(`c${key}`)) known.typed.add(key);
    const input = numberField({ id: `c${key}`, min, max, value: shown, change: (typed) => {
      known[key] = (typed ?? NaN) * unitOf(key, unit);
      known.typed[Number.isFinite(typed) ? "add" : "delete"](key);
      input.toggleAttribute("aria-invalid", typed === undefined);
      address.put(`c${key}`, typed === undefined || Number.isNaN(typed) ? "" : typed);
      show();
    } });
    return element("label", {}, element("span", {}, ...worded(words[key])), input);
  };
  const choice = (key, label, names, textOf, change = () => {}) => {
    known[key] = address.choice(`c${key}`, names[0], names);
    const select = element("select", { id: `c${key}`, onchange: () => {
      known[key] = select.value;
      address.put(`c${key}`, select.value);
      change();
      show();
    } }, ...names.map((name) => element("option", { value: name, selected: name === known[key] }, textOf(name).replaceAll("_", ""))));
    return element("label", {}, label, select);
  };
  labels.grains = choice("grains", words.grains, grainKinds, (name) => words[name]);
  labels.sand = choice("sand", words.nameOfSand, ["unnamed", ...knownSands.map(({ key }) => key)], (name) => knownSands.find(({ key }) => key === name)?.name ?? words.unnamed);
  labels.densityBy = choice("densityBy", words.densityBy, ["voidRatio", "relativeDensity"], (name) => words.densities[name]);
  for (const [key, range] of Object.entries(calculatorInputs)) labels[key] = field(key, range);
  labels.preparation = choice("preparation", words.preparation, preparations, (name) => words[name]);
  const quantity = choice("quantity", words.quantityMeasured, ["V_s", "V_p", "G"], (name) => words.measured[name], () => {
    known.value = (document.getElementById("cvalue").typed ?? NaN) * measurable[known.quantity].unit;
  });
  const measuredFields = Object.entries(inferenceInputs).map(([key, range]) => field(key, range));
  document.getElementById("calculator").append(element("p", {}, words.text), element("div", { class: "form" }, ...Object.values(labels)), about, answer, same.place,
    titleOfInference, aboutInference, element("div", { class: "form" }, quantity, ...measuredFields), inference, sameInferred.place);
  drawnToSize(show);
}
