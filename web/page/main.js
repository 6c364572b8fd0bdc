// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

/// Grains of the page: the paper's, as granum's own scenes have them.
const defaultGrain = {
  shape: "sphere", shearModulus: 30e9, poissonRatio: 0.15, radius: 0.5e-3,
  frictionAngle: (26.5 * Math.PI) / 180,
};

async function unpacked(base64) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

async function start() {
  const texts = JSON.parse(document.getElementById("texts").textContent);
  document.title = texts.title;
  document.getElementById("title").textContent = texts.title;
  document.getElementById("intro").textContent = texts.intro;
  for (const [part, title] of Object.entries(texts.parts)) {
    document.getElementById(`${part}-title`).textContent = title;
    document.getElementById("parts").append(element("a", { href: `#${part}`, onclick: (event) => {
      event.preventDefault();
      document.getElementById(part).scrollIntoView();
    } }, title));
  }
  const compiled = await unpacked(document.getElementById("wasm").textContent);
  const granum = await Granum.create(compiled);
  document.getElementById("footer").textContent = filled(texts.footer, { version: granum.call("version").notes[0] });
  addLesson(granum, texts);
  addCalculator(granum, texts);
  addExperiment(granum, texts);
  addTeachersNotes(texts);
  document.documentElement.dataset.ready = "yes";
}

function addTeachersNotes(texts) {
  const section = document.getElementById("notes");
  section.append(element("p", {}, texts.notes.text));
  for (const [question, answer] of texts.notes.questions)
    section.append(element("details", {}, element("summary", {}, question), element("p", {}, answer)));
}

start().catch((error) => {
  document.getElementById("intro").textContent = `This browser cannot run granum: ${error.message}`;
});
