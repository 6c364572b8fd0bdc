// SPDX-License-Identifier: GPL-3.0-or-later
// The page in a browser, from a disk.  CHROMIUM names the browser; Debian's is taken otherwise.
import assert from "node:assert/strict";
import fs from "node:fs";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { launched, page as pageText, pageFile, texts, until } from "./native.mjs";

const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
let browser;
before(async () => {
  browser = await launched();
});
after(() => browser?.close());

/// The page, ready, with its first specimen at rest, which drawn without graphics processor would take half of the machine. Whatever it says to the console or asks of the network is held against it.
async function opened(options = {}, hash = "", file = pageFile) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  page.complaints = [];
  page.on("console", (message) => page.complaints.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => page.complaints.push(`error: ${error.message}`));
  page.on("request", (request) => /^(file|blob|data):/.test(request.url()) || page.complaints.push(`request: ${request.url()}`));
  await page.goto(pathToFileURL(file).href + hash);
  await page.waitForSelector("html[data-ready=yes]");
  return page;
}
const findings = (page) => page.$$eval(".step .finding", (all) => all.map((one) => one.textContent));

test("one file of at most 1.3 MB", () => assert.ok(pageText.length <= 1.3e6, `${pageText.length} bytes`));

test("seven steps show their findings, and sliders change them by keyboard only", async () => {
  const page = await opened();
  const first = await findings(page);
  assert.equal(first.length, 7);
  for (const text of first) assert.doesNotMatch(text, /[{}]|NaN|undefined|–/);
  const sliders = await page.$$('#steps input[type="range"]');
  assert.ok(sliders.length >= 6);
  for (const slider of sliders) {
    const before = (await findings(page)).join("\n");
    const at = await slider.inputValue();
    await slider.focus();
    await page.keyboard.press("ArrowLeft");
    assert.notEqual(await slider.inputValue(), at);
    assert.notEqual((await findings(page)).join("\n"), before, `slider ${await slider.getAttribute("id")} changes nothing`);
  }
  await page.locator("#step3 input[type=radio]").first().focus();
  await page.keyboard.press("Space");
  assert.match((await findings(page))[2], /s = 0\.5\b/);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("the address contains the sliders", async () => {
  const page = await opened();
  await page.locator("#step5 input").focus();
  for (let k = 0; k < 4; ++k) await page.keyboard.press("ArrowRight");
  const url = await page.evaluate(() => location.href), said = await findings(page);
  const other = await opened({}, url.slice(url.indexOf("#")));
  assert.deepEqual(await findings(other), said);
  assert.notDeepEqual(await findings(await opened()), said);
  await page.context().close();
  await other.context().close();
});

/// What a place of a chart stands for on its linear axes, read off the labels.
async function axesOf(page, chart) {
  const labels = await page.$$eval(`${chart} svg text.tick`, (all) => all.map((text) => ({
    value: Number(text.textContent), x: Number(text.getAttribute("x")), y: Number(text.getAttribute("y")) - 5, up: text.getAttribute("text-anchor") === "end" })));
  const axis = (marks, at) => {
    const [first, last] = [marks[0], marks.at(-1)];
    return (place) => first.value + ((place - at(first)) * (last.value - first.value)) / (at(last) - at(first));
  };
  return { x: axis(labels.filter(({ up }) => !up), ({ x }) => x), y: axis(labels.filter(({ up }) => up), ({ y }) => y) };
}

test("the calculator answers while typing, and reports errors", async () => {
  const page = await opened();
  const answer = () => page.textContent("#answer");
  const before = await answer();
  assert.match(before, /shear modulus G/);
  assert.doesNotMatch(before, /NaN|undefined/);
  await page.fill("#cvoidRatio", "0.7");
  assert.notEqual(await answer(), before);
  assert.match(await page.textContent("#clines"), /granum estimate --void-ratio 0\.7 /);
  await page.fill("#cvoidRatio", "0.38");
  assert.match(await page.textContent("#answer .slip"), /--void-ratio 0\.38: .* --porosity 0\.38\?/);
  await page.fill("#cvoidRatio", "0.7");
  assert.equal(await page.locator(".slip").count(), 0);
  await page.fill("#cpoissonRatio", "0.7");
  assert.match(await answer(), /grain_poisson_ratio = 0\.7/);
  await page.fill("#cpoissonRatio", "0.2");
  await page.selectOption("#cpreparation", "loose");
  assert.match(await page.textContent("#clines"), /--preparation loose/);
  // A number that was typed is no assumption, though it is the one that stood there: the range has no deviation of it.
  const wide = await answer();
  assert.match(wide, /modulus of the grains/);
  await page.fill("#cgrainModulus", "30");
  assert.match(await page.textContent("#clines"), /--grain-shear-modulus 30GPa/);
  assert.notEqual(await answer(), wide);
  assert.doesNotMatch(await answer(), /modulus of the grains/);
  await page.check("input[name=csame][value=python]");
  assert.match(await page.textContent("#clines"), /preparation="loose"/);
  await page.check("input[name=csame][value=cpp]");
  assert.match(await page.textContent("#clines"), /Input::preparation, "loose"/);
  assert.equal(await page.locator("#answer circle").count(), 6, "five closed forms and the answer");
  const { y } = await axesOf(page, "#answer");
  const [low, high] = (await page.locator("#answer svg").getAttribute("aria-label")).match(/from ([\d.]+) to ([\d.]+)\.$/).slice(1).map(Number);
  const bars = await page.$$eval("#answer svg path.bar", (all) => all.map((bar) => bar.getAttribute("d").match(/V([\d.]+)|[\d.]+ ([\d.]+)h/g).map((part) => Number(part.match(/[\d.]+(?=h)|(?<=V)[\d.]+/)[0]))));
  const ranges = bars.map(([head, foot]) => [y(foot), y(head)]);
  assert.ok(ranges.some(([foot, head]) => Math.abs(foot / low - 1) < 0.01 && Math.abs(head / high - 1) < 0.01), `${JSON.stringify(ranges)} without ${low} to ${high}`);
  const [ladder] = await Promise.all([page.waitForEvent("download"), page.locator("#answer button").click()]);
  assert.match(fs.readFileSync(await ladder.path(), "utf8"), /^<svg[^>]*xmlns=/);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

/// Keys of the fields of the calculator that are seen.
const seenFields = (page) => page.$$eval("#calculator .form", ([form]) => [...form.querySelectorAll("input, select")].filter((one) => one.getClientRects().length > 0).map((one) => one.id.slice(1)));

test("the calculator answers for sands, with the fields that their laws use", async () => {
  const page = await opened();
  assert.deepEqual(await seenFields(page), ["grains", "voidRatio", "pressure", "stressRatio", "anisotropy", "grainModulus", "poissonRatio", "radius", "density", "saturation", "z", "preparation"]);
  const answer = () => page.textContent("#answer"), beads = await answer();
  await page.selectOption("#cgrains", "sand");
  assert.deepEqual(await seenFields(page), ["grains", "sand", "densityBy", "voidRatio", "uniformity", "leastVoidRatio", "largestVoidRatio", "pressure", "stressRatio", "density", "saturation", "strain"]);
  const unnamed = await answer();
  assert.notEqual(unnamed, beads);
  for (const what of ["z*, inferred", "exponent s", "differences between sands"]) assert.ok(unnamed.includes(what), `${what} is not in ${unnamed}`);
  assert.doesNotMatch(unnamed, /NaN|undefined|[{}]|shear strain/);
  assert.match(await page.textContent("#cabout"), /do not use the preparation/);
  await page.fill("#cstrain", "0.01");
  assert.match(await answer(), /G at the shear strain, over G0\.\d+/);
  assert.match(await page.textContent("#clines"), /granum estimate --grain-shape sand .*--strain 0\.01%/);
  await page.click("#answer summary");
  assert.equal(await page.locator("#answer details tbody tr").count(), 9, "published laws");
  // The dot is at G of the answer, on the axes of the picture.
  const G = (await page.textContent("#answer tbody td.answer")).trim();
  assert.ok((await page.locator("#answer circle title").textContent()).endsWith(`: 100, ${G}`));
  assert.equal(await page.locator("#answer polyline").count(), 10, "nine laws and the sand");

  await page.selectOption("#cdensityBy", "relativeDensity");
  assert.deepEqual((await seenFields(page)).slice(0, 5), ["grains", "sand", "densityBy", "relativeDensity", "uniformity"]);
  for (const place of ["#answer", "#inference"]) assert.match(await page.textContent(place), /^Fill in: e\W?min\W*, e\W?max\W*\.$/);
  await page.fill("#cleastVoidRatio", "0.9");
  await page.fill("#clargestVoidRatio", "0.5");
  assert.match(await answer(), /largest_void_ratio = 0\.5/);
  await page.selectOption("#csand", "toyoura");
  assert.deepEqual(await seenFields(page), ["grains", "sand", "densityBy", "relativeDensity", "pressure", "stressRatio", "density", "saturation", "strain"]);
  assert.match(await page.textContent("#clines"), /granum estimate --sand toyoura --relative-density 60% /);
  await page.fill("#crelativeDensity", "");
  assert.match(await answer(), /^Fill in: relative density Dr \[%\]/);
  await page.fill("#crelativeDensity", "75");
  assert.match(await answer(), /shear modulus G/);
  await page.check("input[name=csame][value=python]");
  assert.match(await page.textContent("#clines"), /sand="toyoura"/);
  await page.check("input[name=isame][value=cpp]");
  assert.match(await page.textContent("#ilines"), /infer_sand\(std::span/);

  const forecast = await page.textContent("#inference");
  assert.match(forecast, /Vs \[m\/s\] at 400 kPa/);
  assert.doesNotMatch(forecast, /NaN|undefined|[{}]/);
  await page.fill("#cvalue", "1500");
  assert.match(await page.textContent("#inference"), /cemented/, "granum's own remark");
  await page.fill("#cvalue", "280");
  const url = await page.evaluate(() => location.href), said = await answer(), other = await opened({}, url.slice(url.indexOf("#")));
  assert.equal(await other.textContent("#answer"), said, "the address does not hold the sand");
  await other.emulateMedia({ media: "print" });
  assert.equal((await seenFields(other)).length, 9);
  await other.emulateMedia({ media: null });
  await other.click("#reset");
  await other.waitForFunction(() => document.documentElement.dataset.ready && document.querySelector("#cgrains").value === "sphere");
  assert.equal(await other.textContent("#answer"), beads);
  assert.deepEqual(page.complaints.concat(other.complaints), []);
  await page.context().close();
  await other.context().close();
});

test("a measurement determines the contacts and predictions", async () => {
  const page = await opened();
  const said = () => page.textContent("#inference");
  const before = await said();
  assert.match(before, /z\* at 100 kPa\d\.\d+ ± 0\.0/);
  assert.doesNotMatch(before, /NaN|undefined|{/);
  await page.fill("#cotherPressure", "800");
  assert.match(await said(), /Vs \[m\/s\] at 800 kPa/);
  assert.match(await page.textContent("#ilines"), /granum infer .*--vs 280m\/s\+-2% --predict-pressure 800kPa/);
  await page.selectOption("#cquantity", "G");
  await page.fill("#cvalue", "120");
  assert.match(await page.textContent("#ilines"), /--shear-modulus 120MPa\+-2%/);
  const url = await page.evaluate(() => location.href), now = await said();
  const other = await opened({}, url.slice(url.indexOf("#")));
  assert.equal(await other.textContent("#inference"), now, "the address does not hold the measurement");
  await page.fill("#cvalue", "90000");
  assert.match(await said(), /No number of contacts explains/);
  assert.match(await said(), /with 12 contacts per grain/, "granum's own remark");
  assert.deepEqual(page.complaints, []);
  await page.context().close();
  await other.context().close();
});

test("the page in German has German texts and the same numbers", async () => {
  const page = await opened({}, "", pageFile.replace(/html$/, "de.html")), english = await opened();
  assert.equal(await page.getAttribute("html", "lang"), "de");
  const numbers = (all, sign) => all.map((text) => text.match(new RegExp(`\\d+\\${sign}\\d+`, "g"))?.join(" ").replaceAll(sign, "."));
  const said = await findings(page), theirs = await findings(english);
  assert.deepEqual(numbers(said, ","), numbers(theirs, "."));
  assert.ok(said.every((text) => !/\d\.\d/.test(text)), said.join("\n"));
  said.forEach((text, k) => assert.notEqual(text, theirs[k]));
  assert.doesNotMatch(await page.innerText("main"), /undefined|\$|\{/);
  assert.equal(await page.getAttribute("a.language", "href"), "granum.html");
  assert.deepEqual(page.complaints, []);
  await page.context().close();
  await english.context().close();
});

test("hostile addresses do no harm", async () => {
  const page = await opened({}, "#5z=1e999&4anisotropy=-77&1shape=%3Cscript%3E&xgrains=nonsense&6z10=");
  for (const text of await findings(page)) assert.doesNotMatch(text, /NaN|undefined|–/);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

/// What a screen reader is told of each part: role, name, value, properties.
async function heard(page) {
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send("Accessibility.getFullAXTree");
  return nodes.filter((node) => !node.ignored).map((node) => ({ role: node.role.value, name: node.name?.value ?? "",
    ...Object.fromEntries((node.properties ?? []).map(({ name, value }) => [name, value.value])), said: node.value?.value }));
}

test("screen readers get names, values with units, and findings; keyboard, contrast and odd input work", async () => {
  const page = await opened();
  const parts = await heard(page);
  const sliders = parts.filter(({ role }) => role === "slider");
  assert.equal(sliders.length, 10);
  for (const { role, name } of parts.filter(({ role }) => ["slider", "button", "textbox", "spinbutton", "combobox", "radio", "link", "image", "img"].includes(role)))
    assert.ok(name.trim(), `a ${role} without a name`);
  for (const key of ["overlap", "contacts", "voidRatio", "pressure", "anisotropy", "z", "z10", "roughness"])
    assert.ok(sliders.some(({ name }) => name === texts.slider[key].replaceAll("_", "")), key);
  const spoken = await page.$$eval("#steps input[type=range]", (all) => all.map((one) => one.getAttribute("aria-valuetext")));
  assert.ok(spoken[0].endsWith("µm") && spoken[3].endsWith("kPa"), spoken.join(", "));
  assert.equal(parts.filter(({ role, live }) => role === "status" && live === "polite").length, 2, "what the experiment says, and what a slider came to");
  assert.ok((await page.locator("#step1 math").count()) > 3, "formulas are formulas");
  assert.equal(await page.$eval("#experiment canvas", (canvas) => getComputedStyle(canvas).touchAction), "pan-y");

  await page.locator('[id="4anisotropy"]').fill("0");
  assert.match(await page.textContent("#step4 .finding"), /differ by 0 %/);
  await page.check('input[name="3shape"][value=cone]');
  await page.locator('[id="3pressure"]').fill("10");
  assert.equal(await page.locator("#step3 .mark").count(), 1, "cones at 10 kPa have left the axis");

  await page.fill("#xgrains", "5");
  await page.click("#xstart");
  assert.match(await page.textContent("#xstatus"), /grains = 5.*200.*2000/);
  assert.ok(await page.isDisabled("#xpause"), "it began with another number than was asked for");
  await page.fill("#xgrains", "200");
  await page.fill("#xguess", "2");
  await page.click("#xstart");
  assert.match(await page.textContent("#xstatus"), /= 2: numbers from 0 to 1 /);
  await page.fill("#xguess", "");

  for (const [field, values] of [["#cz", ["0", "3", ""]], ["#cpressure", ["0", "", "100"]], ["#cvoidRatio", ["", "0.6"]]])
    for (const value of values) {
      await page.fill(field, value);
      assert.equal(await page.evaluate(() => [...document.querySelectorAll("svg *")].filter((one) => [...one.attributes].some(({ value }) => /NaN|Infinity/.test(value))).length), 0, `${field} = ${value}`);
      if (value === "" && field !== "#cz") assert.match(await page.textContent("#answer"), /^Fill in: [^=]*$/);
    }
  assert.match(await page.textContent("#answer"), /shear modulus G/);

  const [svg] = await Promise.all([page.waitForEvent("download"), page.locator("#step3 button", { hasText: texts.save }).click()]);
  const saved = fs.readFileSync(await svg.path(), "utf8");
  for (const what of [texts.steps[2].title, texts.shapes.cone, texts.shapes.sphere, "<rect width=", "<desc>"]) assert.ok(saved.includes(what), `${what} is not in the file`);
  const viewBox = () => page.$eval("#step3 svg", (one) => one.getAttribute("viewBox"));
  const before = await viewBox();
  await page.setViewportSize({ width: 390, height: 800 });
  await page.waitForFunction((old) => document.querySelector("#step3 svg").getAttribute("viewBox") !== old, before);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("print has values and choices, and the sheet has its two pages", async () => {
  const page = await opened({}, "#xgrains=400&3shape=cone");
  const pages = async () => (await page.pdf({ format: "A4" })).toString("latin1").match(/\/Type \/Page\n/g).length;
  await page.emulateMedia({ media: "print" });
  const visible = (selector) => page.$$eval(selector, (all) => all.filter((one) => one.getClientRects().length > 0).length);
  assert.equal(await visible("#steps output"), 8);
  assert.equal(await visible("#step3 fieldset label"), 1, "the chosen shape alone");
  assert.equal(await visible("#calculator input[inputmode=decimal]"), 13);
  assert.equal(await visible("canvas, button"), 0);
  await page.emulateMedia({ media: null });
  await page.evaluate(() => { window.print = () => {}; });
  await page.click("#printsheet");
  assert.match(await page.textContent("#sheet"), /400 grains, seed 1 .*10 pressures from 10 to 100 kPa/);
  assert.equal(await pages(), 2);
  await page.click("#printanswers");
  assert.equal(await pages(), 1);
  assert.equal(await page.locator("#sheet tbody tr").count(), 6);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("a link opens one step, a new address is used, reset forgets; a sandboxed frame shows a single step", async () => {
  const page = await opened({}, "#step=5&5z=6");
  assert.ok(await page.$eval("#step5", (step) => Math.abs(step.getBoundingClientRect().top) < 200), "the step is not on the screen");
  const said = await page.textContent("#step5 .finding");
  await page.evaluate(() => { location.hash = "#step=5&5z=4.5"; });
  await page.waitForFunction((old) => document.documentElement.dataset.ready && document.querySelector("#step5 .finding").textContent !== old, said);
  await page.click("#reset");
  await page.waitForFunction(() => document.documentElement.dataset.ready && document.querySelector('[id="5z"]').value === "5");
  assert.doesNotMatch(await page.evaluate(() => location.href), /#./);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "granum-frame-"));
  const file = path.join(folder, "frame.html");
  fs.writeFileSync(file, `<!doctype html><iframe sandbox="allow-scripts" width="900" height="700" src="${pathToFileURL(pageFile).href}?only=step3#3pressure=200"></iframe>`);
  await page.goto(pathToFileURL(file).href);
  const frame = page.frameLocator("iframe");
  await frame.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  assert.equal(await frame.locator(".step:visible").count(), 1);
  assert.equal(await frame.locator("section:visible").count(), 1);
  const finding = await frame.locator("#step3 .finding").textContent();
  assert.match(finding, /At 200 kPa/);
  await frame.locator('[id="3pressure"]').press("ArrowRight");
  assert.notEqual(await frame.locator("#step3 .finding").textContent(), finding);
  fs.rmSync(folder, { recursive: true });
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

for (const [name, options] of Object.entries({
  "wide and light": {},
  "wide and dark": { colorScheme: "dark" },
  "narrow and light": { viewport: { width: 390, height: 800 } },
  "320 pixels, as 640 at 200 %": { viewport: { width: 320, height: 640 }, deviceScaleFactor: 2 },
  "forced colours": { forcedColors: "active" },
  "narrow and dark, reduced motion": { viewport: { width: 390, height: 800 }, colorScheme: "dark", reducedMotion: "reduce" },
}))
  test(`no barriers that axe knows, nothing beyond the edge: ${name}`, async () => {
    const page = await opened({ reducedMotion: "no-preference", ...options });
    for (const kind of ["sphere", "sand"]) {
      await page.selectOption("#cgrains", kind);
      if (kind === "sand") await page.click("#answer summary");
      if (!["320 pixels, as 640 at 200 %", "forced colours"].includes(name)) {
        await page.evaluate(axe);
        const found = await page.evaluate(() => axe.run());
        assert.deepEqual(found.violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target).join(", ")}`), []);
      }
      const beyond = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(beyond <= 0, `${beyond} px`);
      const cut = await page.$$eval("svg", (all) => all.flatMap((svg) => {
        const box = svg.getBoundingClientRect();
        return [...svg.querySelectorAll("text")].filter((text) => {
          const own = text.getBoundingClientRect();
          return own.left < box.left - 1 || own.right > box.right + 1 || own.top < box.top - 1 || own.bottom > box.bottom + 1;
        }).map((text) => text.textContent);
      }));
      assert.deepEqual(cut, [], "text outside of its picture");
    }
    // What a colour means is not lost: swatches and lines of a picture have the same ones, and more than one.
    const seen = await page.evaluate(() => ["#step3 .swatch:not(.band)", "#step3 polyline"].map((all) =>
      [...document.querySelectorAll(all)].map((one) => getComputedStyle(one)[one.matches("polyline") ? "stroke" : "borderTopColor"])));
    assert.deepEqual(seen[0], seen[1]);
    assert.ok(new Set(seen[0]).size === seen[0].length && seen[0].length === 4, seen[0].join(", "));
    assert.deepEqual(page.complaints, []);
    await page.context().close();
  });

test("an experiment runs to its end, is seen, and is kept", async () => {
  const page = await opened({}, "#xgrains=200&xdensity=dense");
  const blank = await page.locator("#experiment canvas").screenshot();
  await page.fill("#xguess", "0.41");
  await page.click("#xstart");
  await page.waitForFunction(() => document.getElementById("xpause").disabled);
  const said = await page.textContent("#xstatus");
  const s = Number(said.match(/s of the network is ([\d.]+)/)[1]);
  assert.ok(s > 0.3 && s < 0.5, said);
  assert.match(said, /0\.41/, "the guess beside what was measured");
  assert.match(await page.textContent("#xruns tbody"), new RegExp(`0\\.41${s.toFixed(3)} ± 0\\.0\\d+0\\.333`));
  assert.match(await page.textContent("#xchart svg"), /s fitted from 10 to 100 kPa/);
  assert.equal(await page.locator(".gallery img").count(), 1);
  assert.ok((await page.locator("#xrose polygon").count()) >= 13, "bars in four quarters and the curve");
  assert.equal(await page.locator("#xstates tr").count(), 10);
  assert.equal(await page.locator("#xchart circle").count(), 10);
  assert.equal(await page.locator("#xchart polyline").count(), 4, "uniform strain, relaxed, slope of the contact, fitted line");
  const grains = await page.locator("#experiment canvas").screenshot();
  assert.ok(!blank.equals(grains), "no grains are drawn");
  const changes = (old) => until(async () => !old.equals(await page.locator("#experiment canvas").screenshot()));
  await page.locator("input[name=xshow]").nth(1).check();
  assert.ok(await changes(grains), "no forces are drawn");
  await page.locator("#experiment canvas").focus();
  const forces = await page.locator("#experiment canvas").screenshot();
  await page.keyboard.press("ArrowLeft");
  assert.ok(await changes(forces), "the picture does not turn");
  const [csv] = await Promise.all([page.waitForEvent("download"), page.click("#xcsv")]);
  const rows = fs.readFileSync(await csv.path(), "utf8").trim().split("\n");
  assert.equal(rows.length, 12);
  assert.match(csv.suggestedFilename(), /^granum-[\d.]+-sphere-dense-200-seed1\.csv$/);
  assert.match(rows[0], /^# granum [\d.]+$/);
  assert.match(rows[1], /^p_Pa,e,C_n,z_star,.*,contact,preparation,lognormal_sigma,grains,seed,roughness_m$/);
  assert.match(rows.at(-1), /,1,sphere,dense,0,200,1,$/);
  const [svg] = await Promise.all([page.waitForEvent("download"), page.locator("#experiment button", { hasText: texts.save }).first().click()]);
  assert.match(fs.readFileSync(await svg.path(), "utf8"), /^<svg[^>]*xmlns=/);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("rough spheres have a roughness of their own, and it is kept", async () => {
  const page = await opened({}, "#xgrains=200&xdensity=dense");
  assert.ok(await page.isHidden("#xroughness"));
  await page.selectOption("#xshape", "rough");
  await page.fill("#xroughness", "500");
  await page.click("#xstep");
  assert.match(await page.textContent("#xstatus"), /= 500.* 1 .*100/);
  await page.fill("#xroughness", "80");
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#xstates tr").length === 1);
  assert.match(await page.textContent("#xchart svg title"), /rough spheres, u₀ 80 nm, dense/);
  const [csv] = await Promise.all([page.waitForEvent("download"), page.click("#xcsv")]);
  assert.match(fs.readFileSync(await csv.path(), "utf8").trim(), /,rough,dense,0,200,1,(8e-8|8\.0+1e-8)$/);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("an experiment goes pressure by pressure, pauses and stops", async () => {
  const page = await opened({}, "#xgrains=200&xdensity=dense");
  const rows = () => page.locator("#xstates tr").count();
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#xstates tr").length === 1);
  await page.waitForTimeout(1500);
  assert.equal(await rows(), 1, "it went on by itself");
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#xstates tr").length === 2);
  await page.click("#xstop");
  assert.equal(await page.textContent("#xstatus"), texts.experiment.stopped);
  assert.equal(await rows(), 2);
  assert.ok(await page.isDisabled("#xshear"), "what was stopped cannot be sheared");
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("after its compression a specimen is sheared step by step, to the end, and kept", async () => {
  const page = await opened({}, "#xgrains=200&xdensity=dense");
  const corners = (name) => page.$eval(`#${name} polyline`, (line) => line.getAttribute("points").split(" ").length).catch(() => 0);
  const disabled = (name) => page.waitForFunction((id) => document.getElementById(id).disabled, name);
  const enabled = (name) => page.waitForFunction((id) => !document.getElementById(id).disabled, name);
  assert.ok(await page.isHidden("#xshearpart"));
  await page.click("#xstart");
  await enabled("xshear");
  await page.click("#xstep"); // of shear: to an axial strain of 0.1 %
  await page.waitForFunction((text) => document.getElementById("xstatus").textContent === text, texts.experiment.paused);
  const first = await corners("xdeviator");
  assert.ok(first > 5, `${first} points`);
  await page.waitForTimeout(1000);
  assert.equal(await corners("xdeviator"), first, "it went on by itself");
  await page.click("#xpause"); // goes on
  await disabled("xpause");
  assert.ok((await corners("xdeviator")) > first);
  assert.equal(await corners("xvolume"), await corners("xdeviator"));
  const said = await page.textContent("#xstatus");
  const angle = Number(said.match(/friction angle of ([\d.]+)°/)[1]);
  assert.ok(angle > 15 && angle < 45, said);
  assert.equal(await page.locator("#xdeviator .mark").count(), 1, "the peak is marked");
  const [csv] = await Promise.all([page.waitForEvent("download"), page.click("#xshearcsv")]);
  const rows = fs.readFileSync(await csv.path(), "utf8").trim().split("\n");
  assert.match(csv.suggestedFilename(), /^granum-[\d.]+-shear-sphere-dense-200-seed1\.csv$/);
  assert.match(rows.shift(), /^# granum [\d.]+$/);
  assert.match(rows[0], /^axial_strain,volumetric_strain,q_Pa,.*,contact,preparation,lognormal_sigma,grains,seed,roughness_m$/);
  assert.ok(Number(rows.at(-1).split(",")[0]) >= 0.03, rows.at(-1));
  // The drawn curve is that of the file; the last point within the axis is the last but one or the last.
  const { x, y } = await axesOf(page, "#xdeviator");
  const drawn = (await page.$eval("#xdeviator polyline", (line) => line.getAttribute("points"))).split(" ").map((point) => point.split(",").map(Number));
  for (const k of [1, Math.floor(drawn.length / 2), drawn.length - 1]) {
    const [strain, , q] = rows[k].split(",").map(Number);
    assert.ok(Math.abs(x(drawn[k][0]) - 100 * strain) < 0.01, `${x(drawn[k][0])} % where the file has ${strain}`);
    assert.ok(Math.abs(y(drawn[k][1]) - q / 1e3) < 0.005 * Math.max(...drawn.map((point) => y(point[1]))), `${y(drawn[k][1])} kPa where the file has ${q} Pa`);
  }
  assert.deepEqual(page.complaints, []);
  await page.fill("#xseed", "2");
  await page.click("#xstep");
  assert.ok(await page.isVisible("#xshearpart"), "the curve is gone");
  await page.waitForFunction(() => document.querySelectorAll("#xstates tr").length === 1);
  assert.equal(await page.locator("#xchart circle").count(), 11, "the first specimen stays beside the second");
  assert.equal(await corners("xdeviator"), drawn.length, "the curve of the first specimen is another one");
  await page.click("#xclear");
  assert.equal(await page.locator("#xchart circle").count(), 0);
  assert.ok(await page.isHidden("#xshearpart"));
  await page.context().close();
});
