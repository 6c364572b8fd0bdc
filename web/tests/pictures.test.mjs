// SPDX-License-Identifier: GPL-3.0-or-later
// Every picture and report that the native program draws, opened in a browser: texts inside their box and apart from each
// other, contrast of 4.5 and more, light and dark, wide and narrow; reports as quiet and as live as they should be.
// CHROMIUM names the browser, GRANUM_PROGRAM the program.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const program =
  process.env.GRANUM_PROGRAM ?? ["ci", "release"].map((preset) => path.join(root, "build", preset, "granum")).find((file) => fs.existsSync(file));
const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "granum-pictures-"));
const small = ["--grains", "120", "--quiet"];
const few = ["--set", "study.pressures=10kPa,30kPa,100kPa", "--set", "study.probe_pressures=30kPa,100kPa"];
const packing = ["atoms", "contacts"].map((part) => path.join(root, `validation/sizes/lognormal_loose.${part}.gz`)); // 800 grains

/// What each command draws: its name, and its arguments.
const commands = [
  ["sweep p", ["sweep", "--void-ratio", "0.56", "--from", "10kPa", "--to", "200kPa", "--out", "sweep_p.csv", "--picture", "sweep_p.svg"]],
  ["sweep path", ["sweep", "--void-ratio", "0.56", "--path", "txc", "--from", "100kPa", "--friction-angle", "26.5deg", "--out", "sweep_txc.csv", "--picture", "sweep_txc.svg"]],
  ["sweep depth", ["sweep", "--void-ratio", "0.6", "--depth", "1m..20m", "--picture", "sweep_depth.svg"]],
  ["fit", ["fit", path.join(root, "tests/cli/data/hv_dense_cone.csv"), "--modulus-column", "G_hv", "--picture", "fit.svg"]],
  ["infer", ["infer", "--porosity", "0.38", "--grain-shear-modulus", "29GPa", "--grain-poisson-ratio", "0.2", "--grain-density", "2480kg/m3",
    "--pressure", "2.76MPa", "--vs", "587m/s+-1%", "--predict-pressure", "6.89MPa,34.47MPa", "--picture", "infer.svg"]],
  ["analyse", ["analyse", ...packing, "--out", "analyse"]],
  ["verify", ["verify", ...small, ...few, "--out", "verify"]],
  ["reproduce", ["reproduce", ...small, "--set", "study.pressures=25kPa,50kPa,100kPa", "--set", "study.probe_pressures=100kPa",
    "--set", "shear.inertial_number=1e-3", "--set", "shear.largest_strain=0.004", "--set", "shear.strain_step=0.001", "--out", "reproduce"]],
  ["trade", ["trade", "--quick", "--quiet", "--grains", "60", "--set", "study.pressures=20kPa,40kPa,80kPa", "--out", "trade"]],
];

let browser;
before(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
});
after(async () => {
  await browser?.close();
  fs.rmSync(folder, { recursive: true, force: true });
});

/// Draws, unless it was drawn; findings that differ are no failures, and so no exit code.
const drawn = new Map();
function draw(name) {
  if (!drawn.has(name)) {
    const known = new Set(fs.readdirSync(folder, { recursive: true }));
    execFileSync(program, commands.find(([command]) => command === name)[1], { cwd: folder, stdio: ["ignore", "ignore", "pipe"] });
    drawn.set(name, fs.readdirSync(folder, { recursive: true }).filter((file) => !known.has(file)));
  }
  return drawn.get(name);
}
const made = (name, ending) => draw(name).filter((file) => file.endsWith(ending)).map((file) => path.join(folder, file));

/// What is wrong with the texts of the pictures on a page.
function faults() {
  const out = [];
  const channel = (value) => (value <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
  const luminance = (colour) => {
    const [r, g, b] = colour.match(/[\d.]+/g).map(Number).map((v) => channel(v / 255));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const contrast = (a, b) => {
    const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (high + 0.05) / (low + 0.05);
  };
  for (const svg of document.querySelectorAll("svg")) {
    const frame = svg.getBoundingClientRect();
    if (frame.width === 0) continue; // not shown
    const scale = frame.width / (svg.viewBox.baseVal.width || frame.width);
    const paper = svg.querySelector(".paper");
    const ground = paper ? getComputedStyle(paper).fill : "rgb(255, 255, 255)";
    const texts = [...svg.querySelectorAll("text")].map((text) => ({ text, box: text.getBoundingClientRect() }));
    for (const { text, box } of texts) {
      const words = `"${text.textContent}" (${text.getAttribute("class")})`;
      if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1)
        out.push(`${words} sticks out of its picture`);
      const ratio = contrast(getComputedStyle(text).fill, ground);
      if (ratio < 4.5) out.push(`${words} has a contrast of ${ratio.toFixed(1)}`);
    }
    const least = 2 * scale;
    for (let a = 0; a < texts.length; ++a)
      for (let b = a + 1; b < texts.length; ++b) {
        const [p, q] = [texts[a].box, texts[b].box];
        if (Math.min(p.right, q.right) - Math.max(p.left, q.left) > least && Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) > least)
          out.push(`"${texts[a].text.textContent}" lies upon "${texts[b].text.textContent}"`);
      }
    for (const slope of svg.querySelectorAll("text.slope"))
      if (!slope.previousElementSibling?.matches("rect.paper")) out.push(`"${slope.textContent}" is struck through by what is behind it`);
    for (const group of svg.querySelectorAll("g.series")) {
      const ratio = contrast(getComputedStyle(group).color, ground);
      if (ratio < 4.5) out.push(`a series has a contrast of ${ratio.toFixed(1)}`);
    }
    if (!svg.getAttribute("aria-label")) out.push("a picture does not say what is seen in it");
  }
  return out;
}

/// Lets a page note what it should not do.
async function watched(context) {
  const page = await context.newPage();
  page.complaints = [];
  page.on("console", (message) => page.complaints.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => page.complaints.push(`error: ${error.message}`));
  page.on("request", (request) => /^(file|data):/.test(request.url()) || page.complaints.push(`request: ${request.url()}`));
  return page;
}

async function opened(file, options = {}) {
  const page = await watched(await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options }));
  await page.goto(pathToFileURL(file).href);
  return page;
}

/// All pictures that the files hold, in the light and in the dark.
async function check(...files) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  const page = await watched(context);
  for (const file of files) {
    await page.goto(pathToFileURL(file).href);
    await page.evaluate(() => document.querySelectorAll("details").forEach((part) => { part.open = true; }));
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      assert.deepEqual(await page.evaluate(faults), [], `${path.basename(file)}, ${colorScheme}`);
      assert.deepEqual(page.complaints, [], path.basename(file));
    }
  }
  await context.close();
}

for (const [name] of commands)
  test(`pictures of ${name}: texts inside, apart, and to be read`, async () => {
    const files = made(name, ".svg");
    assert.ok(files.length > 0, "nothing was drawn");
    await check(...files);
  });

test("lines of a fit are distinguished by their dashes", () => {
  const dashes = fs.readFileSync(made("fit", ".svg")[0], "utf8").match(/stroke-dasharray="[^"]*"/g);
  assert.ok(new Set(dashes).size >= 2, dashes.join(", "));
});

test("the picture of the ladder", async () => {
  await check(path.join(root, "validation/ladder/ladder.svg"));
});

for (const [name, sentences] of [["analyse", 3], ["verify", 3], ["reproduce", 3], ["trade", 2]])
  test(`the report of ${name}`, async () => {
    const [file] = made(name, "report.html");
    await check(file);
    for (const width of [1280, 390])
      for (const colorScheme of ["light", "dark"]) {
        const page = await opened(file, { colorScheme, viewport: { width, height: 844 } });
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `it is wider than ${width} px`);
        await page.evaluate(axe);
        const { violations } = await page.evaluate(() => axe.run());
        assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target).join(" ")}`), [], `${width} px, ${colorScheme}`);
        await page.context().close();
      }
    const page = await opened(file);
    assert.equal(await page.locator("header h1").count(), 1);
    assert.equal(await page.locator("header .answer p").count(), sentences);
    // Labels of slopes have the colours of their triangles.
    const slopes = await page.$$eval("text.slope", (all) => all.map((text) => [getComputedStyle(text).fill, getComputedStyle(text.previousElementSibling.previousElementSibling).stroke]));
    for (const [text, line] of slopes) assert.equal(text, line);
    assert.equal(slopes.length > 0, name === "verify" || name === "reproduce");
    assert.ok(await page.evaluate(() => document.querySelector("header svg, .row svg").getBoundingClientRect().bottom <= innerHeight), "the first picture is not on the first screen");
    await page.context().close();
  });

test("a report gives values under the pointer, fades series, and shows one modulus at a time", async () => {
  const page = await opened(made("verify", "report.html")[0]);
  const shown = () => page.$$eval("header .panel", (all) => all.filter((panel) => panel.offsetWidth > 0).map((panel) => panel.dataset.choice));
  assert.deepEqual(await shown(), ["G_hv"]);
  await page.click("header .switch button >> text=G_hh");
  assert.deepEqual(await shown(), ["G_hh"]);
  await page.click("header .switch button >> text=G_hv");

  // The value is that of the table: the first dot of the network.
  const csv = fs.readFileSync(made("verify", "log_G_log_p_G_hv.csv")[0], "utf8").trim().split("\n").filter((line) => !line.startsWith("#"));
  const column = csv[0].split(",").indexOf("cone_dense network G_hv_Pa");
  assert.ok(column > 0, csv[0]);
  const expected = Number(csv[2].split(",")[column]) / 1e6; // of 30 kPa
  const dot = page.locator('header .panel[data-choice="G_hv"] .series[data-kind="network, dense"]').first().locator(".dots > *").nth(1);
  const box = await dot.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const said = await page.textContent(".tip");
  const value = Number(said.match(/: ([\d.e+-]+)/)[1]);
  assert.ok(Math.abs(value / expected - 1) < 2e-3, `${said}, expected ${expected}`);
  assert.match(said, /^cone, network, dense: .* MPa at (30|29\.\d+|30\.0\d*) kPa$/);

  const key = page.locator('header .panel[data-choice="G_hv"] .key[data-kind="network, loose"]');
  const faded = () => page.locator('header .panel[data-choice="G_hv"] .series.faded').count();
  assert.equal(await faded(), 0);
  await key.click();
  assert.equal(await faded(), 3);
  await key.focus();
  await page.keyboard.press("Enter");
  assert.equal(await faded(), 0);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

/// Moves the pointer to a place in the coordinates of a picture, and reads what is said there.
async function saidAt(page, svg, x, y) {
  await svg.scrollIntoViewIfNeeded();
  const [left, top] = await svg.evaluate((picture, at) => {
    const place = new DOMPoint(...at).matrixTransform(picture.getScreenCTM());
    return [place.x, place.y];
  }, [x, y]);
  await page.mouse.move(left, top);
  return page.evaluate(() => (document.querySelector(".tip").hidden ? "" : document.querySelector(".tip").textContent));
}

test("roses and force chains give values under the pointer too", async () => {
  // 10,000 grains, so that no bars are joined.
  const large = ["atoms", "contacts"].map((part) => path.join(root, `examples/data/lammps_loose_p50.${part}.gz`));
  execFileSync(program, ["analyse", ...large, "--out", "large"], { cwd: folder, stdio: ["ignore", "ignore", "pipe"] });
  const page = await opened(path.join(folder, "large/report.html"));
  const rose = page.locator("svg:has(circle.rose)").first();
  const { cx, cy, r, most } = await rose.locator("circle.rose").evaluate((circle) => ({
    cx: Number(circle.getAttribute("cx")), cy: Number(circle.getAttribute("cy")), r: Number(circle.getAttribute("r")), most: Number(circle.dataset.most) }));
  const csv = fs.readFileSync(path.join(folder, "large/rose.csv"), "utf8").trim().split("\n").filter((line) => !line.startsWith("#")).map((line) => line.split(","));
  const column = (name) => csv[0].indexOf(name);
  const bins = csv.slice(1);
  assert.equal(bins.length % 18, 0);
  for (const [bin, quadrant] of [[3, [1, -1]], [11, [-1, 1]]]) {
    const row = bins[bins.length - 18 + bin].map(Number);
    const angle = ((bin + 0.5) * Math.PI) / 36;
    // Well inside of the bar, away from the lines.
    const length = (0.5 * row[column("density")] * r) / most;
    const said = await saidAt(page, rose, cx + quadrant[0] * length * Math.sin(angle), cy + quadrant[1] * length * Math.cos(angle));
    const [, value, error, degrees] = said.match(/: ([\d.e-]+) ± ([\d.e-]+) at ([\d.]+)°$/).map(Number);
    assert.ok(Math.abs(value / row[column("density")] - 1) < 1e-3, `${said}, expected ${row[column("density")]}`);
    assert.ok(Math.abs(error / row[column("density_error")] - 1) < 1e-2, said);
    assert.equal(degrees, 5 * bin + 2.5);
  }
  const curve = await rose.locator(".series path.line").first().getAttribute("d");
  const [x, y] = curve.match(/^M([\d.]+),([\d.]+)/).slice(1).map(Number);
  assert.match(await saidAt(page, rose, x, y), /^E\(γ; a = .*\): 0\.0\d+ at 0°$/);
  assert.equal(await saidAt(page, rose, 2, 2), "");

  const chains = page.locator("svg:has(line[data-f])").first();
  const strong = await chains.locator("line[data-f]").evaluateAll((lines) => {
    const number = (line, name) => Number(line.getAttribute(name));
    const widest = lines.reduce((a, b) => (Number(b.dataset.f) > Number(a.dataset.f) ? b : a));
    return { share: Number(widest.dataset.f), mean: Number(widest.parentElement.dataset.mean),
      x: (number(widest, "x1") + number(widest, "x2")) / 2, y: (number(widest, "y1") + number(widest, "y2")) / 2 };
  });
  assert.ok(strong.share > 1.5 && strong.mean > 0);
  const said = await saidAt(page, chains, strong.x, strong.y);
  const [, newton, share] = said.match(/^([\d.e-]+) N, ([\d.]+) of the mean force$/).map(Number);
  assert.equal(share, strong.share);
  assert.ok(Math.abs(newton / (strong.share * strong.mean) - 1) < 1e-3, said);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});
