// SPDX-License-Identifier: GPL-3.0-or-later
// The worksheet (two pages) and its answers (one page), visible only in print. Numbers follow the current settings.
"use strict";

const blank = (wide = "") => element("span", { class: `blank ${wide}` });
const tableRows = (headings, rows) => element("table", {}, element("thead", {}, element("tr", {}, ...headings.map((name) => element("th", { scope: "col" }, ...worded(name))))),
  element("tbody", {}, ...rows.map(([name, ...more]) => element("tr", {}, element("th", { scope: "row" }, name), ...more.map((text) => element("td", {}, text))))));

/// Dense and loose of each of the paper's shapes: [name, setup].
function sheetKinds(words, grains, seed) {
  return paperSix.map(({ shape, loose }) => [`${lawNamed(shape).plural}, ${loose ? words.isLoose : words.isDense}`, { grain: { ...defaultGrain, shape }, loose, sigma: 0, grains, seed }]);
}

function sheetPages(texts, panel) {
  const words = texts.sheet, grains = panel.inputs.grains.typed, seed = panel.inputs.seed.typed;
  const kinds = sheetKinds(texts.experiment, grains, seed);
  const numbers = { grains, seed, from: written(experimentPressures[0] / 1e3), to: written(experimentPressures.at(-1) / 1e3), count: experimentPressures.length };
  const lines = (all) => element("ol", {}, ...all.map((text) => element("li", {}, ...worded(filled(text, numbers)), element("div", { class: "lines" }))));
  return [
    element("section", { class: "leaf" }, element("h2", {}, ...worded(words.title)), element("p", {}, words.name, blank("wide"), words.group, blank()), element("p", {}, ...worded(filled(words.setting, numbers))),
      element("h3", {}, words.predict), element("p", {}, ...worded(words.predictText)), tableRows(words.predictColumns, kinds.map(([name]) => [name, "", ""])),
      element("h3", {}, words.measure), element("p", {}, ...worded(filled(words.measureText, numbers))), tableRows(words.measureColumns, kinds.map(([name]) => [name, "", "", ""]))),
    element("section", { class: "leaf" }, element("h3", {}, words.seeds), element("p", {}, ...worded(words.seedsText)), tableRows(words.seedColumns, [1, 2, 3, 4, 5, 6].map((group) => [`${group}`, "", "", ""])),
      element("h3", {}, words.compare), lines(words.questions)),
  ];
}

function answerPage(granum, texts, panel) {
  const words = texts.sheet, grains = panel.inputs.grains.typed;
  const measured = (setup) => panel.runs.filter((run) => run.done && run.setup.grain.shape === setup.grain.shape && run.setup.loose === setup.loose).map(measuredS).join("; ") || words.notRun;
  const rows = sheetKinds(texts.experiment, grains, 1).map(([name, setup]) => {
    const [scatter, mean] = granum.call("exponent_scatter", grainNumbers(setup.grain)[0], setup.loose ? 1 : 0, grains).numbers;
    return [name, written(granum.contactCurve(setup.grain, 1e-7, 1).stiffnessExponent), `${fixed(mean, 2)} ± ${written(scatter, 2)}`, measured(setup)];
  });
  return element("section", { class: "leaf" }, element("h2", {}, words.answersTitle), element("p", {}, ...worded(filled(words.answersText, { grains }))), tableRows(words.answerColumns, rows),
    element("ol", {}, ...words.answers.map((text) => element("li", {}, ...worded(text)))));
}

function addSheet(granum, texts, panel) {
  const paper = element("div", { id: "sheet" });
  document.body.append(paper);
  const print = (what, pages) => {
    if (["grains", "seed"].some((name) => panel.asked(panel.inputs[name]) === undefined)) return;
    paper.replaceChildren(...pages());
    document.documentElement.dataset.print = what;
    window.print();
  };
  addEventListener("afterprint", () => delete document.documentElement.dataset.print);
  document.getElementById("notes").append(element("p", {},
    element("button", { id: "printsheet", onclick: () => print("sheet", () => sheetPages(texts, panel)) }, texts.sheet.print),
    element("button", { id: "printanswers", onclick: () => print("answers", () => [answerPage(granum, texts, panel)]) }, texts.sheet.printAnswers)));
}
