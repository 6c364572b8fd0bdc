// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

/// Grains of the page: those of the paper, as in granum's scenes.
const defaultGrain = {
  shape: "sphere", shearModulus: 30e9, poissonRatio: 0.15, radius: 0.5e-3,
  frictionAngle: (26.5 * Math.PI) / 180,
};

/// The module, compiled while it is unpacked.
async function unpacked(base64) {
  const text = atob(base64), packed = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) packed[k] = text.charCodeAt(k);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(stream, { headers: { "Content-Type": "application/wasm" } }));
}

async function start() {
  const texts = JSON.parse(document.getElementById("texts").textContent);
  decimalSign = texts.decimalSign;
  document.getElementById("question").append(...worded(texts.question));
  document.getElementById("intro").append(...worded(texts.intro));
  for (const [part, title] of Object.entries(texts.parts)) {
    document.getElementById(`${part}-title`).textContent = title;
    document.getElementById("parts").append(partLink(part, title));
  }
  document.querySelector(".skip").replaceWith(partLink("lesson", texts.skip, { class: "skip" }));
  document.getElementById("tools").append(copyButton(texts.link, () => address.link()), element("button", { id: "reset", onclick: () => {
    kept.forget();
    address.write(location.href.split("#")[0]);
    location.reload();
  } }, texts.reset), ...Object.entries(texts.languages).filter(([name]) => name !== document.documentElement.lang).map(([name, { file, title }]) => {
    const link = element("a", { href: file, lang: name, hreflang: name, class: "language" }, title);
    const keep = () => link.setAttribute("href", `${file}${location.search}${address.values.size ? `#${address.values}` : ""}`);
    address.heard.push(keep);
    keep();
    return link;
  }));
  const compiled = await unpacked(document.getElementById("wasm").textContent);
  const granum = await Granum.create(compiled);
  for (const law of contactLaws) law.plural = filled(texts.shapes[law.name] ?? law.plural, Object.fromEntries(law.numbers.map(({ key, value }) => [key, written(value)])));
  pageVersion = granum.call("version").notes[0];
  document.getElementById("footer").append(filled(texts.footer, { version: pageVersion }));
  const [first, ...others] = lessonSteps.map((step, number) => (whenThere) => addStep(granum, texts, step, number, whenThere));
  document.getElementById("loading").remove();
  const atOnce = (draw) => draw();
  first(atOnce);
  performance.mark("first step");
  const atTop = !location.hash && !address.only; // else a place below may be what is looked for
  const below = [];
  if (atTop) await drawn(); // what is below the first screen follows
  for (const add of others) add(atTop ? (draw) => below.push(draw) : atOnce);
  addCalculator(granum, texts);
  const panel = addExperiment(granum, texts);
  addTeachersNotes(texts);
  addSheet(granum, texts, panel);
  showPlace();
  performance.mark("ready");
  for (const draw of below) {
    await new Promise((done) => setTimeout(done)); // taps come between
    draw();
  }
  performance.mark("drawn");
  document.documentElement.dataset.ready = "yes";
  for (const want of packingsWanted) want();
  if (!address.only) addHero(granum, texts);
}

/// When the browser has drawn what there is; a tab that is not in sight draws nothing.
const drawn = () => new Promise((done) => {
  requestAnimationFrame(() => setTimeout(done));
  setTimeout(done, 100);
});

/// The step named by the address: alone, or first on the screen.
function showPlace() {
  const alone = address.only && document.getElementById(address.only);
  const parts = [...document.querySelectorAll(".step, main > section")];
  if (alone && parts.includes(alone)) {
    document.body.classList.add("only");
    for (const part of parts) part.hidden = !(part === alone || part.contains(alone));
  }
  const step = document.getElementById(`step${address.values.get("step")}`);
  if (step?.classList.contains("step")) step.scrollIntoView();
  else if (/^#[a-z]+$/.test(location.hash)) document.getElementById(location.hash.slice(1))?.scrollIntoView();
}

function addTeachersNotes(texts) {
  const section = document.getElementById("notes");
  section.append(...texts.notes.text.split("\n").map((part) => element("p", {}, ...worded(part))),
    element("h3", {}, texts.notes.planTitle), element("ol", {}, ...texts.notes.plan.map((part) => element("li", {}, ...worded(part)))));
  for (const [question, answer] of texts.notes.questions)
    section.append(element("details", {}, element("summary", {}, ...worded(question)), element("p", {}, ...worded(answer))));
}

// What is folded up is printed too.
const onPaper = matchMedia("print");
function unfold(open) {
  for (const part of document.querySelectorAll(open ? "details:not([open])" : "details[data-folded]")) {
    part.open = open;
    part.toggleAttribute("data-folded", open);
  }
}
onPaper.addEventListener("change", () => unfold(onPaper.matches));
addEventListener("beforeprint", () => unfold(true));
addEventListener("afterprint", () => unfold(false));

start().catch((error) => {
  const place = document.getElementById("loading") ?? document.getElementById("intro");
  place.textContent = filled(JSON.parse(document.getElementById("texts").textContent).cannot, { message: error.message });
});
