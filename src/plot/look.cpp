// SPDX-License-Identifier: GPL-3.0-or-later
#include "look.hpp"

#include <algorithm>
#include <array>

#include <granum/core/text.hpp>

namespace granum::plot {

namespace {

constexpr std::size_t colours = std::size(palette);

constexpr std::array dashes{"", "8 4", "2 3", "10 3 2 3"};
constexpr std::size_t shapes = 4;
constexpr double glyph_width = 0.62; // of a letter over its height, a wide estimate
constexpr double sample_width = 42;  // line and marker in front of a name
constexpr double legend_margin = 14; // between names in a row

std::string class_of(std::size_t colour, Tone tone) {
  return tone == Tone::grey ? "cg" : "c" + std::to_string(colour % colours);
}

const char* light(std::size_t colour, Tone tone) {
  return tone == Tone::grey ? reference_grey.light : palette[colour % colours].light;
}

std::size_t colour_index(const Series& series, std::size_t place) {
  return series.colour ? static_cast<std::size_t>(*series.colour) : series.style.value_or(place);
}

std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count)
    text.remove_prefix(std::max<std::size_t>(1, utf8_length(text)));
  return count;
}

} // namespace

const char* colour_of(const Series& series, std::size_t place) {
  return light(colour_index(series, place), series.tone);
}

SvgAttributes svg_colour(Colour colour) {
  const auto row = static_cast<std::size_t>(colour);
  return {{"class", class_of(row, Tone::full)}, {"color", light(row, Tone::full)}};
}

std::string dark_rules() {
  std::string rules = ".chart{color:#e9ebee}.chart .paper{fill:#15181c}.chart .grid{stroke:#3a4048}";
  rules += ".cg{color:" + std::string(reference_grey.dark) + "}";
  for (std::size_t k = 0; k < colours; ++k)
    rules += ".c" + std::to_string(k) + "{color:" + palette[k].dark + "}";
  return "@media screen and (prefers-color-scheme:dark){" + rules + "}";
}

std::string pair(const Spot& at) { return svg_number(at.x) + "," + svg_number(at.y); }

double text_width(std::string_view text, double size) {
  return glyph_width * size * static_cast<double>(characters(text));
}

std::vector<std::string> wrapped(const std::string& text, double width, double size) {
  std::vector<std::string> lines;
  std::size_t from = 0;
  while (from < text.size()) {
    std::size_t end = text.size();
    while (text_width(std::string_view(text).substr(from, end - from), size) > width) {
      const std::size_t blank = text.rfind(' ', end - 1);
      if (blank == std::string::npos || blank <= from)
        break; // one long word
      end = blank;
    }
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

Look::Look(const Series& series, std::size_t place)
    : index_(series.style.value_or(place)), colour_(colour_index(series, place)), place_(place),
      tone_(series.tone), kind_(series.kind) {}

SvgAttributes Look::stroke() const {
  const bool thin = tone_ == Tone::faint || tone_ == Tone::grey;
  SvgAttributes attributes = {
      {"class", "line"}, {"fill", "none"}, {"stroke", "currentColor"}, {"stroke-width", thin ? "1.3" : "2"}};
  const char* dash = dashes.at(index_ % dashes.size());
  if (*dash != '\0')
    attributes.emplace_back("stroke-dasharray", dash);
  return attributes;
}

SvgAttributes Look::filling() const {
  if (tone_ == Tone::hollow)
    return {{"class", "dots paper"}, {"fill", "white"}, {"stroke", "currentColor"}, {"stroke-width", "1.5"}};
  return {{"class", "dots"}, {"fill", "currentColor"}};
}

SvgAttributes Look::group() const {
  SvgAttributes attributes = {{"class", "series " + class_of(colour_, tone_)},
                              {"color", light(colour_, tone_)},
                              {"data-series", std::to_string(place_)}};
  if (!kind_.empty())
    attributes.emplace_back("data-kind", kind_);
  if (tone_ == Tone::faint)
    attributes.emplace_back("opacity", "0.55");
  return attributes;
}

std::string Look::marker(const Spot& p) const {
  const double s = marker_size();
  switch (index_ % shapes) {
  case 0:
    return svg_element("circle", {{"cx", svg_number(p.x)}, {"cy", svg_number(p.y)}, {"r", svg_number(s)}});
  case 1:
    return svg_element("rect", {{"x", svg_number(p.x - s)},
                                {"y", svg_number(p.y - s)},
                                {"width", svg_number(2 * s)},
                                {"height", svg_number(2 * s)}});
  case 2:
    return svg_element("path",
                       {{"d", "M" + pair({p.x, p.y - 1.4 * s}) + "L" + pair({p.x + 1.4 * s, p.y}) + "L" +
                                  pair({p.x, p.y + 1.4 * s}) + "L" + pair({p.x - 1.4 * s, p.y}) + "Z"}});
  default:
    return svg_element("path",
                       {{"d", "M" + pair({p.x, p.y - 1.3 * s}) + "L" + pair({p.x + 1.2 * s, p.y + 0.9 * s}) +
                                  "L" + pair({p.x - 1.2 * s, p.y + 0.9 * s}) + "Z"}});
  }
}

std::string surface(const std::string& path) {
  return svg_element("path",
                     {{"class", "area"}, {"fill", "currentColor"}, {"fill-opacity", "0.18"}, {"d", path}});
}

std::string error_bar(double x, double high, double low) {
  constexpr double cap = 4.5;
  const auto crossbar = [x](double y) { return "M" + pair({x - cap, y}) + "H" + svg_number(x + cap); };
  return svg_element("path",
                     {{"class", "error"},
                      {"d", crossbar(high) + "M" + pair({x, high}) + "V" + svg_number(low) + crossbar(low)}});
}

Legend::Legend(const Chart& chart) : rose_(chart.rose) {
  for (std::size_t k = 0; k < chart.series.size(); ++k)
    if (!chart.series[k].name.empty())
      entries_.push_back({chart.series[k].name, &chart.series[k], k, false});
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    const std::string& kind = chart.series[k].kind;
    const bool listed = std::any_of(entries_.begin(), entries_.end(),
                                    [&](const Entry& e) { return e.shared && e.name == kind; });
    if (!kind.empty() && !listed)
      entries_.push_back({kind, &chart.series[k], k, true});
  }
}

double Legend::length(const Entry& entry) { return sample_width + text_width(entry.name); }

double Legend::widest() const {
  double most = 0;
  for (const Entry& entry : entries_)
    most = std::max(most, length(entry));
  return most;
}

std::vector<Spot> Legend::places(double width) const {
  std::vector<Spot> out;
  Spot next;
  for (const Entry& entry : entries_) {
    if (next.x > 0 && next.x + length(entry) > width)
      next = {0, next.y + legend_line};
    out.push_back(next);
    next.x += length(entry) + legend_margin;
  }
  return out;
}

double Legend::height(double width) const {
  return entries_.empty() ? 0 : places(width).back().y + legend_line;
}

std::string Legend::drawn(const Entry& entry, const Spot& at) const {
  const Series& alike = *entry.series;
  const Look look(alike, entry.place);
  const Spot middle{at.x + 17, at.y};
  std::string svg, sample;
  if (alike.mark == Mark::area)
    sample += surface("M" + pair({at.x, at.y - 6}) + "h34v12h-34Z");
  if (alike.mark == Mark::line || alike.mark == Mark::both) {
    SvgAttributes attributes = look.stroke();
    attributes.emplace_back("d", "M" + pair(at) + "H" + svg_number(at.x + 34));
    sample += svg_element("path", attributes);
  }
  if (std::any_of(alike.y_error.begin(), alike.y_error.end(), [](double e) { return e > 0; }))
    sample += svg_group({{"fill", "none"}, {"stroke", "currentColor"}},
                        error_bar(middle.x, middle.y - 8, middle.y + 8));
  if (alike.mark == Mark::marker && rose_)
    sample += svg_element("rect", {{"x", svg_number(at.x + 6)},
                                   {"y", svg_number(at.y - 7)},
                                   {"width", "22"},
                                   {"height", "14"},
                                   {"fill", "currentColor"},
                                   {"fill-opacity", "0.16"},
                                   {"stroke", "currentColor"}});
  else if (alike.mark == Mark::marker || alike.mark == Mark::both)
    sample += svg_group(look.filling(), look.marker(middle));
  SvgAttributes group = look.group();
  const std::size_t name_of_group = std::string_view("series ").size();
  group[0].second = entry.shared ? "cg" : group[0].second.substr(name_of_group);
  if (entry.shared)
    group[1].second = reference_grey.light;
  std::erase_if(group, [](const auto& attribute) { return attribute.first.starts_with("data-"); });
  svg += svg_group(group, sample) +
         svg_text("legend", {{"x", svg_number(at.x + sample_width)}, {"y", svg_number(at.y + 5)}},
                  svg_escaped(entry.name));
  return svg_group(
      {{"class", "key"},
       {entry.shared ? "data-kind" : "data-series", entry.shared ? entry.name : std::to_string(entry.place)}},
      svg);
}

std::string Legend::rows(const Spot& corner, double width) const {
  std::string svg;
  const std::vector<Spot> at = places(width);
  for (std::size_t k = 0; k < entries_.size(); ++k)
    svg += drawn(entries_[k], {corner.x + at[k].x, corner.y + at[k].y});
  return svg;
}

std::string Legend::column(const Spot& corner) const {
  std::string svg;
  for (std::size_t k = 0; k < entries_.size(); ++k)
    svg += drawn(entries_[k], {corner.x, corner.y + legend_line * static_cast<double>(k)});
  return svg;
}

} // namespace granum::plot
