// SPDX-License-Identifier: GPL-3.0-or-later
// One experiment in a worker of its own: the page stays smooth, and stops it by ending the worker.
"use strict";

const view = (granum) => {
  const e = granum.exports;
  const contacts = e.view_contact_count(), grains = e.view_grain_count();
  return {
    grains: granum.floats(e.view_grains(), 5 * grains),
    contacts: granum.floats(e.view_contacts(), 7 * contacts),
    edge: granum.floats(e.view_edge(), 3),
    rose: granum.floats(e.view_rose(), e.view_rose_count()),
  };
};

let granum, setup, pressures, next, mode; // run, step or pause
let work = null; // the next step: a function, or nothing
let strain, until; // axial strain now, and where a step of shear ends

function goOn() {
  if (!work || mode === "pause") return;
  work();
  setTimeout(guarded(goOn), 0); // messages of the page come in between
}

function compressNext() {
  const pressure = pressures[next++];
  const last = next === pressures.length;
  postMessage({ what: "compressing", pressure });
  const { numbers } = granum.call("experiment_compress", pressure);
  if (last) work = null;
  postMessage({ what: "state", numbers, last, view: view(granum) });
  if (mode === "step") mode = "pause";
}

function shearOn() {
  const point = shearPoint(granum.call("experiment_shear").numbers);
  if (point.event !== 0) work = null;
  strain = point.axialStrain;
  const pausing = mode === "step" && strain >= until;
  if (pausing) mode = "pause";
  postMessage({ what: "point", point, paused: pausing && work !== null, view: view(granum) });
}

const guarded = (act) => async (...args) => {
  try {
    await act(...args);
  } catch (error) {
    work = null;
    postMessage({ what: "failed", message: error.message });
  }
};

const heard = {
  async begin(data) {
    granum = await Granum.create(data.compiled, (g) => postMessage({ what: "frame", view: view(g) }));
    ({ setup, pressures, mode } = data);
    next = 0;
    granum.call("experiment_begin", ...grainNumbers(setup.grain), setup.grain.frictionAngle, setup.loose ? 1 : 0,
      setup.sigma, setup.grains, setup.seed, pressures[0]);
    granum.call("experiment_prepare");
    work = compressNext;
    goOn();
  },
  /// A small packing at rest, and how its grains move in a shear.
  async network({ compiled, setup: { grain, loose, sigma, grains, seed }, pressure }) {
    granum = await Granum.create(compiled);
    granum.call("experiment_begin", ...grainNumbers(grain), grain.frictionAngle, loose ? 1 : 0, sigma, grains, seed, pressure);
    granum.call("experiment_prepare");
    granum.call("experiment_compress", pressure);
    postMessage({ what: "network", numbers: granum.call("experiment_motions").numbers });
  },
  shear(data) {
    granum.call("experiment_shear_begin", data.largestStrain);
    mode = data.mode;
    until = shearStep;
    strain = 0;
    work = shearOn;
    goOn();
  },
  /// run, step or pause
  turn(data) {
    const waited = mode === "pause";
    if (data.mode === "step" && waited) until = strain + shearStep;
    mode = data.mode;
    if (waited) goOn();
  },
};

onmessage = guarded(({ data }) => heard[data.what](data));
