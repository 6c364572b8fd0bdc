// SPDX-License-Identifier: GPL-3.0-or-later
// What the lesson draws is what the library computes: surfaces of contacts against closed forms, motions of grains against the energy and
// the balance of their contacts, and every place on the paper to a pixel.  CHROMIUM names the browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { close, grain, launched, pageFile, startModule } from "./native.mjs";

let browser, granum;
before(async () => {
  granum = await startModule();
  browser = await launched();
});
after(() => browser?.close());

const places = { cone: [0, 0.02], sphere: [1, NaN], flat: [2, 1.1e-5] };
const pressed = (shape, overlap, halfWidth, points) => {
  const [place, number] = places[shape];
  const [force, stiffness, radius, ...rows] = granum.call("contact_picture", place, grain.shearModulus, grain.poissonRatio, grain.radius, number, NaN, overlap, halfWidth, points).numbers;
  return { force, stiffness, radius, at: (k) => ({ r: (halfWidth * k) / points, unloaded: rows[2 * k], deformed: rows[2 * k + 1] }) };
};

test("surfaces of pressed spheres are those of Hertz, and touch where the contact is", () => {
  const overlap = 6e-7, { radius: a, at } = pressed("sphere", overlap, 4e-5, 80);
  close(a, Math.sqrt((grain.radius * overlap) / 2), 1e-12, "radius of the contact");
  for (let k = 0; k <= 80; ++k) {
    const { r, unloaded, deformed } = at(k);
    assert.ok(Math.abs(unloaded - (r * r / (2 * grain.radius) - overlap / 2)) < 1e-19, `unloaded at ${r}`);
    if (r <= a) assert.equal(deformed, 0);
    else {
      // Both surfaces together, Johnson, Contact Mechanics, Eq. 3.42a, for two equal spheres.
      const moved = (overlap / Math.PI) * ((2 - (r / a) ** 2) * Math.asin(a / r) + Math.sqrt((r / a) ** 2 - 1));
      assert.ok(Math.abs(deformed - unloaded - moved / 2) < 1e-7 * overlap, `deformed at ${r}`);
      assert.ok(deformed > 0, "surfaces lie in each other");
    }
  }
});

test("far from a contact of any shape the surface moves as under a point force, which is the law's", () => {
  for (const [shape, exponent] of [["cone", 1], ["sphere", 2]]) {
    const overlap = 6e-7, { force, stiffness, at } = pressed(shape, overlap, 5e-3, 1), { r, unloaded, deformed } = at(1);
    const modulus = grain.shearModulus / (1 - grain.poissonRatio); // of both half spaces together: E*
    close(2 * (deformed - unloaded) * Math.PI * modulus * r, force, 1e-4, `${shape}: force from the far field`);
    close(stiffness * overlap, (1 + 1 / exponent) * force, 1e-12, `${shape}: stiffness`);
  }
  const punch = pressed("flat", 6e-7, 4e-5, 80);
  assert.equal(punch.radius, 1.1e-5);
  assert.equal(punch.at(10).deformed, 0);
  assert.ok(Number.isNaN(punch.at(79).deformed), "a punch has no surface beyond its edge");
  assert.throws(() => granum.call("contact_picture", 4, grain.shearModulus, grain.poissonRatio, grain.radius, 1e-7, NaN, 1e-7, 1e-5, 4), /one power/);
});

test("a rough contact divides an approach as its two stiffnesses do", () => {
  const rough = (force) => granum.call("rough_contact", 4, grain.shearModulus, grain.poissonRatio, grain.radius, 1e-7, NaN, force).numbers;
  const [k, exponent, share, overlap, radius] = rough(0.01), whole = granum.contactCurve({ ...grain, shape: "rough", numbers: { roughness: 1e-7 } }, 1e-7, 1);
  close(share, (1e-7 * k) / 0.01, 1e-12, "share");
  close(radius, Math.sqrt((grain.radius * overlap) / 2), 1e-12, "radius");
  assert.ok(exponent > 1 / 3 && exponent < 1 && whole.stiffnessExponent > 1 / 3);
  assert.ok(rough(1e-6)[2] > 0.95 && rough(10)[2] < 0.05, "roughness decides at small forces alone");
  assert.throws(() => granum.call("rough_contact", 1, grain.shearModulus, grain.poissonRatio, grain.radius, NaN, NaN, 0.01), /rough/);
});

/// The small packing that the steps show.
const packings = new Map();
async function smallPacking(loose) {
  if (!packings.has(loose)) {
    const own = await startModule();
    own.call("experiment_begin", 1, grain.shearModulus, grain.poissonRatio, grain.radius, NaN, NaN, grain.frictionAngle, loose ? 1 : 0, 0, 120, 1, 1e4);
    assert.throws(() => own.call("experiment_motions"), /after a compression/);
    own.call("experiment_begin", 1, grain.shearModulus, grain.poissonRatio, grain.radius, NaN, NaN, grain.frictionAngle, loose ? 1 : 0, 0, 120, 1, 1e4);
    own.call("experiment_prepare");
    const row = own.call("experiment_compress", 1e4).numbers, numbers = own.call("experiment_motions").numbers;
    const [affine, relaxed, z, contacts, e1, e2, e3, grains, links] = numbers, rest = numbers.slice(9);
    assert.equal(rest.length, 11 * grains + 7 * links);
    packings.set(loose, { affine, relaxed, z, contacts, edge: [e1, e2, e3], row,
      grains: Array.from({ length: grains }, (_, g) => rest.slice(11 * g, 11 * g + 11)),
      links: Array.from({ length: links }, (_, c) => rest.slice(11 * grains + 7 * c, 11 * grains + 7 * c + 7)) });
  }
  return packings.get(loose);
}
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

for (const loose of [false, true])
  test(`motions of the small ${loose ? "loose" : "dense"} packing balance every grain, and have its energy`, async () => {
    const { affine, relaxed, z, contacts, row, grains, links } = await smallPacking(loose);
    close(z, row[3], 1e-12, "z*");
    close(contacts, row[2], 1e-12, "C_n");
    let uniform = 0, own = 0;
    const forces = grains.map(() => [0, 0, 0]), moments = grains.map(() => [0, 0, 0]);
    let size = 0;
    for (const [i, j, b1, b2, b3, normal, tangential] of links) {
      const branch = [b1, b2, b3], long = Math.hypot(...branch), n = branch.map((x) => x / long), mean = [b1, 0, -b3];
      const [a, b] = [grains[i], grains[j]], arm = long / 2;
      const turn = cross([7, 8, 9].map((k) => (arm * a[k]) / a[3] + (arm * b[k]) / b[3]), n);
      const moved = mean.map((x, k) => x + b[4 + k] - a[4 + k] - turn[k]);
      const force = (delta) => delta.map((x, k) => normal * dot(delta, n) * n[k] + tangential * (x - dot(delta, n) * n[k]));
      uniform += dot(mean, force(mean));
      own += dot(moved, force(moved));
      const f = force(moved), m = cross(n.map((x) => arm * x), f);
      f.forEach((x, k) => { forces[i][k] += x; forces[j][k] -= x; moments[i][k] += m[k]; moments[j][k] += m[k]; });
      size += Math.hypot(...f) / links.length;
    }
    close(own / uniform, relaxed / affine, 1e-8, "energy of the motions over that of uniform strain");
    assert.ok(Math.max(...forces.map((f) => Math.hypot(...f))) < 1e-6 * size, "a grain is not in equilibrium");
    assert.ok(Math.max(...moments.map((m) => Math.hypot(...m))) < 1e-6 * size, "a moment is left");
    assert.ok(loose ? relaxed < 0.5 * affine : relaxed > 0.6 * affine, `G ${relaxed} of ${affine}`);
  });

async function opened(options = {}, hash = "") {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 900 }, reducedMotion: "reduce", ...options })).newPage();
  await page.goto(pathToFileURL(pageFile).href + hash);
  await page.waitForSelector("html[data-ready=yes]");
  return page;
}
const numbersOf = (path) => path.match(/-?[\d.]+/g).map(Number);

test("the contacts of step 1 are drawn to scale, at every width, as the slider has them", async () => {
  for (const [width, sheet] of [[1280, 640], [390, 430]]) {
    const page = await opened({ viewport: { width, height: 844 } }, "#1overlap=0.8");
    for (const overlap of [0.8, 0.3]) {
      await page.locator('[id="1overlap"]').fill(String(overlap));
      const drawn = await page.$eval("#step1 .picture svg", (svg) => ({
        touching: [...svg.querySelectorAll(".touching")].map((path) => path.getAttribute("d")), bars: [...svg.querySelectorAll(".overlap")].map((path) => path.getAttribute("d")),
        surfaces: [...svg.querySelectorAll(".grain")].map((path) => path.getAttribute("d")), arrows: [...svg.querySelectorAll(".head.force")].map((path) => path.getAttribute("d")),
        texts: [...svg.querySelectorAll("text")].map((text) => text.textContent), box: svg.getAttribute("viewBox") }));
      assert.match(drawn.box, new RegExp(`^0 0 ${sheet} `));
      const cell = sheet / 3, scale = (0.92 * cell) / 5e-5, up = 20 * scale;
      for (const [k, shape] of ["cone", "sphere", "flat"].entries()) {
        const [number] = shape === "sphere" ? [NaN] : granum.call("law_as_stiff", places[shape][0], grain.shearModulus, grain.poissonRatio, grain.radius, shape === "cone" ? 0.4 : 5.7e-6, NaN, 0.25).numbers;
        places[shape][1] = number;
        const { force, radius, at } = pressed(shape, overlap * 1e-6, 2.5e-5, 50);
        const [left, middle, right] = numbersOf(drawn.touching[k]);
        assert.ok(Math.abs(right - left - 2 * radius * scale) < 0.1, `${shape}: contact of ${right - left} px, not ${2 * radius * scale}`);
        const [, top, bottom] = numbersOf(drawn.bars[k]);
        assert.ok(Math.abs(bottom - top - up * overlap * 1e-6) < 0.1, `${shape}: overlap`);
        const upper = numbersOf(drawn.surfaces[2 * k]), points = Array.from({ length: upper.length / 2 }, (_, p) => upper.slice(2 * p, 2 * p + 2));
        const centre = (left + right) / 2;
        for (const row of [5, 30, 45]) {
          const { r, deformed } = at(row);
          if (Number.isNaN(deformed)) continue;
          assert.ok(points.some(([x, y]) => Math.abs(x - centre - scale * r) < 1 && Math.abs(middle - y - up * deformed) < 1), `${shape}: the surface at ${r} m`);
        }
        assert.ok(drawn.texts.some((text) => text.startsWith("f = ") && Math.abs(Number(text.match(/[\d.]+/)[0]) / force - 1) < 0.01), `${shape}: force ${force}`);
      }
      assert.equal(drawn.arrows.length, 6);
    }
    await page.context().close();
  }
});

test("arrows of steps 2 and 5 are the mean strain and the motions of the network, to a pixel", async () => {
  const page = await opened();
  await page.waitForSelector("#step5 .pair svg");
  for (const [step, both] of [[2, false], [5, true]])
    for (const [k, loose] of [[0, true], [1, false]]) {
      const { edge, grains, z, affine, relaxed } = await smallPacking(loose);
      const drawn = await page.$$eval(`#step${step} .pair figure`, (all, place) => {
        const figure = all[place], of = (selector, key) => [...figure.querySelectorAll(selector)].map((one) => one.getAttribute(key));
        return { said: figure.textContent, balls: [...figure.querySelectorAll(".ball:not(.idle)")].map((ball) => ["cx", "cy", "r"].map((key) => Number(ball.getAttribute(key)))),
          mean: of(".head.mean", "d"), relaxed: of(".head.relaxed", "d"), away: of(".head.away", "d"), marked: figure.querySelectorAll(".turned").length, links: of(".link", "d") };
      }, k);
      assert.ok(drawn.said.includes(String(Number(z.toPrecision(3)))), drawn.said);
      const scale = 332 / Math.max(edge[0], edge[2]), at = (x, y) => [200 + scale * (x - edge[0] / 2), 200 - scale * (y - edge[2] / 2)];
      const tip = (path) => numbersOf(path).slice(2, 4), near = ([x, y], [u, v]) => Math.hypot(x - u, y - v) < 1;
      assert.ok(drawn.balls.length > 12, `${drawn.balls.length} grains`);
      assert.ok(drawn.links.length > drawn.balls.length / 2, `${drawn.links.length} contacts`);
      let arrows = 0;
      for (const [x, y, r] of drawn.balls) {
        const row = grains.find((one) => near(at(one[0], one[2]), [x, y]) && one[10] > 0);
        assert.ok(row, `no grain at ${x}, ${y}`);
        assert.ok(Math.abs(r - scale * row[3]) < 0.1);
        const mean = [row[0] - edge[0] / 2, -(row[2] - edge[2] / 2)], goal = (u, v) => [x + 0.22 * scale * u, y - 0.22 * scale * v];
        for (const [u, v, heads] of [[...mean, drawn.mean], ...(both ? [[mean[0] + row[4], mean[1] + row[6], drawn.relaxed]] : [])])
          if (0.22 * scale * Math.hypot(u, v) > 2) {
            assert.ok(heads.some((head) => near(tip(head), goal(u, v))), `no arrow to ${goal(u, v)}`);
            ++arrows;
          }
      }
      assert.ok(arrows > (both ? 1.2 : 0.6) * drawn.balls.length, `${arrows} arrows`);
      assert.equal(drawn.relaxed.length > 0, both);
      assert.equal(drawn.marked, both ? 1 : 0);
      if (both) {
        assert.equal(drawn.away.length, 1, "one grain turns away most");
        assert.ok(drawn.said.includes(`${Number(((100 * relaxed) / affine).toPrecision(2))} %`), drawn.said);
      }
    }
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator("#step5 .pair button").first().click()]);
  assert.match(file.suggestedFilename(), /^granum-[\d.]+-step5-few-contacts\.svg$/);
  await page.context().close();
});
