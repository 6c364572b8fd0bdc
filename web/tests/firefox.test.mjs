// SPDX-License-Identifier: GPL-3.0-or-later
// The page in Firefox, where there is one: FIREFOX names it, firefox-esr and firefox are looked for otherwise. Playwright drives its own
// builds of it alone, so that a few commands of Marionette, the protocol in every Firefox, do.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import fs from "node:fs";
import net from "node:net";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { pageFile } from "./native.mjs";

const firefox = [process.env.FIREFOX, "firefox-esr", "firefox"].filter(Boolean).find((name) => spawnSync(name, ["--version"]).status === 0);

/// A port that nobody has.
const freePort = () => new Promise((done) => {
  const server = net.createServer().listen(0, "127.0.0.1", () => {
    const { port } = server.address();
    server.close(() => done(port));
  });
});

/// Sends commands, each a message "length:[0, id, name, parameters]", and gives what comes back.
class Marionette {
  static async on(port) {
    for (let tries = 0; ; ++tries) {
      try {
        const socket = net.createConnection(port, "127.0.0.1");
        await new Promise((done, failed) => socket.once("data", done).once("error", failed)); // its greeting
        return new Marionette(socket);
      } catch (error) {
        if (tries > 3000) throw error;
        await new Promise((done) => setTimeout(done, 100));
      }
    }
  }
  constructor(socket) {
    Object.assign(this, { socket, rest: Buffer.alloc(0), id: 0, waiting: new Map() });
    socket.on("data", (data) => this.hear(data));
  }
  hear(data) {
    this.rest = Buffer.concat([this.rest, data]);
    for (;;) {
      const colon = this.rest.indexOf(":"), length = Number(this.rest.subarray(0, Math.max(0, colon)).toString());
      if (colon < 0 || this.rest.length < colon + 1 + length) return;
      const [, id, error, result] = JSON.parse(this.rest.subarray(colon + 1, colon + 1 + length).toString());
      this.rest = this.rest.subarray(colon + 1 + length);
      const { done, failed } = this.waiting.get(id);
      if (error) failed(new Error(`${error.error}: ${error.message}`));
      else done(result);
    }
  }
  call(name, parameters = {}) {
    const text = JSON.stringify([0, ++this.id, `WebDriver:${name}`, parameters]);
    this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    return new Promise((done, failed) => this.waiting.set(this.id, { done, failed }));
  }
  /// The value of an expression in the page.
  async value(expression) {
    return (await this.call("ExecuteScript", { script: `return (${expression});`, args: [] })).value;
  }
  async until(expression) {
    for (const begin = Date.now(); !(await this.value(expression)); await new Promise((done) => setTimeout(done, 200)))
      assert.ok(Date.now() - begin < 240000, `${expression} never came`);
  }
}

test("the page in Firefox: ready, steps, a specimen to its end, grains in sight", { skip: !firefox && "no Firefox" }, async () => {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), "granum-firefox-"));
  const port = await freePort();
  fs.writeFileSync(path.join(profile, "user.js"), `user_pref("marionette.port", ${port});\nuser_pref("app.normandy.enabled", false);\n`);
  const browser = spawn(firefox, ["--headless", "--marionette", "--no-remote", "--profile", profile], { stdio: "ignore", env: { ...process.env, MOZ_DISABLE_CONTENT_SANDBOX: "1" } });
  try {
    const page = await Marionette.on(port);
    await page.call("NewSession");
    await page.call("SetWindowRect", { width: 1280, height: 900 });
    await page.call("Navigate", { url: `${pathToFileURL(pageFile).href}#xgrains=200&xdensity=dense` });
    await page.until("document.documentElement.dataset.ready === 'yes'");
    const findings = await page.value("[...document.querySelectorAll('.step .finding')].map((one) => one.textContent)");
    assert.equal(findings.length, 7);
    for (const text of findings) assert.doesNotMatch(text, /[{}]|NaN|undefined|–/);
    const [width, edge] = await page.value("[document.documentElement.scrollWidth, innerWidth]");
    assert.ok(width <= edge, `${width - edge} px beyond the edge`);
    assert.ok(await page.value("document.querySelector('#step1 math').getBoundingClientRect().height > 5"), "formulas are not drawn");
    // A decimal comma, a guess, a slider on its logarithmic axis, arrows of the small packings, and the language that keeps settings.
    const typed = (id, text) => page.value(`(() => { const field = document.getElementById('${id}'); field.value = '${text}'; field.dispatchEvent(new Event('input')); })()`);
    await typed("cpressure", "12,5");
    assert.match(await page.value("document.getElementById('clines').textContent"), /--pressure 12\.5kPa/);
    await page.value("document.querySelector('#step3guess button').click()");
    assert.equal(await page.value("document.querySelectorAll('.question [aria-pressed=true]').length"), 1);
    await typed("3pressure", "1000");
    assert.match(await page.value("document.querySelector('#step3 .finding').textContent"), /1000 kPa/);
    assert.match(await page.value("document.querySelector('a.language').href"), /de\.html#.*3pressure=1000/);
    await page.until("document.querySelectorAll('.pair svg').length === 4");
    assert.ok(await page.value("document.querySelectorAll('#step5 .head.relaxed').length > 10"), "no arrows");
    assert.ok(await page.value("document.querySelector('#step1 svg').getBoundingClientRect().height > 130"), "no contacts are drawn");
    await page.value("document.getElementById('xstart').click()");
    await page.until("document.getElementById('xpause').disabled && document.querySelectorAll('#xstates tr').length === 10");
    const s = Number((await page.value("document.getElementById('xstatus').textContent")).match(/s of the network is ([\d.]+)/)[1]);
    assert.ok(s > 0.3 && s < 0.5, `s ${s}`);
    if (await page.value("document.querySelector('#experiment canvas') !== null"))
      assert.ok(await page.value(`(() => { const canvas = document.querySelector('#experiment canvas'), gl = canvas.getContext('webgl2'), all = new Uint8Array(4 * canvas.width * canvas.height);
        gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all); return all.some((byte) => byte > 0); })()`), "no grains are drawn");
    if (process.env.GRANUM_SHOT) fs.writeFileSync(process.env.GRANUM_SHOT, Buffer.from((await page.call("TakeScreenshot", { full: true })).value, "base64"));
  } finally {
    browser.kill();
    await new Promise((done) => browser.once("exit", done));
    fs.rmSync(profile, { recursive: true, force: true });
  }
});
