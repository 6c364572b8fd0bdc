// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_parts.hpp"

namespace granum::plot {

const char* page_script() {
  return R"js(
"use strict";
document.documentElement.classList.add("live");

// Values under the pointer.
const tip = document.createElement("div");
tip.className = "tip";
tip.hidden = true;
document.body.append(tip);
const short = (value) => (value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e5)
  ? String(Number(value.toPrecision(4))) : value.toExponential(2));
const number = (element, name) => Number(element.getAttribute(name));
const words = (svg, kind) => svg.querySelector("." + kind)?.textContent ?? "";

// From coordinates of the picture to those of an axis: "log 1 2" are decimal logarithms.
function scale(text, from, length) {
  const [kind, low, high] = text.split(" ");
  return (place) => {
    const value = Number(low) + ((place - from) / length) * (Number(high) - Number(low));
    return kind === "log" ? 10 ** value : value;
  };
}

function vertices(series) {
  const line = series.querySelector(".line");
  if (line)
    return [...line.getAttribute("d").matchAll(/[ML](-?[\d.]+),(-?[\d.]+)/g)]
      .map((corner) => [Number(corner[1]), Number(corner[2])]);
  return [...(series.querySelector(".dots")?.children ?? [])].map((dot) => {
    const box = dot.getBBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  });
}

const seen = new WeakMap();
function points(svg) {
  if (!seen.has(svg))
    seen.set(svg, [...svg.querySelectorAll(".series")].flatMap((series) =>
      vertices(series).map(([x, y]) => ({ x, y, series }))));
  return seen.get(svg);
}

// A series of a kind that is not listed itself has its colour from one that is: that is its shape.
function nameOf(svg, series) {
  const keys = [...svg.querySelectorAll(".key[data-series]")];
  const alike = (key) => key.querySelector("[color]")?.getAttribute("color") === series.getAttribute("color");
  const key = keys.find((one) => one.dataset.series === series.dataset.series) ??
    (series.dataset.kind ? keys.find(alike) : undefined);
  return [key?.querySelector("text").textContent, series.dataset.kind].filter(Boolean).join(", ");
}
// The unit in an axis' title, behind a blank: "p' [kPa]".
const unitOf = (svg, axis) => {
  const unit = words(svg, axis).match(/\[([^\]]+)\]/)?.[1];
  return unit && unit !== "1" ? " " + unit : "";
};
function named(svg, series) {
  const name = nameOf(svg, series);
  return name ? name + ": " : "";
}

// What lies nearest to a place of a picture, in words, no farther away than `reach`: of a chart on axes,
function ofChart(svg, frame, x, y, reach) {
  let best, least = reach;
  for (const point of points(svg)) {
    const distance = Math.hypot(point.x - x, point.y - y);
    if (distance < least && !point.series.classList.contains("faded")) [best, least] = [point, distance];
  }
  if (!best) return "";
  const left = number(frame, "x"), top = number(frame, "y"), height = number(frame, "height");
  const across = scale(frame.dataset.x, left, number(frame, "width"));
  const up = scale(frame.dataset.y, top + height, -height);
  const error = [...best.series.querySelectorAll(".error")].find((bar) => {
    const at = bar.getBBox();
    return Math.abs(at.x + at.width / 2 - best.x) < 0.1 && at.y < best.y + 0.1 &&
      at.y + at.height > best.y - 0.1;
  });
  const bar = error?.getBBox();
  const range = bar ? " \u00b1 " + short((up(bar.y) - up(bar.y + bar.height)) / 2) : "";
  return named(svg, best.series) + short(up(best.y)) + range + unitOf(svg, "y-title") + " at " +
    short(across(best.x)) + unitOf(svg, "x-title");
}

// of a rose, whose angles from the vertical are told in degrees,
function ofRose(svg, rose, x, y, reach) {
  const across = Math.abs(x - number(rose, "cx")), up = Math.abs(y - number(rose, "cy"));
  const angle = Math.atan2(across, up), away = Math.hypot(across, up);
  const length = (value) => (value * number(rose, "r")) / Number(rose.dataset.most);
  const degrees = (radians) => short((180 * radians) / Math.PI) + "\u00b0";
  let text = "", least = reach;
  for (const series of svg.querySelectorAll(".series:not(.faded)")) {
    const rows = series.dataset.values?.split(";").map((row) => row.split(" ").map(Number));
    if (!rows) {
      for (const [px, py] of vertices(series)) {
        const distance = Math.hypot(px - x, py - y);
        if (distance >= least) continue;
        const dx = Math.abs(px - number(rose, "cx")), dy = Math.abs(py - number(rose, "cy"));
        const value = (Math.hypot(dx, dy) / number(rose, "r")) * Number(rose.dataset.most);
        least = distance;
        text = named(svg, series) + short(value) + " at " + degrees(Math.atan2(dx, dy));
      }
      continue;
    }
    const nearest = rows.reduce((a, b) => (Math.abs(b[0] - angle) < Math.abs(a[0] - angle) ? b : a));
    const [middle, value, error] = nearest;
    const bars = series.querySelector(".sectors");
    // Within a bar all but its lines is farther away than they are.
    const distance = bars ? Math.max(away - length(value), reach / 3)
      : Math.hypot(away - length(value), away * (angle - middle));
    if (distance >= least) continue;
    least = distance;
    const range = error > 0 ? " \u00b1 " + short(error) : "";
    text = named(svg, series) + short(value) + range + " at " + degrees(middle);
  }
  return text;
}

// of force chains.
function ofForces(svg, x, y, reach) {
  let best, least = reach;
  for (const line of svg.querySelectorAll("[data-f]")) {
    const [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map((name) => number(line, name));
    const dx = x2 - x1, dy = y2 - y1;
    const share = Math.max(0, Math.min(1, ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy || 1)));
    const distance = Math.hypot(x1 + share * dx - x, y1 + share * dy - y);
    if (distance < least) [best, least] = [line, distance];
  }
  if (!best) return "";
  const share = Number(best.dataset.f), mean = Number(best.parentElement.dataset.mean);
  return short(share * mean) + " N, " + short(share) + " of the mean force";
}

function show(svg, event) {
  const box = svg.getBoundingClientRect(), view = svg.viewBox.baseVal;
  const per = view.width / box.width;
  const x = (event.clientX - box.left) * per, y = (event.clientY - box.top) * per, reach = 24 * per;
  const frame = svg.querySelector(".frame"), rose = svg.querySelector(".rose");
  const text = frame ? ofChart(svg, frame, x, y, reach) : rose ? ofRose(svg, rose, x, y, reach)
    : ofForces(svg, x, y, reach / 2);
  tip.hidden = !text;
  if (tip.hidden) return;
  tip.textContent = text;
  const wide = document.documentElement.clientWidth;
  tip.style.left = Math.max(4, Math.min(event.pageX + 12, wide - tip.offsetWidth - 8)) + "px";
  tip.style.top = event.pageY - 36 + "px";
}

for (const svg of document.querySelectorAll("svg.chart")) {
  svg.addEventListener("pointermove", (event) => show(svg, event));
  svg.addEventListener("pointerleave", () => { tip.hidden = true; });
  // A name in the legend fades what it stands for, and brings it back.
  for (const key of svg.querySelectorAll(".key")) {
    key.setAttribute("tabindex", "0");
    key.setAttribute("role", "button");
    key.setAttribute("aria-pressed", "false");
    key.setAttribute("aria-label", "fade " + key.textContent.trim());
    const fade = () => {
      const away = key.getAttribute("aria-pressed") === "false";
      key.setAttribute("aria-pressed", String(away));
      key.classList.toggle("faded", away);
      for (const series of svg.querySelectorAll(".series")) {
        const same = key.dataset.kind ? series.dataset.kind === key.dataset.kind
          : series.dataset.series === key.dataset.series;
        if (same) series.classList.toggle("faded", away);
      }
    };
    key.addEventListener("click", fade);
    key.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      fade();
    });
  }
  svg.setAttribute("role", "group");
}

// One picture of a choice at a time.
for (const figure of document.querySelectorAll("figure")) {
  const panels = [...figure.querySelectorAll(".panel[data-choice]")];
  const choices = [...new Set(panels.map((panel) => panel.dataset.choice))];
  if (choices.length < 2) continue;
  const bar = document.createElement("div");
  bar.className = "switch";
  const choose = (choice) => {
    for (const panel of panels) panel.classList.toggle("unchosen", panel.dataset.choice !== choice);
    for (const button of bar.children)
      button.setAttribute("aria-pressed", String(button.textContent === choice));
  };
  for (const choice of choices) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = choice;
    button.addEventListener("click", () => choose(choice));
    bar.append(button);
  }
  panels[0].parentElement.before(bar);
  choose(choices[0]);
}
)js";
}

} // namespace granum::plot
