// SPDX-License-Identifier: GPL-3.0-or-later
// The live experiment: workers make, compress and shear specimens, the page shows them and their measurements. Every specimen stays
// until it is cleared, also one that was stopped.
"use strict";

/// Dense and loose of the paper's three shapes.
const paperSix = ["cone", "sphere", "flat"].flatMap((shape) => [false, true].map((loose) => ({ shape, loose })));
const paperSixGrains = 300;
/// Guesses of s that one tap gives.
const usualGuesses = [0, 1 / 3, 0.4, 0.5, 0.6, 0.8];
/// Guesses are kept for each kind of specimen.
const kindOf = ({ grain, loose }) => `${grain.shape} ${loose ? "loose" : "dense"}`;

class ExperimentPanel {
  constructor(granum, texts) {
    this.granum = granum; // for the contact law; the packings are the workers'
    this.compiled = granum.compiled;
    this.texts = texts;
    this.words = texts.experiment;
    this.runs = []; // the last one is the current one
    this.queue = []; // next setups
    this.modulus = "G";
    this.build();
    drawnToSize(() => this.drawStates());
  }
  get run() {
    return this.runs.at(-1);
  }
  /// Specimens that are worked at: in compression or shear.
  get active() {
    return this.runs.filter(({ phase }) => phase === "compression" || phase === "shear");
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
      const input = numberField({ id: key, min, max, "data-whole": true, value: address.number(key, start, min, max), change: (typed) => Number.isFinite(typed) && address.put(key, typed) });
      return [input, element("label", {}, label, input)];
    };
    const shape = select("xshape", w.shape, contactLaws.map((law) => [law.name, law.plural]), "sphere");
    const density = select("xdensity", w.density, [["dense", w.dense], ["loose", w.loose]], "loose");
    const sizes = select("xsizes", w.sizes, [["0", w.equal], ["0.2", w.narrow], ["0.35", w.wide]], "0");
    const grains = number("xgrains", w.grains, 200, 2000, 600);
    const seed = number("xseed", w.seed, 1, 999999, 1);
    const roughness = number("xroughness", w.roughness, 1, 100, 50); // rougher ones cannot be opened to be loose
    const guess = numberField({ id: "xguess", min: 0, max: 1, value: NaN, change: () => this.keepGuess() });
    this.inputs = { shape: shape[0], density: density[0], sizes: sizes[0], grains: grains[0], seed: seed[0], roughness: roughness[0], guess };
    const chips = usualGuesses.map((value) => element("button", { type: "button", class: "chip", onclick: () => {
      guess.value = shownNumber(Number(value.toPrecision(3)));
      this.keepGuess();
    } }, written(value, 2)));
    for (const input of [shape[0], density[0]]) input.addEventListener("change", () => this.showKind());
    this.roughnessLabel = roughness[1];
    this.buttons = {};
    const button = (name, text, act, more = {}) => (this.buttons[name] = element("button", { id: `x${name}`, onclick: act, ...more }, text));
    const bar = element("div", {},
      button("start", w.start, () => this.start("run"), { class: "first" }),
      button("six", w.six, () => this.startSix()),
      button("pair", w.pair, () => this.startPair()),
      button("step", w.step, () => this.step()),
      button("shear", w.shear, () => this.shear(this.run, "run"), { disabled: true }),
      button("pause", w.pause, () => this.pause(), { disabled: true }),
      button("stop", w.stop, () => this.end(w.stopped), { disabled: true }),
      button("csv", w.csv, () => {
        const { name, text } = runsFile(this.runs);
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
    const exaggerated = slider({ id: "xexaggerate", name: w.exaggerate, min: 1, max: 200, step: 1, value: 1, unit: "", log: true, format: (many) => `${many} ×`, change: (many) => this.viewed({ exaggeration: many }) });
    const choice = (name, legend, options, change) => element("fieldset", {}, element("legend", {}, legend), ...options.map(([value, text], k) =>
      element("label", {}, element("input", { type: "radio", name, checked: k === 0, onchange: () => change(value) }), ` ${text}`)));
    const show = choice("xshow", w.show, [[false, w.grainsView], [true, w.forcesView]], (forces) => this.viewed({ forces }));
    const modulus = choice("xmodulus", w.modulus, [["G", "G"], ["K", "K"]], (name) => {
      this.modulus = name;
      this.drawStates();
    });
    this.curves = new ShearCurves(this.texts, () => this.runs);
    document.getElementById("experiment").append(...w.text.split("\n").map((part) => element("p", {}, ...worded(part))),
      element("div", { class: "form" }, shape[1], roughness[1], density[1], sizes[1], grains[1], seed[1]),
      element("div", { class: "guess" }, element("label", { for: "xguess" }, ...worded(w.guess)), guess, element("span", { class: "chips", role: "group", "aria-label": w.guess }, ...chips)), bar, this.status,
      element("div", { class: "panes", id: "xpanes" },
        element("div", {}, this.canvas, show, element("label", { class: "control" }, w.slice, slice), exaggerated, this.rose),
        element("div", {}, modulus, this.picture, saveButton(this.texts, this.picture, () => `experiment-${runsName(this.runs.filter((run) => run.states.length))}`), this.compared)),
      this.table, this.curves.place);
    this.looks = { slice: 1.1 }; // of the view, which the first specimen opens: WebGL takes a tenth of a second to start
    this.showKind();
  }

  /// The kind that is chosen, with the guess for it that this device has.
  showKind() {
    this.roughnessLabel.hidden = this.inputs.shape.value !== "rough";
    this.inputs.guess.value = shownNumber(kept.read("s")[kindOf(this.chosen())] ?? NaN);
  }
  chosen() {
    return { grain: { shape: this.inputs.shape.value }, loose: this.inputs.density.value === "loose" };
  }
  keepGuess() {
    const { typed } = this.inputs.guess, all = kept.read("s"), kind = kindOf(this.chosen());
    if (typed >= 0 && typed <= 1) all[kind] = typed;
    else delete all[kind];
    kept.write("s", all);
  }
  /// The guess for a specimen: that for its kind, or the one in the field.
  guessFor(setup) {
    return kept.read("s")[kindOf(setup)] ?? this.inputs.guess.typed ?? NaN;
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

  /// The number in a field, NaN for no guess, or nothing if it is not allowed; the allowed range is then shown.
  asked(input) {
    const value = input.typed, [min, max] = ["min", "max"].map((name) => Number(input.getAttribute(name))), whole = "whole" in input.dataset;
    const right = (input === this.inputs.guess && Number.isNaN(value)) || (value >= min && value <= max && (!whole || Number.isInteger(value)));
    input.toggleAttribute("aria-invalid", !right);
    if (right) return value;
    const name = (input.closest("label") ?? input.labels[0]).textContent;
    this.status.textContent = filled(whole ? this.words.outside : this.words.outsideAny, { name, value: input.value, min: written(min), max: written(max, 6) });
    input.focus();
    return undefined;
  }
  /// The setup of the fields, or nothing if one is not allowed.
  setup() {
    const [grains, seed, guess, roughness] = ["grains", "seed", "guess", "roughness"].map((name) => this.asked(this.inputs[name]));
    if ([grains, seed, guess, roughness].includes(undefined)) return undefined;
    const shape = this.inputs.shape.value, numbers = shape === "rough" ? { roughness: roughness * 1e-9 } : undefined;
    return { grain: { ...defaultGrain, shape, numbers }, loose: this.inputs.density.value === "loose", sigma: Number(this.inputs.sizes.value), grains, seed };
  }
  start(mode) {
    const setup = this.setup();
    if (!setup) return;
    this.leave();
    this.make(setup, mode);
  }
  startSix() {
    const seed = this.asked(this.inputs.seed), guess = this.asked(this.inputs.guess);
    if (seed === undefined || guess === undefined) return;
    this.leave();
    this.queue = paperSix.map(({ shape, loose }) => ({ grain: { ...defaultGrain, shape }, loose, sigma: 0, grains: paperSixGrains, seed }));
    this.make(this.queue.shift(), "run");
  }
  /// A dense and a loose specimen side by side: compressed, then sheared.
  startPair() {
    const setup = this.setup();
    if (!setup) return;
    this.leave();
    for (const loose of [false, true]) this.make({ ...setup, loose }, "run", true);
  }
  make(setup, mode, thenShear = false) {
    const run = { setup, guess: this.guessFor(setup), states: [], phase: "compression", mode, thenShear, notAtRest: "", worker: newWorker() };
    this.runs = this.runs.filter((one) => one.states.length || one.worker);
    this.runs.push(run);
    this.openView();
    this.viewed({ shape: shapeColourName(setup.grain.shape), reference: null });
    run.worker.onmessage = ({ data }) => this.hear(run, data);
    run.worker.postMessage({ what: "begin", compiled: this.compiled, setup, pressures: experimentPressures, mode });
    this.status.textContent = this.words.preparing;
    this.showPaused(false);
    this.drawStates();
  }
  clear() {
    this.end("");
    this.runs = [];
    this.status.textContent = this.words.idle;
    this.drawStates();
  }
  /// After its compression a worker keeps the specimen, which can be sheared once.
  shear(run, mode) {
    if (run === this.run) this.viewed({ reference: this.view?.data });
    run.worker.postMessage({ what: "shear", mode, largestStrain: largestShearStrain });
    Object.assign(run, { points: [], phase: "shear", mode });
    this.status.textContent = this.words.shearing;
    this.showPaused(false);
    this.curves.draw();
  }
  step() {
    if (this.active.length) this.send("step");
    else if (this.run?.phase === "compressed") this.shear(this.run, "step");
    else this.start("step");
  }
  send(mode) {
    for (const run of this.active) {
      run.worker.postMessage({ what: "turn", mode });
      run.mode = mode;
    }
    this.showPaused(mode === "pause");
    if (!this.paused) this.status.textContent = this.run.phase === "shear" ? this.words.shearing : "";
  }
  showPaused(is) {
    this.paused = is;
    this.buttons.pause.textContent = is ? this.words.resume : this.words.pause;
    if (is) this.status.textContent = this.words.paused;
    this.enable();
  }
  pause() {
    this.send(this.paused ? "run" : "pause");
  }
  /// No worker goes on; what was measured stays.
  leave() {
    for (const run of this.runs) {
      run.worker?.terminate();
      run.worker = null;
      if (run.phase) run.image ??= run === this.run && run.states.length ? this.snapshot() : undefined;
      run.phase = "ended";
    }
    this.runs = this.runs.filter((run) => run.states.length);
    this.queue = [];
    this.showPaused(false);
  }
  end(text) {
    this.leave();
    if (text) this.status.textContent = text;
    this.drawStates();
  }
  enable() {
    const busy = this.active.length > 0, measured = this.runs.some((run) => run.states.length);
    this.buttons.pause.disabled = this.buttons.stop.disabled = !busy;
    this.buttons.shear.disabled = busy || this.run?.phase !== "compressed";
    this.buttons.csv.disabled = this.buttons.clear.disabled = !measured;
  }

  hear(run, data) {
    const current = run === this.run;
    if (data.view && current && this.view) this.view.show(data.view);
    if (current && (data.what === "state" || data.what === "point")) this.drawRose(data.view);
    if (data.what === "compressing" && current) {
      this.viewed({ reference: run.states.length ? this.view?.data : null });
      this.status.textContent = `${this.runs.length > 1 || this.queue.length ? `${nameOf(this.words, run)}: ` : ""}${filled(this.words.compressing, { p: written(data.pressure / 1e3) })}`;
    }
    if (data.what === "failed") this.end(filled(this.words.failed, data));
    if (data.what === "state") this.hearState(run, data);
    if (data.what === "point") this.hearPoint(run, data);
  }

  hearState(run, { numbers, last }) {
    const state = Object.fromEntries(stateNames.map((name, k) => [name, numbers[k]]));
    run.states.push(state);
    if (!state.atRest) run.notAtRest += ` ${filled(this.words.notAtRest, { p: written(state.pressure / 1e3) })}`;
    run.done = last;
    if (last) {
      run.phase = "compressed";
      if (run === this.run) run.image = this.snapshot();
    }
    this.enable();
    this.drawStates();
    if (!last) {
      if (run.mode === "step") this.showPaused(true);
      return;
    }
    if (run.thenShear) {
      this.shear(run, "run");
      return;
    }
    if (this.queue.length) {
      run.worker.terminate();
      run.worker = null;
      run.phase = "ended";
      this.make(this.queue.shift(), "run");
      return;
    }
    this.showPaused(false);
    const first = run.states[0];
    this.status.textContent = filled(this.words.done, { s: fixed(state.s, 3), error: fixed(state.sError, 3), contact: written(state.contactExponent), z0: written(first.z), z1: written(state.z),
      from: written(first.pressure / 1e3), to: written(state.pressure / 1e3) }) + (Number.isFinite(run.guess) ? ` ${filled(this.words.guessed, { guess: written(run.guess) })}` : "") + run.notAtRest;
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

  hearPoint(run, { point, paused }) {
    run.points.push(point);
    this.curves.draw();
    if (point.event === 0) {
      if (paused) this.showPaused(true);
      return;
    }
    run.worker.terminate();
    run.worker = null;
    run.phase = "ended";
    this.showPaused(false);
    if (!this.active.length) this.status.textContent = `${this.runs.length > 1 ? `${nameOf(this.words, run)}: ` : ""}${point.event === 2 ? this.words.unstable : this.curves.peakText(run)}`;
  }

  drawStates() {
    this.picture.innerHTML = runsChart(this.granum, this.texts, this.runs, this.modulus);
    const measured = this.runs.some((run) => run.states.length > 1);
    document.getElementById("xpanes").classList.toggle("empty", !this.run);
    this.compared.replaceChildren(...(measured ? [runsTable(this.texts, this.runs), runsGallery(this.texts, this.runs)] : []));
    const cell = (value) => element("td", {}, written(value, 4));
    this.table.hidden = !this.run?.states.length;
    this.table.replaceChildren(element("table", {},
      element("thead", {}, element("tr", {}, ...this.words.columns.map((name) => element("th", { scope: "col" }, ...worded(name))))),
      element("tbody", { id: "xstates" }, ...(this.run?.states ?? []).map((s) => element("tr", {},
        ...[s.pressure / 1e3, s.voidRatio, s.contacts, s.z, 100 * s.rattlers, s.network / 1e6, s.bulk / 1e6, s.uniformStrain / 1e6, s.relaxed / 1e6].map(cell))))));
    this.curves.draw();
  }
}

function addExperiment(granum, texts) {
  return new ExperimentPanel(granum, texts);
}
