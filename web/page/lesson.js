// SPDX-License-Identifier: GPL-3.0-or-later
// Seven steps: one idea, some pictures, one or two sliders each.
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

/// s of the law of measured sands at a void ratio and 100 kPa.
const sandExponent = (granum, voidRatio) => readAnswer(granum, granum.call("sand_answer", -1, NaN, NaN, NaN, voidRatio, 100 * kPa, 100 * kPa, 2650, 0, NaN)).rows.stress_exponent.value;

/// Two small packings, of few contacts and of many, that a worker makes once for the steps that show them: [{loose, network}].
const smallPackings = { grains: 120, seed: 1, pressure: 10e3, kinds: [true, false] };
let madePackings;
function packingsOf(granum) {
  madePackings ??= Promise.all(smallPackings.kinds.map((loose) => new Promise((done, failed) => {
    const worker = newWorker();
    worker.onmessage = ({ data }) => {
      if (data.what === "failed") failed(new Error(data.message));
      if (data.what !== "network") return;
      worker.terminate();
      done({ loose, network: networkOf(data.numbers) });
    };
    worker.postMessage({ what: "network", compiled: granum.compiled, setup: { grain: defaultGrain, loose, sigma: 0, grains: smallPackings.grains, seed: smallPackings.seed }, pressure: smallPackings.pressure });
  })));
  return madePackings;
}
/// How far grains stray from the mean motion, as root mean squares, over that of the mean motion.
function strayed(network) {
  const carrying = network.grains.filter(({ count }) => count > 0);
  const squares = (of) => carrying.reduce((sum, grain) => sum + of(grain).reduce((all, x) => all + x * x, 0), 0);
  return Math.sqrt(squares(({ moved }) => moved) / squares((grain) => meanMotion(network, grain)));
}
/// Both packings side by side, each with a line of words.
function packingPair(texts, packings, arrows) {
  const all = texts.packings;
  return `<div class="pair">${packings.map(({ loose, network }) => {
    const values = { z: written(network.z), left: written((100 * network.relaxed) / network.affine, 2), strayed: written(strayed(network), 2) };
    const title = filled(loose ? all.few : all.many, values), caption = filled(arrows === "both" ? all.both : all.mean, values);
    return `<figure>${sliceDrawing(network, arrows, title, `${title}. ${caption}`)}<figcaption><b>${escapeText(title)}.</b> ${escapeText(caption)}</figcaption></figure>`;
  }).join("")}</div><p class="caption">${escapeText(all[`${arrows}Legend`])}</p>`;
}

/// Sliders of a step: {key: [min, max, step, start, unit, "log"]}; "shape" is a choice. A picture returns {values, pictures}: charts, or drawings as {svg};
/// `facts` are numbers of its text, `guess` the question before the answer, `packings` the arrows of the small packings.
const lessonSteps = [
  {
    count: 3,
    controls: { shape: "sphere", overlap: [0.02, 1, 0.02, 0.5, "µm"] },
    guess(granum, grain) {
      const factor = 2 ** granum.contactCurve(grain, 1e-7, 1).stiffnessExponent;
      return { options: [times(1), times(factor), times(2)], right: 1, values: { factor: written(factor) } };
    },
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
        pictures: [{ svg: (finding) => contactDrawing(granum, texts, words, laws.filter(({ name }) => name !== "power-law" || name === grain.shape).map((law) => ({ law, grain: of(law.name) })), at.overlap * 1e-6, grain.shape, finding) }, {
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
    packings: "mean",
    form: (granum, grain, voidRatio, contacts) => granum.closedForms(grain, { voidRatio, coordinationNumber: contacts, stressV: 100 * kPa }).uniformStrain,
    guess(granum, grain) {
      const factor = this.form(granum, grain, 0.6, 8).vh / this.form(granum, grain, 0.6, 4).vh;
      return { options: [times(1), times(factor), times(2)], right: 1, values: { factor: written(factor) } };
    },
    picture(granum, grain, at, texts, words) {
      const form = (contacts) => this.form(granum, grain, at.voidRatio, contacts);
      const here = form(at.contacts), line = evenly(4, 8, 60).map((c) => [c, form(c)]);
      return {
        values: { contacts: written(at.contacts), G: written(here.vh / MPa), K: written(here.bulk / MPa) },
        pictures: [{
          title: words.title, x: { label: texts.axis.contacts, min: 4, max: 8 }, y: { label: texts.axis.modulus, min: 0, max: 650 },
          series: [{ label: texts.legend.G, colour: colours.uniform_strain, points: line.map(([c, at]) => [c, at.vh / MPa]) },
            { label: texts.legend.K, colour: colours.uniform_strain, dash: true, points: line.map(([c, at]) => [c, at.bulk / MPa]) }],
          mark: [at.contacts, here.vh / MPa],
        }],
      };
    },
  },
  {
    controls: { shape: "sphere", pressure: [10, 1000, 10, 100, "kPa", "log"] },
    guess(granum, grain) {
      const G = (p) => granum.closedForms(grain, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: p * kPa }).uniformStrain.vh, factor = G(100) / G(10);
      return { options: [times(factor), times(5), times(10)], right: 0, values: { factor: written(factor) } };
    },
    picture(granum, grain, at, texts, words) {
      const form = (shape, p) => granum.closedForms({ ...grain, shape }, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: p * kPa }).uniformStrain;
      const laws = powerLaws(granum), lines = laws.map(({ name }) => spread(10, 1000, 40).map((p) => [p, form(name, p).vh / MPa]));
      const low = form(grain.shape, 30), here = form(grain.shape, at.pressure);
      return {
        values: { p: written(at.pressure), G: written(here.vh / MPa), factor: written(form(grain.shape, 1000).vh / form(grain.shape, 10).vh), slope: written(here.exponent) },
        pictures: [{
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
    form: (granum, grain, anisotropy) => granum.closedForms(grain, { voidRatio: 0.6, coordinationNumber: 5.7, anisotropy, stressV: 100 * kPa }).uniformStrain,
    guess(granum, grain, words) {
      const { vh, hh } = this.form(granum, grain, 0.3);
      const right = vh > hh ? 0 : 2;
      return { options: words.options, right, values: { larger: words.options[right] } };
    },
    picture(granum, grain, at, _texts, words) {
      const form = this.form(granum, grain, at.anisotropy);
      return {
        values: { vh: written(form.vh / MPa), hh: written(form.hh / MPa), percent: written(percentApart(form.vh, form.hh), 2) },
        pictures: [{ svg: (finding) => `<div class="rose">${rose(granum.fabricCurve(at.anisotropy, 45), plain(words.title), finding)}</div>` }],
      };
    },
  },
  {
    controls: { z: [4, 7, 0.05, 5, ""] },
    packings: "both",
    leftAt(granum, grain, z) {
      const { stiffnessExponent, tangentialRatio } = granum.contactCurve(grain, 1e-7, 1);
      return granum.relaxation(z, tangentialRatio, stiffnessExponent).shear;
    },
    guess(granum, grain) {
      const left = [4.1, 6].map((z) => 100 * this.leftAt(granum, grain, z));
      const [few, many] = left.map((share) => written(share, 2));
      return { options: [`${many} %`, "50 %", `${few} %`], right: 2, values: { few, many } };
    },
    picture(granum, grain, at, texts, words, packings) {
      const h = (z) => this.leftAt(granum, grain, z);
      return {
        values: { z: written(at.z), percent: written(100 * h(at.z), 2) },
        pictures: [{
          title: words.title, x: { label: texts.axis.z, min: 4, max: 7 }, y: { label: texts.axis.left, min: 0, max: 1 },
          series: [{ label: texts.legend.relaxed, colour: colours.closed_form, points: evenly(4, 7, 90).map((z) => [z, h(z)]) },
            ...(packings ? [{ label: texts.packings.measured, colour: colours.measured, points: packings.map(({ network }) => [network.z, network.relaxed / network.affine]), line: false, dots: true }] : [])],
          mark: [at.z, h(at.z)],
        }],
      };
    },
  },
  {
    count: 2,
    controls: { z10: [4.3, 6, 0.05, 4.4, ""] },
    guess(granum, grain, words) {
      const { loose, dense } = this.paths(granum, grain, 4.4);
      const right = loose.slope.relaxed > dense.slope.relaxed ? 0 : 2;
      return { options: words.options, right, values: { larger: words.options[right], loose: written(loose.slope.relaxed), dense: written(dense.slope.relaxed) } };
    },
    facts(granum) {
      const [high, low] = [0.5, 0.9].map((e) => written(sandExponent(granum, e), 2));
      return { sandDense: high, sandLoose: low };
    },
    /// Void ratios and rattlers are those of the specimens that the experiment makes.
    paths(granum, grain, z10) {
      this.dense ??= granum.carriedPath(grain, { voidRatio: 0.566, mechanicalCoordinationNumber: 6.1, rattlerFraction: 0.03, pressure: 10 * kPa }, 100 * kPa, 12);
      if (this.z10 !== z10) this.loose = granum.carriedPath(grain, { voidRatio: 0.568, mechanicalCoordinationNumber: z10, rattlerFraction: 0.06, pressure: 10 * kPa }, 100 * kPa, 12);
      this.z10 = z10;
      return { loose: this.loose, dense: this.dense };
    },
    picture(granum, grain, at, texts, words) {
      const { loose, dense } = this.paths(granum, grain, at.z10), first = loose.states[0];
      const line = (path, key, unit) => path.states.map((s) => [s.pressure / kPa, s[key] / unit]);
      const contact = granum.contactCurve(grain, 1e-7, 1).stiffnessExponent, named = texts.experiment;
      const kinds = [[named.isDense, dense, false], [named.isLoose, loose, true]], ends = (path) => [path.states[0], path.states.at(-1)].map(({ z }) => written(z));
      const [[z0, z1], [d0, d1]] = [ends(loose), ends(dense)], axis = { label: texts.axis.pressure, min: 10, max: 100, log: true };
      return {
        values: { z0, z1, d0, d1, s: written(loose.slope.relaxed), dense: written(dense.slope.relaxed), contact: written(contact) },
        pictures: [{
          title: words.title, x: axis, y: { label: texts.axis.G, min: 15, max: 400, log: true },
          series: [
            ...kinds.map(([name, path, dash]) => ({ label: `${texts.legend.relaxed}, ${name}`, colour: colours.closed_form, dash, points: line(path, "relaxed", MPa) })),
            ...kinds.map(([name, path, dash]) => ({ label: `${texts.legend.uniformStrain}, ${name}`, colour: colours.uniform_strain, faint: true, dash, points: line(path, "uniformStrain", MPa) })),
            { label: texts.legend.contact, colour: colours.grey, dash: "dots", points: loose.states.map((s) => [s.pressure / kPa, (first.relaxed / MPa) * (s.pressure / first.pressure) ** contact]) },
          ],
          bands: [sandBand(granum, texts, [10, first.relaxed / MPa], 10, 100)],
        }, {
          title: words.second, x: axis, y: { label: texts.axis.z, min: 4, max: 7 },
          series: kinds.map(([name, path, dash]) => ({ label: `z*, ${name}`, colour: colours.closed_form, dash, points: line(path, "z", 1) })),
        }],
      };
    },
  },
  {
    count: 2,
    controls: { roughness: [5, 1000, 5, 100, "nm", "log"] },
    beside: [5, 50, 500],
    /// How far below and above p* the two drawings are.
    apart: 30,
    guess(granum, grain) {
      const change = (roughness) => granum.closedForms({ ...grain, shape: "rough", numbers: { roughness } }, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: 100 * kPa }).transitionPressure;
      const factor = change(1e-6) / change(1e-7);
      return { options: [times(1), times(10), times(factor)], right: 2, values: { factor: written(factor) } };
    },
    picture(granum, grain, at, texts, words) {
      const [low, high] = [0.1, 1e5]; // kPa
      const form = (u, p) => granum.closedForms({ ...grain, shape: "rough", numbers: { roughness: u * 1e-9 } }, { voidRatio: 0.6, coordinationNumber: 5.7, stressV: p * kPa });
      const s = (u, p) => form(u, p).uniformStrain.exponent, pressures = spread(low, high, 61);
      const line = (u) => granum.call("exponent_path", ...grainNumbers({ ...grain, shape: "rough", numbers: { roughness: u * 1e-9 } }), 0.6, 5.7, low * kPa, high * kPa, pressures.length).numbers.map((s, k) => [pressures[k], s]);
      const change = form(at.roughness, 100).transitionPressure / kPa, [least, most] = granum.call("sand_exponents").numbers;
      const named = (u) => filled(words.curve, { u: written(u) }), rough = { ...grain, shape: "rough", numbers: { roughness: at.roughness * 1e-9 } };
      const regimes = [1 / this.apart, this.apart].map((of) => {
        const [, , share, overlap, radius] = granum.call("rough_contact", ...grainNumbers(rough), form(at.roughness, of * change).meanForce).numbers;
        return { label: `${of < 1 ? `p*/${this.apart}` : `${this.apart} p*`} = ${written(of * change)} kPa`, share, overlap, radius };
      });
      return {
        values: { u: written(at.roughness), change: written(change), first: written(s(at.roughness, 1)), middle: written(s(at.roughness, 100)), last: written(s(at.roughness, 1e4)), half: written(s(at.roughness, change)) },
        pictures: [{ svg: (finding) => roughDrawing(granum, words, rough, at.roughness * 1e-9, regimes, finding) }, {
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

/// `whenThere` takes what draws its pictures: now, or once all of the page can be used.
function addStep(granum, texts, step, number, whenThere) {
  const words = texts.steps[number], name = `step${number + 1}`;
  const grain = { ...defaultGrain }, at = {};
  const finding = element("p", { class: "finding" });
  const pictures = Array.from({ length: step.count ?? 1 }, () => element("div", { class: "picture" }));
  let packings, sentence;
  const draw = () => {
    const drawn = step.picture(granum, grain, at, texts, words, packings);
    sentence = filled(words.finding, drawn.values);
    finding.replaceChildren(...worded(sentence));
    drawn.pictures.forEach((what, k) => { pictures[k].innerHTML = what.svg ? what.svg(plain(sentence)) : chart({ finding: plain(sentence), ...what, title: plain(what.title) }); });
  };
  const controls = Object.entries(step.controls).map(([key, range]) => {
    const id = `${number + 1}${key}`;
    const put = (of, value) => {
      of[key] = value;
      address.put(id, value);
      draw();
      say(plain(sentence));
    };
    if (key === "shape") {
      const laws = powerLaws(granum);
      grain.shape = address.choice(id, range, laws.map((law) => law.name));
      return shapeChoice(id, texts.slider.shape, laws, grain.shape, (shape) => put(grain, shape));
    }
    const [min, max, by, start, unit, log] = range;
    at[key] = address.number(id, start, min, max);
    return slider({ id, name: texts.slider[key], min, max, step: by, value: at[key], unit, log, change: (value) => put(at, value) });
  });
  const save = (picture, k) => saveButton(texts, picture, `${name}${k ? String.fromCharCode(97 + k) : ""}`);
  const small = step.packings && element("div", { class: "picture packings" }, element("p", { class: "waiting" }, texts.packings.waiting));
  document.getElementById("steps").append(element("div", { class: "step", id: name },
    element("div", {}, element("h3", {}, `${number + 1}. `, ...worded(words.title)), ...filled(words.text, step.facts?.(granum, grain) ?? {}).split("\n").map((part) => element("p", {}, ...worded(part))),
      guessPart(texts, words.guess, name, step.guess(granum, { ...defaultGrain }, words.guess)), copyButton(texts.link, () => address.link({ step: number + 1 }, String(number + 1)))),
    element("div", { class: "play" }, ...controls, pictures[0], finding, save(pictures[0], 0), ...pictures.slice(1).flatMap((picture, k) => [picture, save(picture, k + 1)]), ...(small ? [small] : []))));
  whenThere(() => drawnToSize(draw));
  if (!small || (address.only && address.only !== name)) return;
  packingsWanted.push(() => packingsOf(granum).then((made) => {
    packings = made;
    small.innerHTML = packingPair(texts, made, step.packings);
    small.querySelectorAll("figure").forEach((figure, k) => figure.append(saveButton(texts, figure, `${name}-${made[k].loose ? "few" : "many"}-contacts`)));
    draw();
  }, (error) => { small.replaceChildren(element("p", { class: "remarks" }, error.message)); }));
}
/// What the steps do with the small packings, once all of the page is there.
const packingsWanted = [];
