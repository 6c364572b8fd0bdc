// SPDX-License-Identifier: GPL-3.0-or-later
// The live experiment: a worker makes and compresses a packing, the page shows it and its measurements.
"use strict";

/// Dense and loose of the paper's three shapes.
const paperSix = ["cone", "sphere", "flat"].flatMap((shape) => [false, true].map((loose) => ({ shape, loose })));
const paperSixGrains = 300;

class ExperimentPanel {
  constructor(granum, texts) {
    this.granum = granum; // for the contact law; the packing is the worker's
    this.compiled = granum.compiled;
    this.texts = texts;
    this.words = texts.experiment;
    this.version = granum.call("version").notes[0];
    this.runs = []; // the last one is the current one
    this.queue = []; // next setups
    this.modulus = "G";
    this.worker = null;
    this.phase = "none"; // compression, compressed, shear
    this.build();
    drawnToSize(() => this.drawStates());
  }
  get run() {
    return this.runs.at(-1);
  }

  build() {
    const w = this.words;
    const select = (key, label, options, start) => {
      const value = address.choice(key, start, options.map(([name]) => name));
      const input = element("select", { id: key, onchange: () => address.put(key, input.value) },
        ...options.map(([name, text]) => element("option", { value: name, selected: name === value }, text)));
      return [input, element("label", {}, label, input)];
    };
    const number = (key, label, min, max, start) => {
      const input = element("input", { id: key, type: "number", min, max, value: address.number(key, start, min, max), onchange: () => address.put(key, input.value) });
      return [input, element("label", {}, label, input)];
    };
    const shape = select("xshape", w.shape, contactLaws.map((law) => [law.name, law.plural]), "sphere");
    const density = select("xdensity", w.density, [["dense", w.dense], ["loose", w.loose]], "loose");
    const sizes = select("xsizes", w.sizes, [["0", w.equal], ["0.2", w.narrow], ["0.35", w.wide]], "0");
    const grains = number("xgrains", w.grains, 200, 2000, 600);
    const seed = number("xseed", w.seed, 1, 999999, 1);
    const roughness = number("xroughness", w.roughness, 1, 100, 50); // rougher ones cannot be opened to be loose
    const guess = element("input", { id: "xguess", type: "number", min: 0, max: 1, step: "any" });
    this.inputs = { shape: shape[0], density: density[0], sizes: sizes[0], grains: grains[0], seed: seed[0], roughness: roughness[0], guess };
    const showRoughness = () => { roughness[1].hidden = shape[0].value !== "rough"; };
    shape[0].addEventListener("change", showRoughness);
    showRoughness();
    this.buttons = {};
    const button = (name, text, act, more = {}) => (this.buttons[name] = element("button", { id: `x${name}`, onclick: act, ...more }, text));
    const bar = element("div", {},
      button("start", w.start, () => this.start("run"), { class: "first" }),
      button("six", w.six, () => this.startSix()),
      button("step", w.step, () => this.step()),
      button("shear", w.shear, () => this.shear("run"), { disabled: true }),
      button("pause", w.pause, () => this.pause(), { disabled: true }),
      button("stop", w.stop, () => this.end(w.stopped), { disabled: true }),
      button("csv", w.csv, () => {
        const { name, text } = runsFile(this.version, this.runs);
        saveFile(name, text, "text/csv");
      }, { disabled: true }),
      button("clear", w.clear, () => this.clear(), { disabled: true }));
    this.status = element("p", { role: "status", id: "xstatus" }, w.idle);
    this.canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": w.view });
    this.picture = element("div", { class: "picture", id: "xchart" });
    this.table = element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": w.chart });
    this.compared = element("div");
    this.rose = element("div", { class: "picture", id: "xrose", hidden: true });
    const slice = element("input", { type: "range", min: 0.1, max: 1.1, step: 0.05, value: 1.1, "aria-valuetext": w.whole, oninput: () => {
      this.viewed({ slice: Number(slice.value) });
      slice.setAttribute("aria-valuetext", slice.value > 1 ? w.whole : `${Math.round(100 * slice.value)} %`);
    } });
    const exaggerated = slider({ id: "xexaggerate", name: w.exaggerate, min: 1, max: 200, step: 1, value: 1, unit: "", format: (times) => `${times} ×`, change: (times) => this.viewed({ exaggeration: times }) });
    const choice = (name, legend, options, change) => element("fieldset", {}, element("legend", {}, legend), ...options.map(([value, text], k) =>
      element("label", {}, element("input", { type: "radio", name, checked: k === 0, onchange: () => change(value) }), ` ${text}`)));
    const show = choice("xshow", w.show, [[false, w.grainsView], [true, w.forcesView]], (forces) => this.viewed({ forces }));
    const modulus = choice("xmodulus", w.modulus, [["G", "G"], ["K", "K"]], (name) => {
      this.modulus = name;
      this.drawStates();
    });
    document.getElementById("experiment").append(...w.text.split("\n").map((part) => element("p", {}, ...worded(part))),
      element("div", { class: "form" }, shape[1], roughness[1], density[1], sizes[1], grains[1], seed[1], element("label", { class: "guess" }, ...worded(w.guess), guess)), bar, this.status,
      element("div", { class: "panes" },
        element("div", {}, this.canvas, show, element("label", { class: "control" }, w.slice, slice), exaggerated, this.rose),
        element("div", {}, modulus, this.picture, saveButton(this.texts, this.picture, "experiment"), this.compared)),
      this.table, (this.curves = new ShearCurves(this.texts)).place);
    this.looks = { slice: 1.1 }; // of the view, which the first specimen opens: WebGL takes a tenth of a second to start
  }

  viewed(change) {
    Object.assign(this.looks, change);
    if (this.view) Object.assign(this.view, change).ask();
  }
  openView() {
    if (this.view !== undefined) return;
    try {
      this.view = Object.assign(new PackingView(this.canvas), this.looks);
    } catch (error) {
      this.view = null;
      this.canvas.replaceWith(element("p", { class: "remarks" }, error.message));
    }
  }

  /// The number in a field, or nothing if it is not allowed; the allowed range is then shown.
  asked(input) {
    const value = Number(input.value), right = input.checkValidity() && (input.value !== "" || input === this.inputs.guess);
    input.toggleAttribute("aria-invalid", !right);
    if (right) return input.value === "" ? NaN : value;
    this.status.textContent = filled(input.step === "any" ? this.words.outsideAny : this.words.outside, { name: input.closest("label").firstChild.textContent, value: input.value, min: written(Number(input.min)), max: written(Number(input.max), 6) });
    input.focus();
    return undefined;
  }
  start(mode) {
    const [grains, seed, guess, roughness] = ["grains", "seed", "guess", "roughness"].map((name) => this.asked(this.inputs[name]));
    if ([grains, seed, guess, roughness].includes(undefined)) return;
    const shape = this.inputs.shape.value, numbers = shape === "rough" ? { roughness: roughness * 1e-9 } : undefined;
    this.queue = [];
    this.make({ grain: { ...defaultGrain, shape, numbers }, loose: this.inputs.density.value === "loose", sigma: Number(this.inputs.sizes.value), grains, seed }, mode, guess);
  }
  startSix() {
    const seed = this.asked(this.inputs.seed);
    if (seed === undefined) return;
    this.queue = paperSix.map(({ shape, loose }) => ({ grain: { ...defaultGrain, shape }, loose, sigma: 0, grains: paperSixGrains, seed }));
    this.make(this.queue.shift(), "run", NaN);
  }
  make(setup, mode, guess) {
    this.leave();
    this.runs = this.runs.filter((run) => run.done);
    this.runs.push({ setup, guess, states: [] });
    this.notAtRest = "";
    this.openView();
    this.viewed({ shape: shapeColourName(setup.grain.shape), reference: null });
    this.worker = new Worker(URL.createObjectURL(new Blob([document.getElementById("worker-source").textContent], { type: "text/javascript" })));
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.postMessage({ what: "begin", compiled: this.compiled, setup, pressures: experimentPressures, mode });
    this.curves.clear();
    this.enter("compression", mode, this.words.preparing);
    this.drawStates();
  }
  clear() {
    this.end("");
    this.runs = [];
    this.curves.clear();
    this.status.textContent = this.words.idle;
    this.enable();
    this.drawStates();
  }
  /// After its compression the worker keeps the specimen, which can be sheared once.
  shear(mode) {
    this.viewed({ reference: this.view?.data });
    this.worker.postMessage({ what: "shear", mode, largestStrain: largestShearStrain });
    this.curves.begin();
    this.enter("shear", mode, this.words.shearing);
  }
  step() {
    if (this.phase === "none") this.start("step");
    else if (this.phase === "compressed") this.shear("step");
    else this.send("step");
  }
  enter(phase, mode, text) {
    this.phase = phase;
    this.mode = mode;
    this.paused = false;
    this.status.textContent = text;
    this.enable();
  }
  send(mode) {
    this.worker.postMessage({ what: "turn", mode });
    this.mode = mode;
    this.showPaused(mode === "pause");
    if (!this.paused) this.status.textContent = this.phase === "shear" ? this.words.shearing : "";
  }
  showPaused(is) {
    this.paused = is;
    this.buttons.pause.textContent = is ? this.words.resume : this.words.pause;
    if (is) this.status.textContent = this.words.paused;
  }
  pause() {
    this.send(this.paused ? "run" : "pause");
  }
  leave() {
    this.worker?.terminate();
    this.worker = null;
    this.showPaused(false);
  }
  end(text) {
    this.leave();
    this.queue = [];
    this.enter("none", "", text || this.status.textContent);
  }
  enable() {
    const runs = this.phase === "compression" || this.phase === "shear";
    this.buttons.pause.disabled = this.buttons.stop.disabled = !runs;
    this.buttons.shear.disabled = this.phase !== "compressed";
    this.buttons.csv.disabled = this.buttons.clear.disabled = !this.run?.states.length;
  }

  hear(data) {
    if (data.view && this.view) this.view.show(data.view);
    if (data.what === "state" || data.what === "point") this.drawRose(data.view);
    if (data.what === "compressing") {
      this.viewed({ reference: this.run.states.length ? this.view?.data : null });
      this.status.textContent = `${this.runs.length > 1 || this.queue.length ? `${nameOf(this.words, this.run)}: ` : ""}${filled(this.words.compressing, { p: written(data.pressure / 1e3) })}`;
    }
    if (data.what === "failed") this.end(filled(this.words.failed, data));
    if (data.what === "state") this.hearState(data);
    if (data.what === "point") this.hearPoint(data);
  }

  hearState({ numbers, last }) {
    const run = this.run, state = Object.fromEntries(stateNames.map((name, k) => [name, numbers[k]]));
    run.states.push(state);
    if (!state.atRest) this.notAtRest += ` ${filled(this.words.notAtRest, { p: written(state.pressure / 1e3) })}`;
    run.done = last;
    this.enable();
    if (!last) {
      this.drawStates();
      if (this.mode === "step") this.showPaused(true);
      return;
    }
    run.image = this.snapshot();
    this.drawStates();
    if (this.queue.length) return this.make(this.queue.shift(), "run", NaN);
    const first = run.states[0];
    this.showPaused(false);
    this.enter("compressed", "", filled(this.words.done, { s: fixed(state.s, 3), error: fixed(state.sError, 3), contact: written(state.contactExponent), z0: written(first.z), z1: written(state.z),
      from: written(first.pressure / 1e3), to: written(state.pressure / 1e3) }) + (Number.isFinite(run.guess) ? ` ${filled(this.words.guessed, { guess: written(run.guess) })}` : "") + this.notAtRest);
  }
  /// A small picture of the specimen in its current view.
  snapshot() {
    if (!this.view) return undefined;
    this.view.draw();
    const small = element("canvas", { width: 160, height: 160 });
    small.getContext("2d").drawImage(this.canvas, 0, 0, 160, 160);
    return small.toDataURL("image/png");
  }
  drawRose(view) {
    this.rose.hidden = !view?.rose.length;
    if (this.rose.hidden) return;
    const [anisotropy, ...bars] = view.rose, words = this.words;
    this.rose.innerHTML = `<div class="rose">${rose(this.granum.fabricCurve(anisotropy, 45), words.rose, filled(words.roseFinding, { a: fixed(anisotropy, 2) }), bars)}</div>` +
      `<p>${escapeText(filled(words.roseFinding, { a: fixed(anisotropy, 2) }))}</p>`;
  }

  hearPoint({ point, paused }) {
    this.curves.add(point);
    if (point.event === 2) this.end(this.words.unstable);
    else if (point.event === 1) this.end(this.curves.peakText(this.run.setup.grain.frictionAngle));
    else if (paused) this.showPaused(true);
  }

  drawStates() {
    this.picture.innerHTML = runsChart(this.granum, this.texts, this.runs, this.modulus);
    const done = this.runs.some((run) => run.done);
    this.compared.replaceChildren(...(done ? [runsTable(this.texts, this.runs), runsGallery(this.texts, this.runs)] : []));
    const cell = (value) => element("td", {}, written(value, 4));
    this.table.replaceChildren(element("table", {},
      element("thead", {}, element("tr", {}, ...this.words.columns.map((name) => element("th", { scope: "col" }, ...worded(name))))),
      element("tbody", { id: "xstates" }, ...(this.run?.states ?? []).map((s) => element("tr", {},
        ...[s.pressure / 1e3, s.voidRatio, s.contacts, s.z, 100 * s.rattlers, s.network / 1e6, s.bulk / 1e6, s.uniformStrain / 1e6, s.relaxed / 1e6].map(cell))))));
  }
}

function addExperiment(granum, texts) {
  return new ExperimentPanel(granum, texts);
}
