// SPDX-License-Identifier: GPL-3.0-or-later
// How long the page takes:  node web/measure.mjs [<rounds>]
// Experiments of 1,000 spheres from nothing to 100 kPa with networks at ten pressures, in Node on one thread, each round
// another seed; in Chromium the time until the page is ready, and frames a second of 1,000 grains that turn.
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { grain, pageFile, startModule } from "./tests/native.mjs";

const { chromium } = createRequire(new URL("./tests/", import.meta.url))("playwright-core");
const rounds = Number(process.argv[2] ?? 5);
const median = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const line = (what, all, unit) => console.log(`${what}: ${median(all).toFixed(2)} ${unit} (${Math.min(...all).toFixed(2)} to ${Math.max(...all).toFixed(2)}, ${all.length} rounds)`);

for (const loose of [0, 1]) {
  const first = [], whole = [];
  for (let seed = 1; seed <= rounds; ++seed) {
    const granum = await startModule();
    const begin = performance.now();
    granum.call("experiment_begin", 1, grain.shearModulus, grain.poissonRatio, grain.radius, grain.coneSlope, grain.punchRadius,
      grain.frictionAngle, loose, 0, 1000, seed, 1e4);
    granum.call("experiment_prepare");
    for (const pressure of [10, 13, 17, 22, 28, 36, 46, 60, 77, 100]) {
      granum.call("experiment_compress", pressure * 1e3);
      if (pressure === 10) first.push((performance.now() - begin) / 1e3);
    }
    whole.push((performance.now() - begin) / 1e3);
  }
  line(`${loose ? "loose" : "dense"}, first point`, first, "s");
  line(`${loose ? "loose" : "dense"}, ten pressures`, whole, "s");
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const ready = [], frames = [];
for (let round = 0; round < rounds; ++round) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  const begin = performance.now();
  await page.goto(`${pathToFileURL(pageFile).href}#xgrains=1000&xdensity=dense`);
  await page.waitForSelector("html[data-ready=yes]");
  ready.push((performance.now() - begin) / 1e3);
  await page.click("#xstep");
  await page.waitForFunction(() => document.querySelectorAll("#experiment tbody tr").length === 1, null, { timeout: 0 });
  await page.locator("canvas").scrollIntoViewIfNeeded();
  frames.push(await page.evaluate(() => new Promise((done) => {
    const canvas = document.querySelector("canvas");
    let count = 0;
    const begin = performance.now();
    const turn = () => {
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
      canvas.getContext("webgl2").finish();
      if (++count < 40) requestAnimationFrame(turn);
      else done((count * 1e3) / (performance.now() - begin));
    };
    requestAnimationFrame(turn);
  })));
  await page.close();
}
await browser.close();
line("page ready", ready, "s");
line("1,000 grains that turn", frames, "frames a second");
