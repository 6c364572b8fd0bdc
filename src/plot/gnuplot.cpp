// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <iterator>

#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/plot/chart.hpp>

#include "look.hpp"

namespace granum::plot {

namespace {

/// A text in single quotes, in which only the quote itself is special.
std::string quoted(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  std::string escaped = "'";
  for (const char c : text)
    escaped += c == '\'' ? "''" : std::string(1, c);
  return escaped + "'";
}

/// The name of a file. gnuplot runs names that begin with < or | as commands and gives -, + and ~ meanings of
/// their own.
std::string quoted_file(const std::string& name) {
  const bool plain = name.starts_with('/') || name.starts_with('.') || name.starts_with('_') ||
                     (!name.empty() && std::isalnum(static_cast<unsigned char>(name[0])) != 0);
  return quoted((plain ? "" : "./") + name);
}

constexpr int point_types[] = {7, 5, 13, 9}; // filled circle, square, diamond, triangle
constexpr std::size_t dash_types = 4;

/// Colour, dash and mark of the series at that place, as in the SVG.
std::string line_style(const Series& series, std::size_t place) {
  const std::size_t index = series.style.value_or(place);
  const bool thin = series.tone == Tone::faint || series.tone == Tone::grey;
  const int hollow = series.tone == Tone::hollow ? 1 : 0; // the type before each filled one
  return "set style line " + std::to_string(place + 1) + " linewidth " + (thin ? "1" : "2") + " pointsize " +
         (thin ? "0.4" : "0.6") + " linecolor rgb '" + colour_of(series, place) + "' dashtype " +
         std::to_string(index % dash_types + 1) + " pointtype " +
         std::to_string(point_types[index % std::size(point_types)] - hollow) + "\n";
}

std::string column(const std::string& heading, double unit) {
  return "(column(" + quoted(heading) + ")/" + exact_text(unit) + ")";
}

const char* style(const Series& series) {
  switch (series.mark) {
  case Mark::line:
    return "lines";
  case Mark::marker:
    return "points";
  case Mark::area:
    return "filledcurves closed fillstyle transparent solid 0.18 noborder";
  case Mark::both:
    break;
  }
  return "linespoints";
}

std::string axis(const char* letter, const Axis& axis) {
  std::string text = "set " + std::string(letter) + "label " + quoted(axis.title) + "\n";
  if (axis.scale == Scale::logarithmic)
    text += "set logscale " + std::string(letter) + "\n";
  if (axis.reversed)
    text += "set " + std::string(letter) + "range [*:*] reverse\n";
  return text;
}

std::string plots(const Chart& chart, const std::string& csv, const std::vector<CsvColumns>& columns) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const CsvColumns& c = columns[k];
    const Series& series = chart.series[k];
    const std::string number = std::to_string(k + 1);
    const std::string xy = column(c.x, chart.x.unit) + ":" + column(c.y, chart.y.unit);
    parts.push_back(quoted_file(csv) + " using " + xy + " with " + style(series) + " linestyle " + number +
                    (series.name.empty() ? " notitle" : " title " + quoted(series.name)));
    if (!c.y_error.empty())
      parts.push_back(quoted_file(csv) + " using " + xy + ":" + column(c.y_error, chart.y.unit) +
                      " with yerrorbars linestyle " + number + " dashtype 1" +
                      (series.mark == Mark::line ? " pointtype 0" : "") + " notitle");
  }
  std::string text;
  for (const std::string& part : parts)
    text += (text.empty() ? "plot " : ", \\\n     ") + part;
  return text + "\n";
}

} // namespace

std::string gnuplot_script(const Chart& chart, const std::string& csv, const std::vector<CsvColumns>& columns,
                           const std::string& picture) {
  require_valid(chart);
  if (columns.size() != chart.series.size())
    throw InvalidArgument("there are columns for " + std::to_string(columns.size()) + " series, and " +
                          std::to_string(chart.series.size()) + " series");
  std::string text = "# Redraws the picture from " + quoted_file(csv) +
                     " in the folder where gnuplot runs.\n"
                     "set terminal svg noenhanced size 900,500 background rgb 'white'\n"
                     "set encoding utf8\n"
                     "set output " +
                     quoted_file(picture) +
                     "\nset datafile separator comma\n"
                     "set datafile commentschars '#'\n"
                     "set datafile columnheaders\n"
                     "set key outside right top\n"
                     "set grid\n";
  text += "set title " + quoted(chart.title) + "\n" + axis("x", chart.x) + axis("y", chart.y);
  for (std::size_t k = 0; k < chart.series.size(); ++k)
    text += line_style(chart.series[k], k);
  return text + (columns.empty() ? "" : plots(chart, csv, columns));
}

} // namespace granum::plot
