// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/page.hpp>

#include <algorithm>

#include <granum/plot/svg_text.hpp>

#include "look.hpp"

namespace granum::plot {

namespace {

// The head of every page.

const char* page_style() {
  return R"(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1c1f23; --soft: #565d66; --rule: #d5d9de;
  --panel: #f5f6f8; --link: #0b5394; --yes: #00664a; --no: #a83200; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #15181c; --ink: #e9ebee; --soft: #a9b1ba; --rule: #3a4048; --panel: #1d2126;
    --link: #8cc8f0; --yes: #3fc79a; --no: #f59a63; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 0 1.2rem 3rem; background: var(--paper); color: var(--ink);
  font: 17px/1.5 system-ui, Helvetica, Arial, sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 1.2rem 0 0.6rem; }
h2 { font-size: 1.35rem; margin: 2.2rem 0 0.4rem; padding-top: 1.2rem; border-top: 1px solid var(--rule); }
h3 { font-size: 1.05rem; margin: 0.8rem 0 0.2rem; }
a { color: var(--link); }
p { margin: 0.5rem 0; max-width: 46rem; }
.first { display: grid; gap: 0 2.2rem; grid-template-columns: minmax(0, 5fr) minmax(0, 6fr);
  align-items: start; }
.first h1 { grid-column: 1 / -1; }
.answer p { font-size: 1.08rem; margin: 0 0 0.8rem; }
.soft, figcaption { color: var(--soft); font-size: 0.93rem; }
figure { margin: 0.6rem 0 1.2rem; }
figcaption { margin: 0.3rem 0; max-width: 46rem; }
.panels { display: grid; gap: 0.8rem 1.4rem;
  grid-template-columns: repeat(auto-fit, minmax(min(21rem, 100%), 1fr)); }
.panel svg { display: block; width: 100%; height: auto; max-width: 46rem; }
.trio { display: grid; gap: 0 1.6rem;
  grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr)); }
.row .panels { grid-template-columns: repeat(auto-fit, minmax(min(13rem, 100%), 1fr)); }
.unchosen { display: none; }
.switch button { font: inherit; font-size: 0.93rem; margin: 0 0.4rem 0.4rem 0; padding: 0.2rem 0.8rem;
  cursor: pointer; color: var(--ink);
  background: var(--panel); border: 1px solid var(--soft); border-radius: 5px; }
.switch button[aria-pressed="true"] { color: var(--paper); background: var(--ink); }
.wide { overflow-x: auto; background:
  linear-gradient(to right, var(--paper) 30%, transparent) 0 0 / 3rem 100% local no-repeat,
  linear-gradient(to left, var(--paper) 30%, transparent) 100% 0 / 3rem 100% local no-repeat,
  linear-gradient(to right, var(--soft), transparent) 0 0 / 0.8rem 100% scroll no-repeat,
  linear-gradient(to left, var(--soft), transparent) 100% 0 / 0.8rem 100% scroll no-repeat; }
table { border-collapse: collapse; font-size: 0.92rem; margin: 0.5rem 0 1rem; }
th, td { padding: 0.2rem 1rem 0.2rem 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid var(--rule); }
th { color: var(--soft); font-weight: 600; }
td.number, th.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.yes { color: var(--yes); }
.no { color: var(--no); font-weight: 600; }
li { margin: 0.2rem 0; max-width: 46rem; }
details { border-top: 1px solid var(--rule); padding: 0.5rem 0; }
summary { cursor: pointer; font-weight: 600; }
.faded { opacity: 0.12; }
.key { cursor: default; }
.live .key { cursor: pointer; }
.key:focus-visible, button:focus-visible, summary:focus-visible { outline: 3px solid var(--link); }
.tip { position: absolute; z-index: 2; pointer-events: none; padding: 0.15rem 0.5rem; font-size: 0.9rem;
  color: var(--paper); background: var(--ink); border-radius: 4px; white-space: nowrap; }
@media (max-width: 52rem) {
  body { font-size: 16px; padding: 0 0.9rem 2rem; }
  .first { grid-template-columns: minmax(0, 1fr); }
}
@page { size: A4; margin: 18mm 16mm; }
@media print {
  html { font-size: 10pt; }
  body { max-width: none; font-size: 1rem; padding: 0; }
  p, li { max-width: none; }
  .wide { overflow: visible; }
  table { font-size: 0.86rem; }
  th, td { padding-right: 0.6rem; }
  td a { overflow-wrap: anywhere; }
  pre { white-space: pre-wrap; }
  a { color: inherit; }
  .switch, .tip { display: none; }
  .unchosen { display: block; }
  .trio figure, .panel, tr { break-inside: avoid; }
  h1, h2 { margin-top: 0.8rem; }
  h2 { padding-top: 0.6rem; }
  h2, h3 { break-after: avoid; }
  .first { display: block; }
  .first:not(:has(.panel + .panel)) { display: grid; gap: 0 1.2rem;
    grid-template-columns: minmax(0, 6fr) minmax(0, 5fr); }
  .panels { grid-template-columns: 1fr 1fr; }
  .first:not(:has(.panel + .panel)) .panels { grid-template-columns: 1fr; }
  .trio { grid-template-columns: 1fr 1fr 1fr; gap: 0 1rem; }
  .trio .panels { grid-template-columns: 1fr; }
  .row .panels { grid-template-columns: repeat(4, 1fr); gap: 0 0.6rem; }
}
)";
}

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

// of a rose, whose angles from the vertical are given in degrees,
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
  // A name in the legend fades its series, and brings it back.
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

constexpr std::string_view missing = "-";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// "12.5 MPa" or "4.50 to 4.99 kPa", but not a sentence that begins with a digit, "6 of 200 grains".
bool is_number(const std::string& cell) {
  const std::size_t first = cell.starts_with('-') || cell.starts_with('+') ? 1 : 0;
  if (cell.size() <= first || cell[first] < '0' || cell[first] > '9')
    return false;
  int words = 0;
  for (std::size_t begin = cell.find(' '); begin != std::string::npos; begin = cell.find(' ', begin + 1))
    if (begin + 1 < cell.size() && is_letter(cell[begin + 1]) && cell.compare(begin + 1, 3, "to ") != 0)
      ++words;
  return words <= 1;
}

std::string link(const PageFile& file) {
  return "<a href=\"" + svg_escaped(file.address) + "\">" + svg_escaped(file.name) + "</a>";
}

std::string panel(const PagePicture& picture) {
  const std::string choice =
      picture.choice.empty() ? "" : " data-choice=\"" + svg_escaped(picture.choice) + "\"";
  return "<div class=\"panel\"" + choice + ">\n" + picture.svg + "</div>\n";
}

} // namespace

std::string html_element(const std::string& tag, const std::string& content, const std::string& text_class) {
  return "<" + tag + (text_class.empty() ? "" : " class=\"" + text_class + "\"") + ">" + content + "</" +
         tag + ">\n";
}

std::string html_wide(const std::string& content) {
  return "<div class=\"wide\" tabindex=\"0\">" + content + "</div>\n";
}

std::string html_paragraph(std::string_view text, const std::string& text_class) {
  return html_element("p", svg_escaped(printed_signs(text)), text_class);
}

std::string html_list(const std::vector<std::string>& items) {
  std::string content;
  for (const std::string& item : items)
    content += html_element("li", svg_escaped(printed_signs(item)));
  return html_element("ul", content);
}

std::string html_preformatted(std::string_view text) {
  std::string lines; // one by one, since line ends are no characters that an element of SVG may have
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += svg_escaped(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return html_wide("<pre>" + lines + "</pre>\n");
}

std::string html_section(const std::string& id, std::string_view title, const std::string& content) {
  return "<section id=\"" + svg_escaped(id) + "\">\n" + html_element("h2", svg_escaped(title)) + content +
         "</section>\n";
}

std::string html_folded(std::string_view title, const std::string& content) {
  return html_element("details", html_element("summary", svg_escaped(title)) + content);
}

std::string html_table(const std::vector<std::string>& headings,
                       const std::vector<std::vector<std::string>>& rows) {
  // A column of numbers is one still where some of them are missing.
  std::vector<bool> numbers(headings.size()), words(headings.size());
  for (const std::vector<std::string>& row : rows)
    for (std::size_t k = 0; k < std::min(row.size(), headings.size()); ++k)
      if (is_number(row[k]))
        numbers[k] = true;
      else if (row[k] != missing && !row[k].empty())
        words[k] = true;
  const auto of_numbers = [&](std::size_t k) { return k < numbers.size() && numbers[k] && !words[k]; };
  std::string head;
  for (std::size_t k = 0; k < headings.size(); ++k)
    head += html_element(headings[k].empty() ? "td" : "th", svg_escaped(headings[k]),
                         of_numbers(k) ? "number" : "");
  std::string body;
  for (const std::vector<std::string>& row : rows) {
    std::string cells;
    for (std::size_t k = 0; k < row.size(); ++k)
      cells += html_element("td", svg_escaped(printed_signs(row[k])),
                            is_number(row[k]) || of_numbers(k) ? "number" : "");
    body += html_element("tr", cells);
  }
  return html_wide(html_element("table", html_element("tr", head) + body));
}

std::string html_figure(const PageFigure& figure) {
  std::string panels, files;
  for (const PagePicture& picture : figure.pictures)
    panels += panel(picture);
  for (const PageFile& file : figure.files)
    files += (files.empty() ? " " : ", ") + link(file);
  const std::string title = figure.title.empty() ? "" : html_element("h3", svg_escaped(figure.title));
  return html_element("figure", title + html_element("div", panels, "panels") +
                                    html_element("figcaption", svg_escaped(figure.caption) + files));
}

std::string html_first_screen(std::string_view question, const std::vector<std::string>& answer,
                              const PageFigure& figure) {
  std::string sentences;
  for (const std::string& sentence : answer)
    sentences += html_paragraph(sentence);
  return html_element("header",
                      html_element("h1", svg_escaped(question)) + html_element("div", sentences, "answer") +
                          html_figure(figure),
                      "first");
}

std::string html_page(std::string_view title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
         html_element("title", svg_escaped(title)) +
         html_element("style", page_style() + dark_rules() + "\n") + "</head>\n<body>\n" +
         html_element("main", body) + html_element("script", page_script()) + "</body>\n</html>\n";
}

} // namespace granum::plot
