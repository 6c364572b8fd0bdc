// SPDX-License-Identifier: GPL-3.0-or-later
// The page on the devices of a class: phones held either way, small notebooks, fingers, keyboards, German decimal commas, lost graphics;
// guesses that are kept; what is drawn of several specimens.  CHROMIUM names the browser.
import assert from "node:assert/strict";
import fs from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { launched, page as pageText, pageFile, texts, until } from "./native.mjs";

let browser;
before(async () => {
  browser = await launched();
});
after(() => browser?.close());

const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const germanFile = pageFile.replace(/html$/, "de.html");
async function opened(options = {}, hash = "", file = pageFile) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, reducedMotion: "reduce", permissions: ["clipboard-read", "clipboard-write"], ...options });
  const page = await context.newPage();
  page.complaints = [];
  page.on("console", (message) => page.complaints.push(message.text()));
  page.on("pageerror", (error) => page.complaints.push(error.message));
  await page.goto(pathToFileURL(file).href + hash);
  await page.waitForSelector("html[data-ready=yes]");
  return page;
}
const closed = async (page) => {
  assert.deepEqual(page.complaints, []);
  await page.context().close();
};

for (const [width, height] of [[390, 844], [844, 390], [1366, 625]])
  test(`every slider and its picture are on one screen of ${width} by ${height}`, async () => {
    for (const file of [pageFile, germanFile]) {
      const page = await opened({ viewport: { width, height } }, "", file);
      const tall = await page.$$eval("#steps input[type=range]", (sliders) => sliders.map((slider) => {
        const picture = slider.closest(".play").querySelector(".picture svg").getBoundingClientRect();
        return [slider.id, picture.bottom - slider.closest(".control").getBoundingClientRect().top, picture.height];
      }));
      assert.equal(tall.length, 8);
      for (const [id, far, high] of tall) assert.ok(far <= height && far > 0 && high > 130, `${id}: ${far} px, the picture ${high} px`);
      await closed(page);
    }
  });

test("a swipe across a slider scrolls the page and leaves its value; along it the value changes", async () => {
  const page = await opened({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const slider = page.locator('[id="5z"]');
  const scrolled = () => page.evaluate(() => scrollY);
  const rests = () => until(async () => { // a swiped page rolls on
    const before = await scrolled();
    await page.waitForTimeout(500);
    return (await scrolled()) === before;
  });
  await slider.evaluate((one) => one.scrollIntoView({ block: "center" }));
  await rests();
  const value = await slider.inputValue(), top = await scrolled();
  const touch = await page.context().newCDPSession(page);
  const swipe = async (dx, dy) => {
    const box = await slider.boundingBox();
    const at = { x: box.x + 0.8 * box.width, y: box.y + box.height / 2 };
    await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [at] });
    for (let k = 1; k <= 10; ++k) {
      await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x: at.x + (dx * k) / 10, y: at.y + (dy * k) / 10 }] });
      await page.waitForTimeout(20);
    }
    await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  };
  await swipe(0, -200);
  assert.ok(await until(async () => (await scrolled()) > top + 100), "the page did not scroll");
  await rests();
  assert.equal(await slider.inputValue(), value, "the swipe moved the slider");
  await slider.evaluate((one) => one.scrollIntoView({ block: "center" }));
  await rests();
  await swipe(-150, 0);
  assert.ok(await until(async () => (await slider.inputValue()) !== value), "the slider does not follow a finger");
  await closed(page);
});

test("the wheel scrolls over a picture of grains, with Ctrl it zooms; lost graphics come back", async () => {
  const page = await opened();
  const canvas = page.locator("#hero canvas");
  await page.waitForFunction(() => {
    const picture = document.querySelector("#hero canvas"), small = Object.assign(document.createElement("canvas"), { width: 40, height: 40 }), draw = small.getContext("2d");
    draw.drawImage(picture, 0, 0, 40, 40);
    return draw.getImageData(0, 0, 40, 40).data.some((value, k) => k % 4 === 3 && value > 0);
  });
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.wheel(0, 300);
  assert.ok(await until(() => page.evaluate(() => scrollY > 200)), "the wheel does not scroll");
  await page.evaluate(() => scrollTo(0, 0));
  const seen = () => canvas.evaluate((one) => one.toDataURL());
  const drawn = async () => { // once it changes no more
    let picture;
    await until(async () => picture === (picture = await seen()));
    return picture;
  };
  await canvas.focus();
  const before = await drawn();
  await page.keyboard.press("+");
  assert.ok(await until(async () => (await seen()) !== before), "+ does not zoom");
  const larger = await drawn();
  await canvas.evaluate((one) => {
    window.drawing = one.getContext("webgl2");
    window.lose = window.drawing.getExtension("WEBGL_lose_context");
    window.lose.loseContext();
  });
  assert.ok(await until(async () => (await seen()) !== larger), "nothing was lost");
  await page.evaluate(() => window.lose.restoreContext());
  assert.ok(await until(() => page.evaluate(() => !window.drawing.isContextLost())), "nothing came back");
  assert.ok(await until(async () => (await seen()) === larger), "another picture after the graphics were lost");
  page.complaints = page.complaints.filter((text) => !/CONTEXT_LOST|context lost/i.test(text));
  await closed(page);
});

test("decimal commas and points are one sign in both languages; signs of thousands are refused", async () => {
  for (const [file, locale, sign] of [[pageFile, "en-GB", "."], [germanFile, "de-DE", ","]]) {
    const page = await opened({ locale }, "", file);
    const pressure = async () => (await page.textContent("#clines")).match(/--pressure ([\d.]+)kPa/)?.[1];
    for (const [typed, value] of [["12,5", "12.5"], ["12.5", "12.5"], ["0,25", "0.25"], [".5", "0.5"], ["1e2", "100"]]) {
      await page.fill("#cpressure", typed);
      assert.equal(await pressure(), value, `${typed} in ${locale}`);
    }
    for (const typed of [sign === "." ? "1,000" : "1.000", "12,5,1", "ten", "1 0"]) {
      await page.fill("#cpressure", typed);
      assert.match(await page.textContent("#answer"), new RegExp(`^.${typed.replace(".", "\\.")}.`), typed);
      assert.equal(await page.getAttribute("#cpressure", "aria-invalid"), "");
    }
    await page.fill("#cpressure", "12,5");
    assert.ok(await until(() => new URLSearchParams(new URL(page.url()).hash.slice(1)).get("cpressure") === "12.5"), "the address lost it");
    await page.reload();
    await page.waitForSelector("html[data-ready=yes]");
    assert.equal(await page.inputValue("#cpressure"), `12${sign}5`);
    assert.equal(await pressure(), "12.5");
    assert.equal(await page.inputValue("#cvoidRatio"), `0${sign}6`);
    await closed(page);
  }
});

test("sliders are logarithmic where their axis is: the middle is the geometric mean, the ends are exact", async () => {
  const page = await opened();
  for (const [id, low, high, start] of [["3pressure", 10, 1000, 100], ["7roughness", 5, 1000, 100]]) {
    const slider = page.locator(`[id="${id}"]`), shown = page.locator(`output[for="${id}"]`);
    const value = async () => Number((await shown.textContent()).match(/[\d.]+/)[0]);
    assert.equal(await value(), start);
    await slider.focus();
    await page.keyboard.press("Home");
    assert.equal(await value(), low);
    await page.keyboard.press("End");
    assert.equal(await value(), high);
    await slider.fill(String(5 * Math.round((low + high) / 2 / 5 / (low === 10 ? 2 : 1)) * (low === 10 ? 2 : 1)));
    assert.ok(Math.abs((await value()) / Math.sqrt(low * high) - 1) < 0.1, `${await value()} in the middle`);
    const dot = async () => (await page.$$eval(`#step${id[0]} .mark`, (all) => all.map((mark) => Number(mark.getAttribute("cx")))))[0];
    if (id === "3pressure") assert.ok(Math.abs((await dot()) - (72 + 622) / 2) < 8, "the dot is not in the middle of the axis");
  }
  await page.locator('[id="3pressure"]').focus();
  const values = [];
  for (let k = 0; k < 60; ++k) {
    await page.keyboard.press("ArrowRight");
    values.push(Number((await page.textContent('output[for="3pressure"]')).match(/[\d.]+/)[0]));
  }
  assert.ok(values.includes(200) && values.includes(500), `no round pressures: ${values}`);
  assert.ok(values.every((value, k) => k === 0 || value >= values[k - 1]));
  await closed(page);
});

test("links bring the keyboard with them, Back returns and keeps settings and specimens", async () => {
  const page = await opened({}, "#xgrains=200&xdensity=dense");
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#xstates tr").length === 1);
  await page.evaluate(() => { scrollTo(0, 0); window.same = true; });
  const links = page.locator("#parts a");
  for (const [k, part] of ["lesson", "experiment", "calculator", "notes"].entries()) {
    await links.nth(k).focus();
    await page.keyboard.press("Enter");
    await page.keyboard.press("Tab");
    assert.ok(await page.evaluate((id) => document.activeElement.closest(`#${id}`) !== null, part), part);
  }
  await page.locator('[id="5z"]').fill("6");
  await page.goBack();
  assert.ok(await until(() => /5z=6/.test(page.url())), "the address lost a setting");
  assert.equal(await page.evaluate(() => window.same), true, "the page was loaded again");
  assert.equal(await page.locator("#xstates tr").count(), 1);
  await page.locator(".skip").focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  assert.ok(await page.evaluate(() => document.activeElement.closest("#lesson") !== null));
  await closed(page);
});

test("the other language is at the top and keeps the settings", async () => {
  const page = await opened({}, "#5z=6");
  await page.locator('[id="3pressure"]').fill("500");
  const shown = Number((await page.textContent('output[for="3pressure"]')).match(/[\d.]+/)[0]);
  assert.ok((await page.locator("a.language").boundingBox()).y < 120);
  await page.click("a.language");
  await page.waitForSelector("html[data-ready=yes][lang=de]");
  assert.equal(await page.inputValue('[id="5z"]'), "6");
  assert.equal(Number((await page.textContent('output[for="3pressure"]')).match(/[\d,]+/)[0].replace(",", ".")), shown);
  await closed(page);
});

test("“copied” is true until a setting changes", async () => {
  const page = await opened();
  for (const button of [page.locator("#step3 button", { hasText: texts.link.copy }), page.locator("#tools button").first()]) {
    const handle = await button.elementHandle();
    await handle.click();
    await page.waitForFunction(([one, word]) => one.textContent === word, [handle, texts.link.copied]);
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await page.evaluate((step) => (step ? address.link({ step: 3 }, "3") : address.link()), (await handle.evaluate((one) => one.closest("#step3") !== null))));
    await page.locator('[id="5z"]').focus();
    await page.keyboard.press("ArrowRight");
    assert.equal(await handle.textContent(), texts.link.copy);
  }
  await closed(page);
});

test("a word until the library is there, a sentence without JavaScript", async () => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  for (const [file, language] of [[pageFile, /JavaScript/], [germanFile, /JavaScript/]]) {
    const page = await context.newPage();
    await page.goto(pathToFileURL(file).href);
    assert.ok((await page.textContent("h1")).length > 10);
    assert.match(await page.locator("main").innerText(), language);
    await page.close();
  }
  await context.close();
  assert.match(pageText, new RegExp(`<p id="loading">${texts.loading}</p>`));
  const page = await opened();
  assert.equal(await page.locator("#loading").count(), 0);
  await closed(page);
});

test("a guess takes one tap, is shown beside the answer, and is kept on the device; reset forgets it", async () => {
  const page = await opened();
  for (let step = 1; step <= 7; ++step) {
    const part = page.locator(`#step${step}guess`), buttons = part.locator("button"), answer = part.locator(".answered");
    assert.equal(await buttons.count(), 3, `step ${step}`);
    assert.equal(await answer.textContent(), "", "the answer comes before the guess");
    const said = [];
    for (const k of [0, 1, 2]) {
      await buttons.nth(k).click();
      said.push(await answer.textContent());
      assert.ok(said[k].includes(await buttons.nth(k).textContent()), said[k]);
      assert.equal(await buttons.nth(k).getAttribute("aria-pressed"), "true");
      assert.equal(await part.locator("[aria-pressed=true]").count(), 1);
    }
    const right = said.filter((text) => text.includes(texts.guess.right.split("{guess}")[1].trim()));
    assert.equal(right.length, 1, said.join("\n"));
    for (const text of said) assert.doesNotMatch(text, /NaN|undefined|[{}$]/);
  }
  await page.reload();
  await page.waitForSelector("html[data-ready=yes]");
  assert.equal(await page.locator(".question [aria-pressed=true]").count(), 7, "guesses are forgotten");
  await page.click("#reset");
  await page.waitForFunction(() => document.documentElement.dataset.ready && document.querySelectorAll(".question [aria-pressed=true]").length === 0);
  await closed(page);
});

test("the experiment keeps a guess for each kind, also in the paper's six, each of which has its own labelled line", async () => {
  const page = await opened({}, "#xshape=cone&xdensity=dense");
  await page.locator(".chip").nth(3).click();
  assert.equal(await page.inputValue("#xguess"), "0.5");
  await page.selectOption("#xdensity", "loose");
  assert.equal(await page.inputValue("#xguess"), "", "another kind has another guess");
  await page.fill("#xguess", "0,7");
  await page.selectOption("#xshape", "flat");
  await page.fill("#xguess", "0.1");
  await page.selectOption("#xshape", "cone");
  assert.equal(await page.inputValue("#xguess"), "0.7");
  await page.click("#xsix");
  await page.waitForFunction(() => document.querySelectorAll("#xruns tbody tr").length === 6);
  const rows = await page.$$eval("#xruns tbody tr", (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(rows.map((row) => row[2]), ["0.5", "0.7", "0.7", "0.7", "0.7", "0.1"], "the kind's own guess, or that of the field");
  assert.match(await page.textContent("#xstatus"), /0\.1/);
  const drawn = await page.$eval("#xchart", (chart) => ({
    legend: [...chart.querySelectorAll(".legend li")].map((one) => one.textContent.trim()), names: [...chart.querySelectorAll("svg .name")].map((text) => ({ text: text.textContent, box: text.getBoundingClientRect().toJSON() })),
    lines: [...chart.querySelectorAll("svg polyline")].map((line) => `${line.getAttribute("stroke")} ${line.getAttribute("stroke-dasharray")}`) }));
  assert.deepEqual(drawn.names.map(({ text }) => text).sort(), ["1", "2", "3", "4", "5", "6"]);
  for (const [k, a] of drawn.names.entries())
    for (const b of drawn.names.slice(k + 1)) assert.ok(Math.abs(a.box.top - b.box.top) > 10, `${a.text} lies upon ${b.text}`);
  for (let k = 1; k <= 6; ++k) assert.ok(drawn.legend.some((text) => text.startsWith(`${k}: `) && text.includes("s = ")), `specimen ${k} is not in ${drawn.legend}`);
  for (const shape of ["cone", "sphere", "flat"])
    for (const dash of ["null", "7 5"]) assert.equal(drawn.lines.filter((line) => line === `var(--${shape}) ${dash}`).length, 1, `${shape}, ${dash}: ${drawn.lines}`);
  assert.ok(drawn.legend.some((text) => text === `6: ${texts.legend.relaxed}`), "whose closed forms these are");
  await closed(page);
});

test("dense and loose are sheared side by side on one chart that lasts; stopped specimens stay", async () => {
  const page = await opened({}, "#xgrains=200");
  await page.click("#xpair");
  await page.waitForFunction(() => document.querySelectorAll("#xbeginning polyline").length === 2);
  await page.waitForFunction(() => document.querySelectorAll("#xdeviator .name").length === 2 && document.querySelector("#xshearpart .finding").textContent !== "");
  const [dense, loose] = (await page.textContent("#xshearpart .finding")).match(/q is ([\d.]+) kPa .* ([\d.]+) kPa/).slice(1).map(Number);
  assert.ok(dense > 1.2 * loose, `the contrast that the text names: ${dense} and ${loose} kPa`);
  const legend = await page.$$eval("#xdeviator .legend li", (all) => all.map((one) => one.textContent));
  assert.ok(legend.some((text) => /dense/.test(text)) && legend.some((text) => /loose/.test(text)), legend.join());
  await page.click("#xstop");
  const corners = () => page.$$eval("#xdeviator polyline", (all) => all.map((line) => line.getAttribute("points").split(" ").length));
  const kept = await corners();
  assert.equal(kept.length, 2);
  await page.fill("#xseed", "2");
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#xstates tr").length === 1);
  await page.click("#xstop");
  await page.fill("#xseed", "3");
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#xchart .legend li").length >= 8);
  assert.deepEqual(await corners(), kept, "curves stay");
  assert.equal(await page.locator("#xchart svg .name").count(), 4, "a stopped specimen is gone");
  const [csv] = await Promise.all([page.waitForEvent("download"), page.click("#xshearcsv")]);
  assert.match(csv.suggestedFilename(), /^granum-[\d.]+-shear-2-specimens\.csv$/);
  await page.click("#xclear");
  assert.equal(await page.locator("#xchart svg .name, #xdeviator polyline:visible").count(), 0);
  await closed(page);
});

test("wide tables can be scrolled by keyboard, and show it", async () => {
  const page = await opened({ viewport: { width: 320, height: 640 } }, "#xgrains=200&xdensity=dense");
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#xstates tr").length === 1);
  const wide = await page.$$eval(".scroll", (all) => all.filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => ({ tab: one.tabIndex, name: one.getAttribute("aria-label"), shadow: getComputedStyle(one).backgroundImage })));
  for (const { tab, name, shadow } of wide) assert.ok(tab === 0 && name && /gradient/.test(shadow), JSON.stringify({ tab, name, shadow }));
  await closed(page);
});

test("prints: no page is blank, dots are filled, answers are printed, and no empty experiment", async () => {
  const page = await opened();
  await page.emulateMedia({ media: "print" });
  await page.waitForFunction(() => document.querySelectorAll("#notes details:not([open])").length === 0);
  assert.ok(await page.isHidden("#experiment"), "an empty experiment is printed");
  assert.equal(await page.$eval(".step .swatch, .legend .swatch", (one) => getComputedStyle(one).printColorAdjust), "exact");
  assert.ok(await page.isHidden("#step1guess"), "a question without a guess");
  await page.emulateMedia({ media: null });
  await page.waitForFunction(() => document.querySelectorAll("#notes details[open]").length === 0);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.locator("#notes details:not([open])").count(), 0, "answers are folded up on paper");
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  assert.equal(await page.locator("#notes details[open]").count(), 0);
  await closed(page);
});

/// Widths and looks that page.test.mjs does not have; GRANUM_ALL_WIDTHS=1 takes each of them in both languages.
const light = { colorScheme: "light" }, dark = { colorScheme: "dark" }, paper = { media: "print", colorScheme: "light" };
const looks = process.env.GRANUM_ALL_WIDTHS ? [390, 640, 844, 1280].flatMap((width) => [light, dark, paper].map((look) => [width, look])) : undefined;
for (const [language, file, some] of [["English", pageFile, [[640, dark], [844, light], [1280, paper]]], ["German", germanFile, [[390, light], [844, dark], [1280, paper]]]])
  test(`no barriers that axe knows in ${language}, on screens and on paper, with guesses and an experiment`, async () => {
    const page = await opened({}, "#xgrains=200&xdensity=dense", file);
    await page.click("#xstep");
    await page.waitForFunction(() => document.querySelectorAll("#xstates tr").length === 1 && document.querySelectorAll(".pair svg").length === 4);
    for (let step = 1; step <= 7; ++step) await page.locator(`#step${step}guess button`).first().click();
    await page.evaluate(axe);
    for (const [width, look] of looks ?? some) {
      await page.setViewportSize({ width, height: 844 });
      await page.emulateMedia({ media: null, ...look });
      const found = await page.evaluate(() => axe.run());
      assert.deepEqual(found.violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target).join(", ")}`), [], `${width} px, ${JSON.stringify(look)}`);
      if (!look.media) assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `wider than ${width} px`);
    }
    await closed(page);
  });
