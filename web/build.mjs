// SPDX-License-Identifier: GPL-3.0-or-later
// One HTML file of the page's parts, for each language one:  node build.mjs <granum.wasm> <page.html>
// The module is packed by gzip and written in base64: pages from a disk may not fetch files.
import fs from "node:fs";
import path from "node:path";
import zlib from "node:zlib";
import { fileURLToPath } from "node:url";

const [wasm, out] = process.argv.slice(2);
if (!out) {
  console.error("usage: node build.mjs <granum.wasm> <page.html>");
  process.exit(2);
}
const here = path.join(path.dirname(fileURLToPath(import.meta.url)), "page");
const part = (name) => fs.readFileSync(path.join(here, name), "utf8");
/// A language a file of page/texts; English is the page itself, another language stands beside it.
const languages = Object.fromEntries(fs.readdirSync(path.join(here, "texts")).sort().map((file) => {
  const name = path.basename(file, ".json"), texts = JSON.parse(part(path.join("texts", file)));
  return [name, { texts, file: name === "en" ? path.basename(out) : path.basename(out).replace(/\.html$/, `.${name}.html`) }];
}));
const english = languages.en.texts;
/// Names of a text and of all within, so that no language lacks one.
const namesWithin = (text) => (typeof text === "object" ? Object.entries(text).flatMap(([name, inner]) => [name, ...namesWithin(inner).map((more) => `${name}.${more}`)]) : []);
for (const [name, { texts }] of Object.entries(languages)) {
  const wrong = namesWithin(english).filter((key) => !namesWithin(texts).includes(key)).concat(namesWithin(texts).filter((key) => !namesWithin(english).includes(key)));
  if (wrong.length) throw new Error(`texts of ${name} and of en differ in ${wrong.join(", ")}`);
}
const scripts = ["module.js", "formula.js", "chart.js", "address.js", "drawings.js", "guesses.js", "lesson.js", "packing_view.js", "shear.js", "runs.js", "experiment.js", "sheet.js", "hero.js",
  "same.js", "sand.js", "calculator.js", "calculator_view.js", "main.js"];

/// Rows of the table of colours that all pictures have: name, on white paper, on dark.
const table = fs.readFileSync(path.join(here, "../../include/granum/plot/palette.hpp"), "utf8");
const rows = [...table.matchAll(/\{"(\w+)", "(#[0-9a-f]{6})", "(#[0-9a-f]{6})"\}/g)].map((row) => row.slice(1));
if (rows.length < 2 || rows.at(-1)[0] !== "grey") throw new Error("include/granum/plot/palette.hpp has no rows that this script can read");
const colourRules = (place) => `:root {${rows.map((row) => ` --${row[0]}: ${row[place]};`).join("")} }`;
const names = rows.slice(0, -1).map(([name]) => name).join(" ");

const parts = {
  style: `${colourRules(1)}\n@media (prefers-color-scheme: dark) { ${colourRules(2)} }\n${part("style.css")}`,
  wasm: zlib.gzipSync(fs.readFileSync(wasm), { level: 9 }).toString("base64"),
  worker: part("module.js") + part("worker.js"),
  scripts: scripts.map(part).join("\n").replace("<!--colours-->", names),
};
fs.mkdirSync(path.dirname(out), { recursive: true });
for (const [lang, { texts, file }] of Object.entries(languages)) {
  const others = Object.fromEntries(Object.entries(languages).map(([name, one]) => [name, { file: one.file, title: one.texts.language }]));
  const all = { ...parts, lang, ...Object.fromEntries(["skip", "partsLabel", "title", "loading", "noscript"].map((key) => [key, texts[key]])), texts: JSON.stringify({ ...texts, languages: others }).replaceAll("</", "<\\/") };
  for (const [name, text] of Object.entries(all))
    if (/<\/script/i.test(text)) throw new Error(`${name} would end its place in the page early`);
  const page = part("page.html").replace(/<!--(\w+)-->/g, (_, name) => all[name]);
  const written = path.join(path.dirname(out), file);
  fs.writeFileSync(`${written}.part`, page);
  fs.renameSync(`${written}.part`, written);
  console.log(`${written}: ${(page.length / 1e6).toFixed(2)} MB`);
}
