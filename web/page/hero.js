// SPDX-License-Identifier: GPL-3.0-or-later
// The first screen: a small specimen that is made and pressed while one reads the question.
"use strict";

const heroSetup = { loose: false, sigma: 0.2, grains: 200, seed: 1 };
/// How long it turns by itself [ms].
const heroTime = 20e3;

function addHero(granum, texts) {
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": texts.hero.view });
  let view;
  try {
    view = new PackingView(canvas);
  } catch {
    return; // no pictures of grains in this browser
  }
  view.slice = 1.1;
  const worker = newWorker();
  let moves = !still, since = performance.now();
  const button = element("button", { onclick: () => {
    moves = !moves;
    since = performance.now();
    button.textContent = moves ? texts.hero.pause : texts.hero.go;
    worker.postMessage({ what: "turn", mode: moves ? "run" : "pause" });
    if (moves) turn();
  } }, moves ? texts.hero.pause : texts.hero.go);
  const rest = () => {
    moves = false;
    button.textContent = texts.hero.go;
  };
  let waiting = false;
  const turn = () => {
    if (waiting) return;
    waiting = true;
    setTimeout(() => {
      waiting = false;
      if (!moves) return;
      if (performance.now() - since > heroTime) return rest();
      if (canvas.getBoundingClientRect().bottom > 0) {
        view.yaw += 0.012;
        view.ask();
      }
      turn();
    }, 50);
  };
  worker.onmessage = ({ data }) => {
    if (data.view) view.show(data.view);
    if (data.what === "failed" || data.last) worker.terminate();
  };
  worker.postMessage({ what: "begin", compiled: granum.compiled, setup: { ...heroSetup, grain: { ...defaultGrain, shape: "sphere" } }, pressures: [10e3, 30e3, 100e3], mode: "run" });
  document.getElementById("hero").append(element("div", {}, canvas, button));
  if (moves) turn();
}
