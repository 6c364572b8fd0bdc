// SPDX-License-Identifier: GPL-3.0-or-later
// The live experiment: a worker makes and compresses a packing, the page shows it and what was measured.
"use strict";

const experimentPressures = [10, 13, 17, 22, 28, 36, 46, 60, 77, 100].map((p) => p * 1e3);
const stateNames = ["pressure", "voidRatio", "contacts", "z", "rattlers", "overlap", "bulk", "network", "affine", "uniformStrain", "relaxed",
  "s", "sError", "atRest"];

class ExperimentPanel {
  constructor(granum, texts) {
    this.granum = granum; // for the contact law; the packing is the worker's
    this.compiled = granum.compiled;
    this.texts = texts;
    this.words = texts.experiment;
    this.states = [];
    this.worker = null;
    this.phase = "none"; // compression, compressed, shear
    this.build();
    this.drawStates();
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
    this.inputs = { shape: shape[0], density: density[0], sizes: sizes[0], grains: grains[0], seed: seed[0] };
    this.buttons = {};
    const button = (name, text, act, more = {}) => (this.buttons[name] = element("button", { id: `x${name}`, onclick: act, ...more }, text));
    const bar = element("div", {},
      button("start", w.start, () => this.start("run"), { class: "first" }),
      button("step", w.step, () => this.step()),
      button("shear", w.shear, () => this.shear("run"), { disabled: true }),
      button("pause", w.pause, () => this.pause(), { disabled: true }),
      button("stop", w.stop, () => this.end(w.stopped), { disabled: true }),
      button("csv", w.csv, () => saveFile("granum-experiment.csv", this.csv(), "text/csv"), { disabled: true }));
    this.status = element("p", { role: "status", id: "xstatus" }, w.idle);
    this.canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": w.view });
    this.picture = element("div", { class: "picture", id: "xchart" });
    this.table = element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": w.chart });
    const slice = element("input", { type: "range", min: 0.1, max: 1.1, step: 0.05, value: 1.1, oninput: () => this.viewed({ slice: Number(slice.value) }) });
    const show = element("fieldset", {}, element("legend", {}, w.show), ...[[false, w.grainsView], [true, w.forcesView]].map(([forces, text]) =>
      element("label", {}, element("input", { type: "radio", name: "xshow", checked: !forces, onchange: () => this.viewed({ forces }) }), ` ${text}`)));
    const save = element("button", { onclick: () => saveFile("granum-experiment.svg", standalone(this.picture.querySelector("svg")), "image/svg+xml") }, this.texts.save);
    document.getElementById("experiment").append(element("p", {}, w.text),
      element("div", { class: "form" }, shape[1], density[1], sizes[1], grains[1], seed[1]), bar, this.status,
      element("div", { class: "panes" },
        element("div", {}, this.canvas, show, element("label", { class: "control" }, w.slice, slice)),
        element("div", {}, this.picture, save)),
      this.table, (this.curves = new ShearCurves(this.texts)).place);
    try {
      this.view = new PackingView(this.canvas);
      this.view.slice = 1.1;
    } catch (error) {
      this.canvas.replaceWith(element("p", { class: "remarks" }, error.message));
    }
  }

  viewed(change) {
    if (this.view) Object.assign(this.view, change).ask();
  }

  start(mode) {
    this.end("");
    const bounded = (input) => Math.min(input.max, Math.max(input.min, Math.round(Number(input.value)) || input.min));
    const setup = {
      grain: { ...defaultGrain, shape: this.inputs.shape.value }, loose: this.inputs.density.value === "loose",
      sigma: Number(this.inputs.sizes.value), grains: bounded(this.inputs.grains), seed: bounded(this.inputs.seed),
    };
    this.states = [];
    this.notAtRest = "";
    this.setup = setup;
    this.viewed({ shape: shapeColourName(setup.grain.shape) });
    this.contactExponent = this.granum.contactCurve(setup.grain, 1e-7, 1).stiffnessExponent;
    this.worker = new Worker(URL.createObjectURL(new Blob([document.getElementById("worker-source").textContent], { type: "text/javascript" })));
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.postMessage({ what: "begin", compiled: this.compiled, setup, pressures: experimentPressures, mode });
    this.curves.clear();
    this.enter("compression", mode, this.words.preparing);
    this.drawStates();
  }
  /// The specimen stays with the worker after its compression, to be sheared once.
  shear(mode) {
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
  end(text) {
    this.worker?.terminate();
    this.worker = null;
    this.showPaused(false);
    this.enter("none", "", text || this.status.textContent);
  }
  enable() {
    const runs = this.phase === "compression" || this.phase === "shear";
    this.buttons.pause.disabled = this.buttons.stop.disabled = !runs;
    this.buttons.shear.disabled = this.phase !== "compressed";
    this.buttons.csv.disabled = this.states.length === 0;
  }

  hear(data) {
    if (data.view && this.view) this.view.show(data.view);
    if (data.what === "compressing") this.status.textContent = filled(this.words.compressing, { p: written(data.pressure / 1e3) });
    if (data.what === "failed") this.end(filled(this.words.failed, data));
    if (data.what === "state") this.hearState(data);
    if (data.what === "point") this.hearPoint(data);
  }

  hearState({ numbers, last }) {
    const state = Object.fromEntries(stateNames.map((name, k) => [name, numbers[k]]));
    this.states.push(state);
    if (!state.atRest) this.notAtRest += ` ${filled(this.words.notAtRest, { p: written(state.pressure / 1e3) })}`;
    this.drawStates();
    this.enable();
    if (!last) {
      if (this.mode === "step") this.showPaused(true);
      return;
    }
    const first = this.states[0];
    this.showPaused(false);
    this.enter("compressed", "", filled(this.words.done, { s: state.s.toFixed(3), error: state.sError.toFixed(3), contact: written(this.contactExponent), z0: written(first.z), z1: written(state.z) }) + this.notAtRest);
  }

  hearPoint({ point, paused }) {
    this.curves.add(point);
    if (point.event === 2) this.end(this.words.unstable);
    else if (point.event === 1) this.end(this.curves.said(this.setup.grain.frictionAngle));
    else if (paused) this.showPaused(true);
  }

  drawStates() {
    const legend = this.texts.legend, axis = this.texts.axis;
    const all = this.states.flatMap((s) => [s.network, s.uniformStrain, s.relaxed]).filter(Number.isFinite).map((G) => G / 1e6);
    const line = (key) => this.states.map((s) => [s.pressure / 1e3, s[key] / 1e6]);
    this.picture.innerHTML = chart({
      title: this.words.chart, finding: filled(this.words.finding, { count: this.states.length }),
      x: { label: axis.pressure, min: 9, max: 110, log: true },
      y: { label: axis.G, min: all.length ? 0.8 * Math.min(...all) : 10, max: all.length ? 1.3 * Math.max(...all) : 500, log: true },
      series: [
        { label: legend.uniformStrain, colour: colours.uniform_strain, points: line("uniformStrain") },
        { label: legend.relaxed, colour: colours.closed_form, points: line("relaxed") },
        { label: legend.network, colour: colours.measured, points: line("network"), line: false, dots: true },
        { label: legend.contact, colour: colours.grey, dash: true, points: this.states.map((s) => [s.pressure / 1e3, (this.states[0].network / 1e6) * (s.pressure / this.states[0].pressure) ** this.contactExponent]) },
      ],
    });
    const cell = (value) => element("td", {}, written(value, 4));
    this.table.replaceChildren(element("table", {},
      element("thead", {}, element("tr", {}, ...this.words.columns.map((name) => element("th", { scope: "col" }, name)))),
      element("tbody", {}, ...this.states.map((s) => element("tr", {},
        ...[s.pressure / 1e3, s.voidRatio, s.contacts, s.z, 100 * s.rattlers, s.network / 1e6, s.uniformStrain / 1e6, s.relaxed / 1e6].map(cell))))));
  }

  csv() {
    const names = ["p_Pa", "e", "C_n", "z_star", "rattler_fraction", "mean_overlap_over_d", "K_network_Pa", "G_network_Pa", "G_affine_Pa", "G_uniform_strain_Pa", "G_relaxed_Pa"];
    return [names.join(","), ...this.states.map((s) => stateNames.slice(0, names.length).map((name) => s[name]).join(","))].join("\n") + "\n";
  }
}

function addExperiment(granum, texts) {
  return new ExperimentPanel(granum, texts);
}
