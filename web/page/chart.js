// SPDX-License-Identifier: GPL-3.0-or-later
// Small charts as SVG text. Colours are those of the style sheet, so that they follow light and dark.
"use strict";

/// Colours have the meanings of include/granum/plot/palette.hpp, the source of the style sheet.
const colours = Object.fromEntries([..."<!--colours-->".split(" "), "grey"].map((name) => [name, `var(--${name})`]));
/// A contact law without a colour of its own has that of power laws.
const shapeColourName = (shape) => (shape in colours ? shape : "power_law");
const shapeColour = (shape) => colours[shapeColourName(shape)];
const escapeText = (text) => String(text).replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);

/// Of granum, in the names of files.
let pageVersion = "";
/// The sign between a number's whole part and its decimals, in the language of the page.
let decimalSign = ".";
const localised = (number) => number.replace(".", decimalSign);
/// With so many decimals.
const fixed = (value, decimals) => localised(value.toFixed(decimals));
/// Numbers in usual notation, with at most `digits` digits.
function written(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${localised(String(Number(mantissa)))}·10${[...String(Number(exponent))].map((c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻").join("")}`;
  }
  return localised(String(Number(value.toPrecision(digits))));
}

/// Round values between low and high.
function ticks(axis) {
  const { min, max } = axis;
  if (axis.names) return axis.names.map(([value]) => value);
  const out = [];
  if (axis.log) {
    const steps = Math.log10(max / min) > 2.5 ? [1] : Math.log10(max / min) > 1.2 ? [1, 2, 5] : [1, 2, 3, 4, 5, 6, 8];
    for (let decade = Math.floor(Math.log10(min)); decade <= Math.log10(max); ++decade)
      for (const step of steps) {
        const value = step * 10 ** decade;
        if (value >= min * 0.9999 && value <= max * 1.0001) out.push(value);
      }
    return out;
  }
  const raw = (max - min) / 5;
  const decade = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((m) => m * decade).find((s) => s >= raw * 0.999);
  for (let k = Math.ceil(min / step - 1e-9); k * step <= max + 1e-9 * step; ++k) out.push(k * step);
  return out;
}

/// Subscripts: C_n.
const svgWords = (text) => escapeText(text).replace(/_(\w+)/g, '<tspan dy="4" font-size="80%">$1</tspan><tspan dy="-4">\u200b</tspan>');

const isNarrow = matchMedia("(max-width: 760px), (max-height: 480px)");
/// Draws now, and again if a turned screen needs another size.
function drawnToSize(draw) {
  draw();
  isNarrow.addEventListener("change", draw);
}

/// {title, finding, x: {label, min, max, log}, y: {...}, series: [{label, colour, points: [[x, y]], ranges: [[low, high]], line, dots, hollow, dash:
///  true or "dots", faint, name}], bands: [{label, colour, points: outline}], mark: [x, y], triangles: [{x0, x1, y, slope, text, colour}], note}
/// An axis may have names instead of round numbers: {names: [[value, text]]}. A series may have a name at its end.
/// `finding` is a text with the content of the chart, for screen readers; a note is in the bottom right corner.
function chart(what) {
  // On a narrow screen the picture is smaller with letters of the same size, so that they are readable.
  const narrow = isNarrow.matches;
  const width = narrow ? 430 : 640, height = narrow ? 320 : 400, left = 72, right = 18, top = 16, bottom = 52;
  const place = (axis, value, from, to) => {
    const at = axis.log ? Math.log(value / axis.min) / Math.log(axis.max / axis.min) : (value - axis.min) / (axis.max - axis.min);
    return from + at * (to - from);
  };
  const X = (x) => place(what.x, x, left, width - right);
  const Y = (y) => place(what.y, y, height - bottom, top);
  // Points beyond the axes and NaN are not drawn.
  const inside = ([x, y]) => x >= what.x.min * 0.9999 && x <= what.x.max * 1.0001 && y >= what.y.min * 0.9999 && y <= what.y.max * 1.0001;
  const parts = [], names = [];
  const named = new Map(what.x.names);
  let free = -Infinity; // from here on a label does not overlap the last one
  for (const value of ticks(what.x)) {
    const lines = (named.get(value) ?? written(value)).split(named.has(value) ? /[ -](?=[^\d])/ : /$/);
    const half = 3 + 4.5 * Math.max(...lines.map((line) => line.length));
    parts.push(`<line class="grid" x1="${X(value)}" x2="${X(value)}" y1="${top}" y2="${height - bottom}"/>`);
    if (!named.has(value) && X(value) - half < free) continue;
    free = X(value) + half;
    lines.forEach((line, k) => parts.push(`<text class="tick" x="${X(value)}" y="${height - bottom + 20 + 16 * k}" text-anchor="middle">${escapeText(line)}</text>`));
  }
  for (const value of ticks(what.y))
    parts.push(`<line class="grid" x1="${left}" x2="${width - right}" y1="${Y(value)}" y2="${Y(value)}"/>` +
      `<text class="tick" x="${left - 8}" y="${Y(value) + 5}" text-anchor="end">${written(value)}</text>`);
  if (!what.x.names) parts.push(`<text class="label" x="${(left + width - right) / 2}" y="${height - 8}" text-anchor="middle">${svgWords(what.x.label)}</text>`);
  parts.push(`<text class="label" transform="translate(16 ${(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">${svgWords(what.y.label)}</text>`);
  // An inner picture clips at the axes.
  for (const band of what.bands ?? [])
    parts.push(`<svg x="${left}" y="${top}" width="${width - left - right}" height="${height - top - bottom}"><polygon fill="${band.colour}" fill-opacity="0.16" stroke="none" ` +
      `points="${band.points.map(([x, y]) => `${(X(x) - left).toFixed(1)},${(Y(y) - top).toFixed(1)}`).join(" ")}"/></svg>`);
  what.series.forEach((series) => {
    const { colour } = series;
    const points = series.points.filter(inside);
    if (series.line !== false && points.length > 1)
      parts.push(`<polyline fill="none" stroke="${colour}" stroke-width="${series.faint ? 1.5 : 2.5}" opacity="${series.faint ? 0.5 : 1}"` +
        `${series.dash ? ` stroke-dasharray="${series.dash === "dots" ? "2 4" : "7 5"}"` : ""} points="${points.map(([x, y]) => `${X(x).toFixed(1)},${Y(y).toFixed(1)}`).join(" ")}"/>`);
    series.ranges?.forEach(([low, high], k) => {
      if (![low, high, ...series.points[k]].every(Number.isFinite)) return;
      const x = X(series.points[k][0]), [foot, head] = [low, high].map((y) => Y(Math.min(what.y.max, Math.max(what.y.min, y))));
      parts.push(`<path class="bar" fill="none" stroke="${colour}" stroke-width="2" d="M${x - 6} ${head}h12M${x} ${head}V${foot}M${x - 6} ${foot}h12"/>`);
    });
    if (series.dots)
      for (const [x, y] of points) parts.push(`<circle cx="${X(x).toFixed(1)}" cy="${Y(y).toFixed(1)}" r="4.5" ${series.hollow ? `class="hollow" stroke="${colour}"` : `fill="${colour}"`}><title>${escapeText(series.label ?? series.name)}: ${written(x)}, ${written(y)}</title></circle>`);
    if (series.name && points.length) names.push({ x: X(points.at(-1)[0]) + 7, y: Y(points.at(-1)[1]) + 5, text: series.name });
  });
  // Names at the ends of their series, apart from each other.
  const lineHeight = 15;
  names.sort((a, b) => a.y - b.y).forEach((name, k) => { name.y = Math.max(name.y, k ? names[k - 1].y + lineHeight : top + 12); });
  names.reverse().forEach((name, k) => { name.y = Math.min(name.y, k ? names[k - 1].y - lineHeight : height - bottom - 4); });
  for (const { x, y, text } of names) parts.push(`<text class="name" x="${x.toFixed(1)}" y="${y.toFixed(1)}">${escapeText(text)}</text>`);
  for (const { x0, x1, y, slope, text, colour } of what.triangles ?? []) {
    const y1 = y * (x1 / x0) ** slope;
    if (![y, y1].every((at) => inside([x0, at]))) continue;
    const below = X(x1) + 8 + 8 * text.length > width - right;
    parts.push(`<path class="triangle"${colour ? ` style="stroke:${colour}"` : ""} d="M${X(x0).toFixed(1)} ${Y(y).toFixed(1)}H${X(x1).toFixed(1)}V${Y(y1).toFixed(1)}Z"/>` +
      `<text class="label slope" x="${below ? X(x1) : X(x1) + 8}" y="${below ? Y(y) + 18 : (Y(y) + Y(y1)) / 2 + 5}"${below ? ' text-anchor="end"' : ""}>${escapeText(text)}</text>`);
  }
  if (what.note) parts.push(`<text class="tick" x="${width - right - 8}" y="${height - bottom - 10}" text-anchor="end">${escapeText(what.note)}</text>`);
  if (what.mark && inside(what.mark))
    parts.push(`<circle class="mark" cx="${X(what.mark[0])}" cy="${Y(what.mark[1])}" r="7"/>`);
  return `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${escapeText(what.finding)}"><title>${escapeText(what.title)}</title>` +
    `<rect class="frame" x="${left}" y="${top}" width="${width - left - right}" height="${height - top - bottom}"/>${parts.join("")}</svg>${legendOf(what)}`;
}

/// Empty for a single entry.
function legendOf({ series, bands = [] }) {
  const listed = [...series, ...bands.map((band) => ({ ...band, band: true }))].filter(({ label }) => label);
  const kind = (one) => (one.band ? " band" : one.dots && one.line === false ? (one.hollow ? " dot hollow" : " dot") : one.dash ? (one.dash === "dots" ? " dotted" : " dashed") : "");
  return listed.length < 2 ? "" : `<ul class="legend">${listed.map((one) =>
    `<li><span class="swatch${kind(one)}" style="--colour:${one.colour}"></span>${escapeText(one.label)}</li>`).join("")}</ul>`;
}

/// E(gamma; a) of contact normals around the vertical, as distance from the centre; the circle is isotropic. With bars of a histogram
/// of equal steps from 0 to 90 degrees, if the directions were counted.
function rose(density, title, finding, bars = []) {
  const size = 400, centre = size / 2, unit = Math.min(105, 170 / Math.max(...density, ...bars));
  const at = (angle, r) => `${(centre + unit * r * Math.sin(angle)).toFixed(1)},${(centre - unit * r * Math.cos(angle)).toFixed(1)}`;
  const quarter = density.length - 1;
  const outline = [];
  for (let k = 0; k <= 4 * quarter; ++k) {
    const folded = k % (2 * quarter) <= quarter ? k % (2 * quarter) : 2 * quarter - (k % (2 * quarter));
    outline.push(at((k / quarter) * (Math.PI / 2), density[folded]));
  }
  const step = Math.PI / 2 / bars.length;
  const wedges = bars.flatMap((r, k) => [k, 2 * bars.length - 1 - k, 2 * bars.length + k, 4 * bars.length - 1 - k].map((place) =>
    `<polygon fill="${colours.measured}" fill-opacity="0.45" stroke="${colours.measured}" points="${centre},${centre} ${at(place * step, r)} ${at((place + 1) * step, r)}"/>`));
  return `<svg viewBox="0 0 ${size} ${size}" role="img" aria-label="${escapeText(finding)}"><title>${escapeText(title)}</title>${wedges.join("")}` +
    `<circle class="grid" fill="none" cx="${centre}" cy="${centre}" r="${unit}"/><line class="grid" x1="${centre}" x2="${centre}" y1="10" y2="${size - 10}"/>` +
    `<line class="grid" x1="10" x2="${size - 10}" y1="${centre}" y2="${centre}"/>` +
    `<polygon points="${outline.join(" ")}" fill="${colours.closed_form}" fill-opacity="${bars.length ? 0 : 0.25}" stroke="${colours.closed_form}" stroke-width="2.5"/>` +
    `<text class="label" x="${centre + 12}" y="18">v</text><text class="label" x="${size - 20}" y="${centre - 8}">h</text></svg>`;
}

const styleKeys = ["fill", "stroke", "stroke-width", "stroke-dasharray", "opacity", "fill-opacity", "stroke-opacity", "font-size", "font-family", "text-anchor", "paint-order"];

/// The picture with title, legend and background as a separate file, with resolved colours, so that it looks the same elsewhere.
function standalone(picture, title) {
  const svg = picture.querySelector("svg"), copy = svg.cloneNode(true);
  const originals = [svg, ...svg.querySelectorAll("*")];
  [copy, ...copy.querySelectorAll("*")].forEach((element, k) => {
    const style = getComputedStyle(originals[k]);
    for (const key of styleKeys) if (element.tagName !== "title") element.setAttribute(key, style.getPropertyValue(key));
    element.removeAttribute("class");
    element.removeAttribute("style");
  });
  const page = getComputedStyle(document.documentElement), ink = page.getPropertyValue("--ink").trim(), paper = page.getPropertyValue("--paper").trim();
  const { width, height } = svg.viewBox.baseVal, above = 40, line = 24;
  const word = (x, y, text, size = 15) => `<text x="${x}" y="${y}" fill="${ink}" font-size="${size}">${escapeText(text)}</text>`;
  let x = 20, row = 0;
  const legend = [...picture.querySelectorAll(".legend li")].map((item) => {
    const is = (name) => item.firstElementChild.classList.contains(name), colour = getComputedStyle(item.firstElementChild).getPropertyValue("border-top-color");
    const wide = 44 + 8 * item.textContent.length;
    if (x + wide > width && x > 20) [x, row] = [20, row + 1];
    const y = above + height + 12 + line * row;
    const mark = is("band") ? `<rect x="${x}" y="${y - 6}" width="28" height="12" fill="${colour}" fill-opacity="0.3"/>`
      : is("dot") ? `<circle cx="${x + 14}" cy="${y}" r="5" fill="${is("hollow") ? paper : colour}" stroke="${colour}" stroke-width="2"/>`
        : `<line x1="${x}" x2="${x + 28}" y1="${y}" y2="${y}" stroke="${colour}" stroke-width="3"${is("dashed") ? ' stroke-dasharray="7 5"' : is("dotted") ? ' stroke-dasharray="2 4"' : ""}/>`;
    const drawn = mark + word(x + 36, y + 5, item.textContent);
    x += wide + 12;
    return drawn;
  });
  const all = above + height + (legend.length ? line * (row + 1) + 6 : 0);
  const inner = new XMLSerializer().serializeToString(copy).replace(/^<svg/, `<svg x="0" y="${above}" width="${width}" height="${height}"`);
  const finding = svg.getAttribute("aria-label");
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${all}" width="${width}" height="${all}" font-family="sans-serif" role="img" aria-label="${escapeText(finding)}">` +
    `<title>${escapeText(title)}</title><desc>${escapeText(`${finding} granum ${pageVersion}, ${location.href}`)}</desc><rect width="${width}" height="${all}" fill="${paper}"/>${word(20, 26, title, Math.min(17, (1.7 * width) / title.length))}${inner}${legend.join("")}</svg>`;
}

/// A button that saves the picture in an element.
/// `name` is a text or a function that knows what the picture shows by then.
const saveButton = (texts, picture, name) => element("button", { class: "save", onclick: () =>
  saveFile(`granum-${pageVersion}-${typeof name === "function" ? name() : name}.svg`, standalone(picture, picture.querySelector("svg title").textContent), "image/svg+xml") }, texts.save);

function saveFile(name, text, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
