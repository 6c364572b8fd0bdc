// SPDX-License-Identifier: GPL-3.0-or-later
// Small charts as SVG text. Colours are those of the style sheet, so that they follow light and dark.
"use strict";

/// What each colour stands for is said by include/granum/plot/palette.hpp, from which the style sheet has it.
const colours = Object.fromEntries([..."<!--colours-->".split(" "), "grey"].map((name) => [name, `var(--${name})`]));
/// A contact law without a colour of its own has that of power laws.
const shapeColourName = (shape) => (shape in colours ? shape : "power_law");
const shapeColour = (shape) => colours[shapeColourName(shape)];
const escapeText = (text) => String(text).replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);

/// Numbers as people write them, at most `digits` of them.
function written(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${Number(mantissa)}·10${[...String(Number(exponent))].map((c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻").join("")}`;
  }
  return String(Number(value.toPrecision(digits)));
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

/// {title, finding, x: {label, min, max, log}, y: {...}, series: [{label, colour, points: [[x, y]], ranges: [[low, high]], line, dots, dash, faint}],
///  mark: [x, y], triangle: {x0, x1, y, slope, text}}
/// An axis may have names at places in the place of round numbers: {names: [[value, text]]}.
/// `finding` is what a reader sees in it, for those who cannot.
function chart(what) {
  // On a narrow screen the same letters in a smaller picture, so that they can be read.
  const narrow = matchMedia("(max-width: 760px)").matches;
  const width = narrow ? 430 : 640, height = narrow ? 320 : 400, left = 72, right = 18, top = 16, bottom = 52;
  const place = (axis, value, from, to) => {
    const at = axis.log ? Math.log(value / axis.min) / Math.log(axis.max / axis.min) : (value - axis.min) / (axis.max - axis.min);
    return from + at * (to - from);
  };
  const X = (x) => place(what.x, x, left, width - right);
  const Y = (y) => place(what.y, y, height - bottom, top);
  const inside = ([x, y]) => x >= what.x.min * 0.9999 && x <= what.x.max * 1.0001 && y >= what.y.min * 0.9999 && y <= what.y.max * 1.0001;
  const parts = [];
  const named = new Map(what.x.names);
  let free = -Infinity; // from where on a label does not lie upon the last one
  for (const value of ticks(what.x)) {
    const lines = (named.get(value) ?? written(value)).split(named.has(value) ? /[ -](?=[^\d])/ : /$/);
    const half = 4.5 * Math.max(...lines.map((line) => line.length));
    parts.push(`<line class="grid" x1="${X(value)}" x2="${X(value)}" y1="${top}" y2="${height - bottom}"/>`);
    if (!named.has(value) && X(value) - half < free) continue;
    free = X(value) + half;
    lines.forEach((line, k) => parts.push(`<text class="tick" x="${X(value)}" y="${height - bottom + 20 + 16 * k}" text-anchor="middle">${escapeText(line)}</text>`));
  }
  for (const value of ticks(what.y))
    parts.push(`<line class="grid" x1="${left}" x2="${width - right}" y1="${Y(value)}" y2="${Y(value)}"/>` +
      `<text class="tick" x="${left - 8}" y="${Y(value) + 5}" text-anchor="end">${written(value)}</text>`);
  if (!what.x.names) parts.push(`<text class="label" x="${(left + width - right) / 2}" y="${height - 8}" text-anchor="middle">${escapeText(what.x.label)}</text>`);
  parts.push(`<text class="label" transform="translate(16 ${(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">${escapeText(what.y.label)}</text>`);
  what.series.forEach((series) => {
    const { colour } = series;
    const points = series.points.filter(inside);
    if (series.line !== false && points.length > 1)
      parts.push(`<polyline fill="none" stroke="${colour}" stroke-width="${series.faint ? 1.5 : 2.5}" opacity="${series.faint ? 0.5 : 1}"` +
        `${series.dash ? ' stroke-dasharray="7 5"' : ""} points="${points.map(([x, y]) => `${X(x).toFixed(1)},${Y(y).toFixed(1)}`).join(" ")}"/>`);
    series.ranges?.forEach(([low, high], k) => {
      const x = X(series.points[k][0]), [foot, head] = [low, high].map((y) => Y(Math.min(what.y.max, Math.max(what.y.min, y))));
      parts.push(`<path class="bar" fill="none" stroke="${colour}" stroke-width="2" d="M${x - 6} ${head}h12M${x} ${head}V${foot}M${x - 6} ${foot}h12"/>`);
    });
    if (series.dots)
      for (const [x, y] of points) parts.push(`<circle cx="${X(x).toFixed(1)}" cy="${Y(y).toFixed(1)}" r="4.5" fill="${colour}"><title>${escapeText(series.label)}: ${written(x)}, ${written(y)}</title></circle>`);
  });
  if (what.triangle) {
    const { x0, x1, y, slope, text } = what.triangle;
    const y1 = y * (x1 / x0) ** slope;
    parts.push(`<path class="triangle" d="M${X(x0)} ${Y(y)}H${X(x1)}V${Y(y1)}Z"/><text class="label" x="${X(x1) + 8}" y="${(Y(y) + Y(y1)) / 2 + 5}">${escapeText(text)}</text>`);
  }
  if (what.mark && inside(what.mark))
    parts.push(`<circle class="mark" cx="${X(what.mark[0])}" cy="${Y(what.mark[1])}" r="7"/>`);
  const listed = what.series.filter((series) => series.label);
  const legend = listed.length < 2 ? "" : `<ul class="legend">${listed.map((series) =>
    `<li><span class="swatch${series.dash ? " dashed" : ""}${series.dots && series.line === false ? " dot" : ""}" style="--colour:${series.colour}"></span>${escapeText(series.label)}</li>`).join("")}</ul>`;
  return `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${escapeText(what.finding)}"><title>${escapeText(what.title)}</title>` +
    `<rect class="frame" x="${left}" y="${top}" width="${width - left - right}" height="${height - top - bottom}"/>${parts.join("")}</svg>${legend}`;
}

/// E(gamma) of contact normals around the vertical, as far from the centre as there are many; the circle has none preferred.
function rose(density, title, finding) {
  const size = 400, centre = size / 2, unit = 105;
  const at = (angle, r) => `${(centre + unit * r * Math.sin(angle)).toFixed(1)},${(centre - unit * r * Math.cos(angle)).toFixed(1)}`;
  const quarter = density.length - 1;
  const outline = [];
  for (let k = 0; k <= 4 * quarter; ++k) {
    const folded = k % (2 * quarter) <= quarter ? k % (2 * quarter) : 2 * quarter - (k % (2 * quarter));
    outline.push(at((k / quarter) * (Math.PI / 2), density[folded]));
  }
  return `<svg viewBox="0 0 ${size} ${size}" role="img" aria-label="${escapeText(finding)}"><title>${escapeText(title)}</title>` +
    `<circle class="grid" fill="none" cx="${centre}" cy="${centre}" r="${unit}"/><line class="grid" x1="${centre}" x2="${centre}" y1="10" y2="${size - 10}"/>` +
    `<line class="grid" x1="10" x2="${size - 10}" y1="${centre}" y2="${centre}"/>` +
    `<polygon points="${outline.join(" ")}" fill="${colours.closed_form}" fill-opacity="0.25" stroke="${colours.closed_form}" stroke-width="2.5"/>` +
    `<text class="label" x="${centre + 8}" y="22">v</text><text class="label" x="${size - 20}" y="${centre - 8}">h</text></svg>`;
}

/// The picture as a file of its own: colours resolved, so that it looks the same elsewhere.
function standalone(svg) {
  const copy = svg.cloneNode(true);
  const originals = [svg, ...svg.querySelectorAll("*")];
  [copy, ...copy.querySelectorAll("*")].forEach((element, k) => {
    const style = getComputedStyle(originals[k]);
    for (const key of ["fill", "stroke", "stroke-width", "stroke-dasharray", "opacity", "fill-opacity", "font-size", "font-family", "text-anchor"])
      if (element.tagName !== "title") element.setAttribute(key, style.getPropertyValue(key));
    element.removeAttribute("class");
  });
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  return new XMLSerializer().serializeToString(copy);
}

function saveFile(name, text, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
