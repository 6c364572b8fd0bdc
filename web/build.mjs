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
const scripts = ["module.js", "chart.js", "address.js", "lesson.js", "packing_view.js", "experiment.js", "calculator.js", "main.js"];
const parts = {
  style: part("style.css"),
  texts: JSON.stringify(texts).replaceAll("</", "<\\/"),
  wasm: zlib.gzipSync(fs.readFileSync(wasm), { level: 9 }).toString("base64"),
  worker: part("module.js") + part("worker.js"),
  scripts: scripts.map(part).join("\n"),
};
for (const [name, text] of Object.entries(parts))
  if (/<\/script/i.test(text)) throw new Error(`${name} would end its place in the page early`);
const page = part("page.html").replace(/<!--(\w+)-->/g, (_, name) => parts[name]);
fs.mkdirSync(path.dirname(out), { recursive: true });
fs.writeFileSync(`${out}.part`, page);
fs.renameSync(`${out}.part`, out);
console.log(`${out}: ${(page.length / 1e6).toFixed(2)} MB`);
