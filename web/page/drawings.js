// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings to scale: two grains pressed together, a rough contact, and a slice of a small packing with arrows. All lengths are
// granum's; here they only become places on the paper.
"use strict";

const svgPicture = (width, height, title, finding, parts) =>
  `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${escapeText(finding)}"><title>${escapeText(title)}</title>${parts.join("")}</svg>`;
const pathOf = (points) => `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;
/// An arrow; none where it would be shorter than its head is wide.
function arrow([x0, y0], [x1, y1], kind, size = 5) {
  const long = Math.hypot(x1 - x0, y1 - y0);
  if (long < 1.5) return "";
  const head = Math.min(size, 0.6 * long), [ex, ey] = [(x1 - x0) / long, (y1 - y0) / long];
  const side = (k) => [x1 - head * ex + k * 0.5 * head * ey, y1 - head * ey - k * 0.5 * head * ex];
  return `<path class="arrow ${kind}" d="${pathOf([[x0, y0], [x1 - 0.7 * head * ex, y1 - 0.7 * head * ey]])}"/><path class="head ${kind}" d="${pathOf([side(1), [x1, y1], side(-1)])}Z"/>`;
}

/// Places of the contact drawing: half the width and the height that are shown [m], how much heights are enlarged, and the length of an
/// arrow of one newton.
const contactScene = { halfWidth: 25e-6, enlarged: 20, points: 50, perNewton: 66 };
function contactSheet(cells) {
  const width = isNarrow.matches ? 430 : 640, cell = width / cells, scale = (0.92 * cell) / (2 * contactScene.halfWidth);
  const half = isNarrow.matches ? 62 : 78, middle = half + 62;
  return { width, height: 2 * middle + 66, cell, scale, up: contactScene.enlarged * scale, half, middle };
}
/// {force, stiffness, radius, rows: [{r, unloaded, deformed}]} of granum's contact_picture.
function pressedContact(granum, grain, overlap) {
  const { halfWidth, points } = contactScene;
  const [force, stiffness, radius, ...rows] = granum.call("contact_picture", ...grainNumbers(grain), overlap, halfWidth, points).numbers;
  return { force, stiffness, radius, rows: Array.from({ length: points + 1 }, (_, k) => ({ r: (halfWidth * k) / points, unloaded: rows[2 * k], deformed: rows[2 * k + 1] })) };
}

const alphaOf = (granum, grain) => granum.contactCurve(grain, 1e-7, 1).alpha;
/// Two grains of each law at the same overlap: [{grain, law}]; `chosen` is a name of a law.
function contactDrawing(granum, texts, words, contacts, overlap, chosen, finding) {
  const sheet = contactSheet(contacts.length), { cell, scale, up, half, middle } = sheet, parts = [];
  contacts.forEach(({ grain, law }, k) => {
    const { force, radius, rows } = pressedContact(granum, grain, overlap), x0 = (k + 0.5) * cell, colour = shapeColour(law.name);
    const top = middle - half, clip = `cut-${k}-${Math.round(cell)}`;
    const known = rows.filter(({ deformed }) => Number.isFinite(deformed)), flat = known.length < rows.length;
    /// The right half of a surface, from the axis out; a punch ends at its own edge.
    const out = (key) => [...known.map((row) => [row.r, row[key]]), ...(flat ? [[radius, known[0][key]], [radius, 1]] : [])];
    const line = (key, sign) => {
      const right = out(key).map(([r, z]) => [scale * r, -sign * up * Math.min(z, half / up)]);
      return [...right.slice().reverse().map(([x, y]) => [x0 - x, middle + y]), ...right.map(([x, y]) => [x0 + x, middle + y])];
    };
    parts.push(`<clipPath id="${clip}"><rect x="${k * cell}" y="${top}" width="${cell}" height="${2 * half}"/></clipPath>`);
    for (const sign of [1, -1]) {
      const surface = line("deformed", sign), far = middle - sign * half;
      parts.push(`<path class="grain" style="--colour:${colour}" d="${pathOf([[surface[0][0], far], ...surface, [surface.at(-1)[0], far]])}Z"/>`,
        `<path class="unloaded" clip-path="url(#${clip})" d="${pathOf(line("unloaded", sign))}"/>`);
    }
    parts.push(`<path class="touching" d="M${(x0 - scale * radius).toFixed(2)} ${middle}H${(x0 + scale * radius).toFixed(2)}"/>`,
      `<path class="overlap" d="M${x0} ${(middle - (up * overlap) / 2).toFixed(2)}V${(middle + (up * overlap) / 2).toFixed(2)}"/>`);
    const long = contactScene.perNewton * force;
    for (const sign of [1, -1]) parts.push(arrow([x0, middle - sign * (half + 4 + long)], [x0, middle - sign * (half + 4)], "force", 9));
    const under = middle + half + 66;
    [[law.name === "power-law" ? `α = ${written(alphaOf(granum, grain))}` : law.plural, law.name === chosen ? "name" : "tick"], [`f = ${written(force)} N`, "tick"], [`2a = ${written(2e6 * radius)} µm`, "tick"]].forEach(([text, kind], row) =>
      parts.push(`<text class="${kind}" x="${x0}" y="${under + 17 * row}" text-anchor="middle">${escapeText(text)}</text>`));
  });
  return svgPicture(sheet.width, sheet.height + 12, words.drawing, finding, parts) + `<p class="caption">${escapeText(filled(words.scale, { times: contactScene.enlarged }))}</p>`;
}

/// A rough line of mean zero and root mean square one, the same each time: [[x from -1 to 1, height]].
function roughLine(seed, points, waves) {
  let state = seed;
  const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const parts = Array.from({ length: waves }, (_, k) => ({ k: 6 + 2 * k, phase: 2 * Math.PI * random(), high: (6 + 2 * k) ** -0.9 }));
  const rms = Math.sqrt(parts.reduce((sum, { high }) => sum + (high * high) / 2, 0));
  return evenly(-1, 1, points).map((x) => [x, parts.reduce((sum, { k, phase, high }) => sum + high * Math.cos(Math.PI * k * x + phase), 0) / rms]);
}
/// Height of both surfaces together (root mean square) over u0.
const rmsOverRoughness = 2.5;

/// A contact of rough spheres below and above p*, on one scale; `contacts`: [{label, share, overlap, radius}]. How rough lines run is a sketch; their height,
/// the flattened length and the bar of shares are granum's.
function roughDrawing(granum, words, grain, roughness, contacts, finding) {
  const narrow = isNarrow.matches, width = narrow ? 430 : 640, cell = width / contacts.length, half = 70, middle = half + 10;
  const wide = 1.25 * Math.max(...contacts.map(({ radius }) => radius)), scale = (0.9 * cell) / (2 * wide);
  const up = 52 / Math.max(...contacts.map(({ overlap }) => overlap)), steps = 200, points = 2 * steps + 1, parts = [];
  const lines = [roughLine(7, points, 30), roughLine(11, points, 30)].map((line) => line.map(([, high]) => (high * rmsOverRoughness * roughness) / Math.SQRT2));
  contacts.forEach(({ label, share, overlap, radius }, k) => {
    const x0 = (k + 0.5) * cell, at = (j) => (wide * (j - steps)) / steps;
    // Half of the gap of the smooth spheres.
    const rows = granum.call("contact_picture", ...grainNumbers({ ...grain, shape: "sphere" }), overlap, wide, steps).numbers.slice(3);
    const smooth = (j) => rows[2 * Math.abs(j - steps) + 1];
    const gap = lines[0].map((upper, j) => 2 * smooth(j) + upper + lines[1][j]);
    // Moved together until what touches is as long as the part of the contact that the grains' bodies, not the roughness, take up.
    const sorted = [...gap].sort((a, b) => a - b), touching = Math.max(1, Math.round(((1 - share) * 2 * steps * radius) / wide));
    const closed = sorted[Math.min(points - 1, touching)];
    const surface = (sign) => gap.map((g, j) => {
      const [own, other] = (sign > 0 ? lines : [...lines].reverse()).map((line) => smooth(j) + line[j] - closed / 2);
      const z = g <= closed ? (own - other) / 2 : own; // where they touch, both have one surface
      return [x0 + scale * at(j), middle - sign * Math.max(-half, Math.min(half, up * z))];
    });
    for (const sign of [1, -1]) {
      const line = surface(sign);
      parts.push(`<path class="grain" style="--colour:${colours.rough}" d="${pathOf([[line[0][0], middle - sign * half], ...line, [line.at(-1)[0], middle - sign * half]])}Z"/>`);
    }
    const upper = surface(1);
    let run = [];
    gap.forEach((g, j) => {
      if (g <= closed) run.push(upper[j]);
      if ((g > closed || j === points - 1) && run.length) {
        parts.push(`<path class="touching thin" d="${pathOf([[run[0][0] - 1, run[0][1]], ...run, [run.at(-1)[0] + 1, run.at(-1)[1]]])}"/>`);
        run = [];
      }
    });
    const left = x0 - 0.42 * cell, long = 0.84 * cell, top = middle + half + 30;
    parts.push(`<text class="name" x="${x0}" y="${middle + half + 20}" text-anchor="middle">${escapeText(label)}</text>`,
      `<rect class="share" x="${left}" y="${top}" width="${(long * share).toFixed(2)}" height="12" style="--colour:${colours.rough}"/>`,
      `<rect class="share" x="${(left + long * share).toFixed(2)}" y="${top}" width="${(long * (1 - share)).toFixed(2)}" height="12" style="--colour:${colours.sphere}"/>`,
      `<text class="tick" x="${x0}" y="${top + 29}" text-anchor="middle">${escapeText(filled(words.share, { rough: Math.round(100 * share), smooth: 100 - Math.round(100 * share) }))}</text>`);
  });
  return svgPicture(width, middle + half + 66, words.drawing, finding, parts) + `<p class="caption">${escapeText(words.sketch)}</p>`;
}

/// The numbers of granum's experiment_motions: a small packing, its contacts, and how its grains move beside the mean strain.
function networkOf(numbers) {
  const [affine, relaxed, z, contacts, e1, e2, e3, grains, links] = numbers, rest = numbers.slice(9);
  return {
    affine, relaxed, z, contacts, edge: [e1, e2, e3],
    grains: Array.from({ length: grains }, (_, g) => {
      const row = rest.slice(11 * g, 11 * g + 11);
      return { at: row.slice(0, 3), radius: row[3], moved: row.slice(4, 7), turn: row.slice(7, 10), count: row[10] };
    }),
    links: Array.from({ length: links }, (_, c) => {
      const [i, j, b1, b2, b3, normal, tangential] = rest.slice(11 * grains + 7 * c, 11 * grains + 7 * c + 7);
      return { i, j, branch: [b1, b2, b3], normal, tangential };
    }),
  };
}
/// What the mean strain does to a grain, seen from the middle of the cell.
const meanMotion = ({ edge }, { at }) => [at[0] - edge[0] / 2, 0, -(at[2] - edge[2] / 2)];
/// How much of the mean strain an arrow shows, and how thick a slice is [mean radius].
const sliceScene = { strain: 0.22, thickness: 1.8 };

/// The slice around the grain that turns away most from the mean motion: its grains, and that one.
function sliceOf(network) {
  const away = (grain) => (grain.count ? Math.hypot(grain.moved[0], grain.moved[2]) : 0);
  const inside = network.grains.filter(({ at }) => at.every((x, axis) => axis === 1 || Math.abs(x / network.edge[axis] - 0.5) < 0.36));
  const turned = inside.reduce((a, b) => (away(b) > away(a) ? b : a));
  const deep = (grain) => {
    const apart = (grain.at[1] - turned.at[1]) / network.edge[1];
    return (apart - Math.round(apart)) * network.edge[1];
  };
  const shown = network.grains.map((grain, k) => ({ grain, k, deep: deep(grain) })).filter(({ deep: at }) => Math.abs(at) < sliceScene.thickness / 2).sort((a, b) => b.deep - a.deep);
  return { shown, turned };
}

/// A slice of a packing with contacts and arrows, "mean" or "both": thin ones are the mean strain, thick ones what the grains do when their forces
/// balance; the mark at the rim of a grain turns with it. Arrow and turn are as much enlarged in every picture.
function sliceDrawing(network, arrows, title, finding) {
  const size = 400, margin = 34, scale = (size - 2 * margin) / Math.max(network.edge[0], network.edge[2]);
  const place = ([x, , z]) => [size / 2 + scale * (x - network.edge[0] / 2), size / 2 - scale * (z - network.edge[2] / 2)];
  const { shown, turned } = sliceOf(network), there = new Set(shown.map(({ k }) => k)), parts = [];
  for (const { grain } of shown) {
    const [x, y] = place(grain.at);
    parts.push(`<circle class="ball${grain === turned && arrows === "both" ? " turned" : ""}${grain.count ? "" : " idle"}" cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="${(scale * grain.radius).toFixed(2)}"/>`);
  }
  for (const { i, j, branch } of network.links) {
    if (!there.has(i) || !there.has(j)) continue;
    const from = network.grains[i].at, to = from.map((x, axis) => x + branch[axis]);
    if (Math.abs(to[0] - network.grains[j].at[0]) > 0.01 || Math.abs(to[2] - network.grains[j].at[2]) > 0.01) continue; // through the edge of the cell
    const [[x0, y0], [x1, y1]] = [place(from), place(to)];
    parts.push(`<path class="link" d="M${x0.toFixed(2)} ${y0.toFixed(2)}L${x1.toFixed(2)} ${y1.toFixed(2)}"/>`);
  }
  for (const { grain } of shown) {
    if (!grain.count) continue;
    const at = place(grain.at), angle = arrows === "both" ? (sliceScene.strain * grain.turn[1]) / grain.radius : 0, rim = (share) => [at[0] + share * scale * grain.radius * Math.sin(angle), at[1] - share * scale * grain.radius * Math.cos(angle)];
    parts.push(`<path class="spoke" d="${pathOf([rim(0.6), rim(1)])}"/>`);
    const mean = meanMotion(network, grain), moved = (motion) => [at[0] + sliceScene.strain * scale * motion[0], at[1] - sliceScene.strain * scale * motion[2]];
    parts.push(arrow(at, moved(mean), "mean", 7));
    if (arrows === "both") parts.push(arrow(at, moved(mean.map((x, axis) => x + grain.moved[axis])), grain === turned ? "relaxed away" : "relaxed", 9));
  }
  return svgPicture(size, size, title, finding, parts);
}
