// SPDX-License-Identifier: GPL-3.0-or-later
// Six steps: one idea, one picture, one or two sliders each.
"use strict";

const kPa = 1e3, MPa = 1e6;

/// Values from low to high, with equal steps of the logarithm.
const spread = (low, high, count) => Array.from({ length: count }, (_, k) => low * (high / low) ** (k / (count - 1)));
const evenly = (low, high, count) => Array.from({ length: count }, (_, k) => low + ((high - low) * k) / (count - 1));

/// Sliders of a step: {key: [min, max, step, start, unit]}; "shape" is a choice.
const lessonSteps = [
  {
    controls: { shape: "sphere", overlap: [0.02, 1, 0.02, 0.5, "µm"] },
    picture(granum, grain, at, texts) {
      const curves = contactLaws.map(({ name }) => granum.contactCurve({ ...grain, shape: name }, 1e-6, 100));
      const here = granum.contactCurve(grain, at.overlap * 1e-6, 1);
      const values = { force: written(here.points[0].force), stiffness: written(here.points[0].stiffness / 1e6), alpha: here.alpha === Infinity ? "∞" : written(here.alpha) };
      return {
        values,
        chart: {
          x: { label: texts.axis.overlap, min: 0, max: 1 },
          y: { label: texts.axis.force, min: 0, max: 1.15 * Math.max(...curves.map((c) => c.points.at(-1).force)) },
          series: curves.map((curve, k) => ({
            label: contactLaws[k].plural, colour: shapeColour(contactLaws[k].name), faint: contactLaws[k].name !== grain.shape,
            points: [[0, 0], ...curve.points.map((p) => [p.overlap * 1e6, p.force])],
          })),
          mark: [at.overlap, here.points[0].force],
        },
      };
    },
  },
  {
    controls: { contacts: [4, 8, 0.1, 5.7, ""], voidRatio: [0.5, 0.9, 0.01, 0.6, ""] },
    picture(granum, grain, at, texts) {
      const G = (contacts) => granum.closedForms(grain, { voidRatio: at.voidRatio, coordinationNumber: contacts, stressV: 100 * kPa }).uniformStrain.vh / MPa;
      const here = G(at.contacts);
      return {
        values: { contacts: written(at.contacts), G: written(here) },
        chart: {
          x: { label: texts.axis.contacts, min: 4, max: 8 }, y: { label: texts.axis.G, min: 0, max: 450 },
          series: [{ label: texts.legend.uniformStrain, colour: colours.uniform_strain, points: evenly(4, 8, 60).map((c) => [c, G(c)]) }],
          mark: [at.contacts, here],
        },
      };
    },
  },
  {
    controls: { shape: "sphere", pressure: [10, 1000, 10, 100, "kPa"] },
    picture(granum, grain, at, texts) {
      const form = (shape, p) => granum.closedForms({ ...grain, shape }, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: p * kPa }).uniformStrain;
      const line = (shape) => spread(10, 1000, 40).map((p) => [p, form(shape, p).vh / MPa]);
      const low = form(grain.shape, 30), here = form(grain.shape, at.pressure);
      return {
        values: { p: written(at.pressure), G: written(here.vh / MPa), factor: written(form(grain.shape, 1000).vh / form(grain.shape, 10).vh), slope: written(here.exponent) },
        chart: {
          x: { label: texts.axis.pressure, min: 10, max: 1000, log: true }, y: { label: texts.axis.G, min: 30, max: 1500, log: true },
          series: contactLaws.map(({ name, plural }) => ({ label: plural, colour: shapeColour(name), faint: name !== grain.shape, points: line(name) })),
          triangle: here.exponent > 0.01 ? { x0: 30, x1: 120, y: low.vh / MPa, slope: here.exponent, text: `s = ${written(here.exponent)}` } : undefined,
          mark: [at.pressure, here.vh / MPa],
        },
      };
    },
  },
  {
    controls: { anisotropy: [-0.6, 0.6, 0.05, 0.3, ""] },
    picture(granum, grain, at, texts, title) {
      const form = granum.closedForms(grain, { voidRatio: 0.6, coordinationNumber: 5.7, anisotropy: at.anisotropy, stressV: 100 * kPa }).uniformStrain;
      const values = { vh: written(form.vh / MPa), hh: written(form.hh / MPa), percent: written(100 * Math.abs(form.vh / form.hh - 1), 2) };
      return { values, rose: granum.fabricCurve(at.anisotropy, 45) };
    },
  },
  {
    controls: { z: [4, 7, 0.05, 5, ""] },
    picture(granum, grain, at, texts) {
      const { stiffnessExponent, tangentialRatio } = granum.contactCurve(grain, 1e-7, 1);
      const h = (z) => granum.relaxation(z, tangentialRatio, stiffnessExponent).shear;
      return {
        values: { z: written(at.z), percent: written(100 * h(at.z), 2) },
        chart: {
          x: { label: texts.axis.z, min: 4, max: 7 }, y: { label: texts.axis.left, min: 0, max: 1 },
          series: [{ label: texts.legend.relaxed, colour: colours.closed_form, points: evenly(4, 7, 90).map((z) => [z, h(z)]) }],
          mark: [at.z, h(at.z)],
        },
      };
    },
  },
  {
    controls: { z10: [4.3, 6, 0.05, 4.4, ""] },
    picture(granum, grain, at, texts) {
      const path = granum.carriedPath(grain, { voidRatio: 0.58, mechanicalCoordinationNumber: at.z10, rattlerFraction: 0.05, pressure: 10 * kPa }, 100 * kPa, 12);
      const first = path.states[0], last = path.states.at(-1);
      const line = (key) => path.states.map((s) => [s.pressure / kPa, s[key] / MPa]);
      const contact = granum.contactCurve(grain, 1e-7, 1).stiffnessExponent;
      return {
        values: { z0: written(first.z), z1: written(last.z), s: written(path.slope.relaxed), contact: written(contact) },
        chart: {
          x: { label: texts.axis.pressure, min: 10, max: 100, log: true }, y: { label: texts.axis.G, min: 15, max: 400, log: true },
          series: [
            { label: texts.legend.uniformStrain, colour: colours.uniform_strain, points: line("uniformStrain") },
            { label: texts.legend.relaxed, colour: colours.closed_form, points: line("relaxed") },
            { label: texts.legend.contact, colour: colours.grey, dash: true, points: path.states.map((s) => [s.pressure / kPa, (first.relaxed / MPa) * (s.pressure / first.pressure) ** contact]) },
          ],
        },
      };
    },
  },
];

function addLesson(granum, texts) {
  lessonSteps.forEach((step, number) => {
    const words = texts.steps[number];
    const grain = { ...defaultGrain };
    const at = {};
    const finding = element("p", { class: "finding" });
    const picture = element("div", { class: "picture" });
    const controls = element("div");
    const draw = () => {
      const drawn = step.picture(granum, grain, at, texts);
      finding.textContent = filled(words.finding, drawn.values);
      const svg = drawn.rose ? `<div class="rose">${rose(drawn.rose, words.title, finding.textContent)}</div>`
        : chart({ title: words.title, finding: finding.textContent, ...drawn.chart });
      picture.innerHTML = svg;
    };
    for (const [name, range] of Object.entries(step.controls)) {
      const key = `${number + 1}${name}`;
      if (name === "shape") {
        grain.shape = address.choice(key, range, contactLaws.map((law) => law.name));
        controls.append(element("fieldset", {}, element("legend", {}, texts.slider.shape), ...contactLaws.map(({ name: shape, plural }) =>
          element("label", {}, element("input", { type: "radio", name: key, value: shape, checked: shape === grain.shape, onchange: () => {
            grain.shape = shape;
            address.put(key, shape);
            draw();
          } }), ` ${plural}`))));
        continue;
      }
      const [min, max, by, start, unit] = range;
      at[name] = address.number(key, start, min, max);
      const shown = element("output", {}, `${written(at[name])} ${unit}`);
      controls.append(element("label", { class: "control" }, texts.slider[name], shown,
        element("input", { type: "range", id: key, min, max, step: by, value: at[name], oninput: (event) => {
          at[name] = Number(event.target.value);
          shown.textContent = `${written(at[name])} ${unit}`;
          address.put(key, at[name]);
          draw();
        } })));
    }
    const save = element("button", { onclick: () => saveFile(`granum-step-${number + 1}.svg`, standalone(picture.querySelector("svg")), "image/svg+xml") }, texts.save);
    document.getElementById("steps").append(element("div", { class: "step", id: `step${number + 1}` },
      element("div", {}, element("h3", {}, `${number + 1}. ${words.title}`), element("p", {}, words.text), controls, finding),
      element("div", {}, picture, save)));
    draw();
  });
}
