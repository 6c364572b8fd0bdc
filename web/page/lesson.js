// SPDX-License-Identifier: GPL-3.0-or-later
// Seven steps: one idea, one or two pictures, one or two sliders each.
"use strict";

const kPa = 1e3, MPa = 1e6;

/// Values from low to high, with equal steps of the logarithm.
const spread = (low, high, count) => Array.from({ length: count }, (_, k) => low * (high / low) ** (k / (count - 1)));
const evenly = (low, high, count) => Array.from({ length: count }, (_, k) => low + ((high - low) * k) / (count - 1));
/// Numbers that differ only by rounding count as equal.
const percentApart = (a, b) => (Math.abs(a / b - 1) < 1e-9 ? 0 : 100 * Math.abs(a / b - 1));
/// A logarithmic axis that includes all values.
const logAxis = (label, values) => ({ label, min: Math.min(...values) / 1.15, max: Math.max(...values) * 1.15, log: true });

/// Force at which the contacts of the first step are equally stiff [N].
const commonForce = 0.25;
const alike = new Map();
/// The grain with that shape of contact, as stiff as spheres at that force.
function asStiffAsSpheres(granum, grain, shape) {
  if (!alike.has(shape)) {
    const { numbers } = lawNamed(shape);
    const found = numbers.length ? granum.call("law_as_stiff", ...grainNumbers({ ...grain, shape }), commonForce).numbers : [];
    alike.set(shape, Object.fromEntries(numbers.map(({ key }, k) => [key, found[k]])));
  }
  return { ...grain, shape, numbers: alike.get(shape) };
}

/// Contacts of one exponent at all forces.
let knownPowerLaws;
const powerLaws = (granum) => (knownPowerLaws ??= contactLaws.filter(({ name: shape }) => !Number.isNaN(granum.contactCurve({ ...defaultGrain, shape }, 1e-7, 1).alpha)));

/// "measured sands, s 0.4 to 0.58"
const sandsNamed = (texts, least, most) => filled(texts.legend.sands, { least: written(least, 2), most: written(most, 2) });
/// A wedge of the slopes of measured sands through a point on logarithmic axes.
function sandBand(granum, texts, [x, y], low, high) {
  const [least, most] = granum.call("sand_exponents").numbers;
  const at = (p, s) => [p, y * (p / x) ** s];
  return { label: sandsNamed(texts, least, most), colour: colours.grey, points: [at(low, least), [x, y], at(high, least), at(high, most), [x, y], at(low, most)] };
}

/// Sliders of a step: {key: [min, max, step, start, unit]}; "shape" is a choice. A picture returns {values, charts or rose}; `facts` are
/// numbers of its text.
const lessonSteps = [
  {
    controls: { shape: "sphere", overlap: [0.02, 1, 0.02, 0.5, "µm"] },
    picture(granum, grain, at, texts, words) {
      const of = (shape) => asStiffAsSpheres(granum, grain, shape), laws = powerLaws(granum);
      const curves = laws.map(({ name }) => granum.contactCurve(of(name), 1e-6, 100));
      const here = granum.contactCurve(of(grain.shape), at.overlap * 1e-6, 1);
      const [{ force, stiffness }] = here.points;
      const fine = laws.map(({ name }) => spread(0.02, 1, 24).map((overlap) => granum.contactCurve(of(name), overlap * 1e-6, 1).points[0]));
      const series = (points) => curves.map((_, k) => ({ label: laws[k].plural, colour: shapeColour(laws[k].name), faint: laws[k].name !== grain.shape, points: points(k) }));
      const slope = here.stiffnessExponent, least = 0.004, most = 1;
      const left = force * 3 > most ? force / 3 : force; // where the triangle of the tangent begins
      return {
        values: { force: written(force), stiffness: written(stiffness / 1e6), alpha: here.alpha === Infinity ? "∞" : written(here.alpha), slope: written(slope) },
        charts: [{
          title: words.title, x: { label: texts.axis.overlap, min: 0, max: 1 },
          y: { label: texts.axis.force, min: 0, max: 1.15 * Math.max(...curves.map((c) => c.points.at(-1).force)) },
          series: series((k) => [[0, 0], ...curves[k].points.map((p) => [p.overlap * 1e6, p.force])]), mark: [at.overlap, force],
        }, {
          title: words.second, x: { label: texts.axis.force, min: least, max: most, log: true },
          y: { label: texts.axis.stiffness, min: 0.1, max: 3, log: true },
          series: series((k) => fine[k].map((p) => [p.force, p.stiffness / 1e6])), mark: [force, stiffness / 1e6],
          triangles: slope > 0.01 ? [{ x0: left, x1: 3 * left, y: (stiffness / 1e6) * (left / force) ** slope, slope, text: `1/(1+α) = ${written(slope)}` }] : [],
        }],
      };
    },
  },
  {
    controls: { contacts: [4, 8, 0.1, 5.7, ""], voidRatio: [0.5, 0.9, 0.01, 0.6, ""] },
    picture(granum, grain, at, texts, words) {
      const form = (contacts) => granum.closedForms(grain, { voidRatio: at.voidRatio, coordinationNumber: contacts, stressV: 100 * kPa }).uniformStrain;
      const here = form(at.contacts), line = evenly(4, 8, 60).map((c) => [c, form(c)]);
      return {
        values: { contacts: written(at.contacts), G: written(here.vh / MPa), K: written(here.bulk / MPa) },
        charts: [{
          title: words.title, x: { label: texts.axis.contacts, min: 4, max: 8 }, y: { label: texts.axis.modulus, min: 0, max: 650 },
          series: [{ label: texts.legend.G, colour: colours.uniform_strain, points: line.map(([c, at]) => [c, at.vh / MPa]) },
            { label: texts.legend.K, colour: colours.uniform_strain, dash: true, points: line.map(([c, at]) => [c, at.bulk / MPa]) }],
          mark: [at.contacts, here.vh / MPa],
        }],
      };
    },
  },
  {
    controls: { shape: "sphere", pressure: [10, 1000, 10, 100, "kPa"] },
    picture(granum, grain, at, texts, words) {
      const form = (shape, p) => granum.closedForms({ ...grain, shape }, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: p * kPa }).uniformStrain;
      const laws = powerLaws(granum), lines = laws.map(({ name }) => spread(10, 1000, 40).map((p) => [p, form(name, p).vh / MPa]));
      const low = form(grain.shape, 30), here = form(grain.shape, at.pressure);
      return {
        values: { p: written(at.pressure), G: written(here.vh / MPa), factor: written(form(grain.shape, 1000).vh / form(grain.shape, 10).vh), slope: written(here.exponent) },
        charts: [{
          title: words.title, x: { label: texts.axis.pressure, min: 10, max: 1000, log: true }, y: logAxis(texts.axis.G, lines.flat().map(([, G]) => G)),
          series: laws.map(({ name, plural }, k) => ({ label: plural, colour: shapeColour(name), faint: name !== grain.shape, points: lines[k] })),
          bands: [sandBand(granum, texts, [100, form(grain.shape, 100).vh / MPa], 10, 1000)],
          triangles: here.exponent > 0.01 ? [{ x0: 30, x1: 120, y: low.vh / MPa, slope: here.exponent, text: filled(texts.slope, { s: written(here.exponent) }) }] : [],
          mark: [at.pressure, here.vh / MPa],
        }],
      };
    },
  },
  {
    controls: { anisotropy: [-0.6, 0.6, 0.05, 0.3, ""] },
    picture(granum, grain, at) {
      const form = granum.closedForms(grain, { voidRatio: 0.6, coordinationNumber: 5.7, anisotropy: at.anisotropy, stressV: 100 * kPa }).uniformStrain;
      return { values: { vh: written(form.vh / MPa), hh: written(form.hh / MPa), percent: written(percentApart(form.vh, form.hh), 2) }, rose: granum.fabricCurve(at.anisotropy, 45) };
    },
  },
  {
    controls: { z: [4, 7, 0.05, 5, ""] },
    leftAt(granum, grain, z) {
      const { stiffnessExponent, tangentialRatio } = granum.contactCurve(grain, 1e-7, 1);
      return granum.relaxation(z, tangentialRatio, stiffnessExponent).shear;
    },
    facts(granum, grain) {
      return { six: written(100 * this.leftAt(granum, grain, 6), 2), four: written(100 * this.leftAt(granum, grain, 4.1), 2) };
    },
    picture(granum, grain, at, texts, words) {
      const h = (z) => this.leftAt(granum, grain, z);
      return {
        values: { z: written(at.z), percent: written(100 * h(at.z), 2) },
        charts: [{
          title: words.title, x: { label: texts.axis.z, min: 4, max: 7 }, y: { label: texts.axis.left, min: 0, max: 1 },
          series: [{ label: texts.legend.relaxed, colour: colours.closed_form, points: evenly(4, 7, 90).map((z) => [z, h(z)]) }],
          mark: [at.z, h(at.z)],
        }],
      };
    },
  },
  {
    controls: { z10: [4.3, 6, 0.05, 4.4, ""] },
    picture(granum, grain, at, texts, words) {
      // Void ratio and rattlers of the specimens that the experiment makes.
      const path = granum.carriedPath(grain, { voidRatio: 0.568, mechanicalCoordinationNumber: at.z10, rattlerFraction: 0.06, pressure: 10 * kPa }, 100 * kPa, 12);
      const first = path.states[0], last = path.states.at(-1);
      const line = (key) => path.states.map((s) => [s.pressure / kPa, s[key] / MPa]);
      const contact = granum.contactCurve(grain, 1e-7, 1).stiffnessExponent;
      return {
        values: { z0: written(first.z), z1: written(last.z), s: written(path.slope.relaxed), contact: written(contact) },
        charts: [{
          title: words.title, x: { label: texts.axis.pressure, min: 10, max: 100, log: true }, y: { label: texts.axis.G, min: 15, max: 400, log: true },
          series: [
            { label: texts.legend.uniformStrain, colour: colours.uniform_strain, points: line("uniformStrain") },
            { label: texts.legend.relaxed, colour: colours.closed_form, points: line("relaxed") },
            { label: texts.legend.contact, colour: colours.grey, dash: true, points: path.states.map((s) => [s.pressure / kPa, (first.relaxed / MPa) * (s.pressure / first.pressure) ** contact]) },
          ],
          bands: [sandBand(granum, texts, [10, first.relaxed / MPa], 10, 100)],
        }],
      };
    },
  },
  {
    controls: { roughness: [5, 1000, 5, 100, "nm"] },
    beside: [5, 50, 500],
    picture(granum, grain, at, texts, words) {
      const [low, high] = [0.1, 1e5]; // kPa
      const form = (u, p) => granum.closedForms({ ...grain, shape: "rough", numbers: { roughness: u * 1e-9 } }, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: p * kPa });
      const s = (u, p) => form(u, p).uniformStrain.exponent, line = (u) => spread(low, high, 31).map((p) => [p, s(u, p)]);
      const change = form(at.roughness, 100).transitionPressure / kPa, [least, most] = granum.call("sand_exponents").numbers;
      const named = (u) => filled(words.curve, { u: written(u) });
      return {
        values: { u: written(at.roughness), change: written(change), first: written(s(at.roughness, 1)), middle: written(s(at.roughness, 100)), last: written(s(at.roughness, 1e4)) },
        charts: [{
          title: words.title, x: { label: texts.axis.pressure, min: low, max: high, log: true }, y: { label: texts.axis.s, min: 0, max: 1.05 },
          series: [...this.beside.map((u, k) => ({ label: named(u), colour: colours.grey, dash: ["dots", false, true][k], faint: true, points: line(u) })),
            { label: named(at.roughness), colour: colours.rough, points: line(at.roughness) }],
          bands: [{ label: sandsNamed(texts, least, most), colour: colours.grey, points: [[low, least], [high, least], [high, most], [low, most]] }],
          mark: [change, s(at.roughness, change)],
        }],
      };
    },
  },
];

/// Radio buttons of contact shapes.
const shapeChoice = (name, legend, laws, chosen, change) => element("fieldset", {}, element("legend", {}, legend), ...laws.map(({ name: shape, plural }) =>
  element("label", {}, element("input", { type: "radio", name, value: shape, checked: shape === chosen, onchange: () => change(shape) }), ` ${plural}`)));

function addStep(granum, texts, step, number) {
  const words = texts.steps[number], name = `step${number + 1}`;
  const grain = { ...defaultGrain }, at = {};
  const finding = element("p", { class: "finding", role: "status" });
  const pictures = [element("div", { class: "picture" }), ...(words.second ? [element("div", { class: "picture" })] : [])];
  const draw = () => {
    const drawn = step.picture(granum, grain, at, texts, words);
    const sentence = filled(words.finding, drawn.values);
    finding.replaceChildren(...worded(sentence));
    const shown = drawn.rose ? [`<div class="rose">${rose(drawn.rose, words.title, plain(sentence))}</div>`] : drawn.charts.map((what) => chart({ finding: plain(sentence), ...what, title: plain(what.title) }));
    shown.forEach((html, k) => { pictures[k].innerHTML = html; });
  };
  const controls = Object.entries(step.controls).map(([key, range]) => {
    const id = `${number + 1}${key}`;
    const put = (of, value) => {
      of[key] = value;
      address.put(id, value);
      draw();
    };
    if (key === "shape") {
      const laws = powerLaws(granum);
      grain.shape = address.choice(id, range, laws.map((law) => law.name));
      return shapeChoice(id, texts.slider.shape, laws, grain.shape, (shape) => put(grain, shape));
    }
    const [min, max, by, start, unit] = range;
    at[key] = address.number(id, start, min, max);
    return slider({ id, name: texts.slider[key], min, max, step: by, value: at[key], unit, change: (value) => put(at, value) });
  });
  document.getElementById("steps").append(element("div", { class: "step", id: name },
    element("div", {}, element("h3", {}, `${number + 1}. `, ...worded(words.title)), ...filled(words.text, step.facts?.(granum, grain) ?? {}).split("\n").map((part) => element("p", {}, ...worded(part))),
      ...controls, finding, copyButton(texts.link, () => address.link({ step: number + 1 }, String(number + 1)))),
    element("div", {}, ...pictures.flatMap((picture, k) => [picture, saveButton(texts, picture, `${name}${k ? "b" : ""}`)]))));
  drawnToSize(draw);
}
