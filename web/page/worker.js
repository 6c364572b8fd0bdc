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
  };
};

let granum, setup, pressures, next, mode; // run, step or pause

function compressNext() {
  if (next >= pressures.length || mode === "pause") return;
  const pressure = pressures[next++];
  postMessage({ what: "compressing", pressure });
  const { numbers } = granum.call("experiment_compress", pressure);
  postMessage({ what: "state", numbers, last: next === pressures.length, view: view(granum) });
  if (mode === "step") mode = "pause";
  setTimeout(guarded(compressNext), 0); // messages of the page come in between
}

const guarded = (work) => async (...args) => {
  try {
    await work(...args);
  } catch (error) {
    postMessage({ what: "failed", message: error.message });
  }
};

onmessage = guarded(async ({ data }) => {
  if (data.what === "begin") {
    granum = await Granum.create(data.compiled, (g) => postMessage({ what: "frame", view: view(g) }));
    ({ setup, pressures, mode } = data);
    next = 0;
    granum.call("experiment_begin", ...grainNumbers(setup.grain), setup.grain.frictionAngle, setup.loose ? 1 : 0,
      setup.sigma, setup.grains, setup.seed, pressures[0]);
    granum.call("experiment_prepare");
    compressNext();
  } else {
    const waited = mode === "pause";
    mode = data.what;
    if (waited) compressNext();
  }
});
