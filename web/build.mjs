// SPDX-License-Identifier: GPL-3.0-or-later
// One HTML file of the page's parts:  node build.mjs <granum.wasm> <page.html>
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
const texts = JSON.parse(part("texts.json"));
const scripts = ["module.js", "chart.js", "address.js", "lesson.js", "packing_view.js", "shear.js", "experiment.js", "same.js", "calculator.js", "calculator_view.js", "main.js"];

/// Rows of the table of colours that all pictures have: name, on white paper, on dark.
const table = fs.readFileSync(path.join(here, "../../include/granum/plot/palette.hpp"), "utf8");
const rows = [...table.matchAll(/\{"(\w+)", "(#[0-9a-f]{6})", "(#[0-9a-f]{6})"\}/g)].map((row) => row.slice(1));
if (rows.length < 2 || rows.at(-1)[0] !== "grey") throw new Error("include/granum/plot/palette.hpp has no rows that this script can read");
const colourRules = (place) => `:root {${rows.map((row) => ` --${row[0]}: ${row[place]};`).join("")} }`;
const names = rows.slice(0, -1).map(([name]) => name).join(" ");

const parts = {
  style: `${colourRules(1)}\n@media (prefers-color-scheme: dark) { ${colourRules(2)} }\n${part("style.css")}`,
  texts: JSON.stringify(texts).replaceAll("</", "<\\/"),
  wasm: zlib.gzipSync(fs.readFileSync(wasm), { level: 9 }).toString("base64"),
  worker: part("module.js") + part("worker.js"),
  scripts: scripts.map(part).join("\n").replace("<!--colours-->", names),
};
for (const [name, text] of Object.entries(parts))
  if (/<\/script/i.test(text)) throw new Error(`${name} would end its place in the page early`);
const page = part("page.html").replace(/<!--(\w+)-->/g, (_, name) => parts[name]);
fs.mkdirSync(path.dirname(out), { recursive: true });
fs.writeFileSync(`${out}.part`, page);
fs.renameSync(`${out}.part`, out);
console.log(`${out}: ${(page.length / 1e6).toFixed(2)} MB`);
