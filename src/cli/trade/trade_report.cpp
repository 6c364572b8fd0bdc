// SPDX-License-Identifier: GPL-3.0-or-later
#include "trade_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/io/csv/columns.hpp>
#include <granum/plot/chart.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/options/scene_file.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using studies::Boundary;
using studies::TradeRow;
using studies::TradeSample;
using studies::TradeScene;
using studies::Varied;

/// Title of a block of the table.
std::string title(const TradeScene& trade, Varied varied) {
  switch (varied) {
  case Varied::grains:
    return "number of grains, periodic cell; G and s by the network; cost from packing to peak";
  case Varied::compression:
    return "inertial number of compression; cost of compression through all pressures";
  case Varied::shear:
    return "inertial number of triaxial compression; G_vh at q/p' = 0.8; cost of the test to an axial "
           "strain of " +
           percent_text(trade.shear_strain);
  case Varied::time_step:
    return "time step over its stability limit; cost of compression, and of shear where there is a peak";
  case Varied::probe:
    return "strain of the cyclic probe divided by (mean overlap/diameter), 0: the network; G_vh; cost of "
           "one modulus";
  case Varied::boundary:
    return "boundary and number of grains: periodic cell, smooth or rough walls; mean of G_hh and G_vh by "
           "the probe; cost of the specimen";
  }
  return {};
}

/// Label of a row, with a star if the others are compared with it.
std::string label(const TradeRow& row) {
  const std::string value = short_text(row.value) + (row.reference ? "*" : "");
  if (row.varied != Varied::boundary)
    return value;
  const std::string boundary(studies::name(row.boundary));
  return boundary.substr(0, boundary.find('-')) + " " + value;
}

constexpr const char* panel_title(Varied varied) {
  switch (varied) {
  case Varied::grains:
    return "Grains";
  case Varied::compression:
    return "Rate of compression";
  case Varied::shear:
    return "Rate of shear";
  case Varied::time_step:
    return "Time step";
  case Varied::probe:
    return "Probe strain";
  case Varied::boundary:
    break;
  }
  return "Walls";
}

/// Quantities with an error due to the varied setting, relative to the reference.
bool is_drawn(const TradeRow& row) {
  const bool other_boundary = row.varied == Varied::boundary && row.boundary == Boundary::periodic;
  const bool is_reference = row.reference && row.varied != Varied::grains;
  return row.shear_modulus && row.boundary != Boundary::smooth_walls && !other_boundary && !is_reference;
}

/// Adds the error of a row over its cost to the series of its density.
void add_row(plot::Chart& panel, const TradeRow& row) {
  const std::string name(studies::name(row.density));
  auto series = std::find_if(panel.series.begin(), panel.series.end(),
                             [&](const plot::Series& s) { return s.name == name; });
  if (series == panel.series.end()) {
    const bool dense = row.density == triaxial::Density::dense;
    series = panel.series.insert(series, plot::Series{.name = name,
                                                      .style = dense ? 0 : 1,
                                                      .tone = dense ? plot::Tone::full : plot::Tone::hollow,
                                                      .colour = plot::Colour::measured});
  }
  series->add(row.cpu_seconds, error_of(row), row.shear_modulus->standard_error);
}

/// The first columns of rows and samples.
template <class Row>
io::Columns<Row> subject_columns() {
  return {{"varied", "varied", [](const Row& row) { return studies::name(row.varied); }},
          {"boundary", "boundary", [](const Row& row) { return studies::name(row.boundary); }},
          {"value", "value", &Row::value},
          {"density", "density", [](const Row& row) { return studies::name(row.density); }}};
}

/// Adds the three parts of a deviation, and the display of its mean.
void add_deviation(io::Columns<TradeRow>& to, const std::string& name,
                   std::optional<studies::Deviation> TradeRow::*of, io::ShownColumn shown,
                   int scatter_width) {
  using studies::Deviation;
  to.emplace_back("", name, [of](const TradeRow& row) { return row.*of ? io::Value() : io::Value(nullptr); });
  for (const auto& [heading, key, part] : {std::tuple{"_bias", "/bias", &Deviation::bias},
                                           {"_error", "/standard_error", &Deviation::standard_error},
                                           {"_scatter", "/scatter", &Deviation::scatter}})
    to.emplace_back(name + heading, name + key, [of, part = part](const TradeRow& row) {
      return row.*of ? std::optional((*(row.*of)).*part) : std::nullopt;
    });
  to.back().shown = shown;
  to.back().shown->heading = "scatter";
  to.back().shown->width = scatter_width;
  to.back().shown->sign = false;
  const auto mean = [of](const TradeRow& row) {
    return row.*of ? std::optional(Measured{(*(row.*of)).bias, (*(row.*of)).standard_error}) : std::nullopt;
  };
  to.insert(to.end() - 1, {"", "", mean, shown});
}

/// Columns of a row, for table, JSON and terminal.
const io::Columns<TradeRow>& row_columns() {
  static const io::Columns<TradeRow> columns = [] {
    io::Columns<TradeRow> list = subject_columns<TradeRow>();
    list.insert(list.begin(), {"", "", label, io::ShownColumn{.heading = "*reference", .width = -14}});
    list.back().shown = io::ShownColumn{.heading = "", .width = -5};
    list.push_back(
        {"specimens", "specimens", &TradeRow::specimens, io::ShownColumn{.heading = "n", .width = 3}});
    list.push_back({"reference", "", [](const TradeRow& row) { return row.reference ? 1 : 0; }});
    list.push_back({"", "reference", &TradeRow::reference});
    const auto shown = [](std::string heading, int width, int digits, double unit) {
      return io::ShownColumn{.heading = std::move(heading),
                             .width = width,
                             .digits = digits,
                             .fixed = true,
                             .unit = unit,
                             .absent = "-",
                             .sign = true};
    };
    add_deviation(list, "G", &TradeRow::shear_modulus, shown("G bias [%]", 13, 2, 0.01), 8);
    add_deviation(list, "s", &TradeRow::exponent, shown("s bias", 16, 4, 1), 0);
    add_deviation(list, "peak", &TradeRow::peak_ratio, shown("peak [%]", 12, 2, 0.01), 0);
    const auto cost = [](double TradeRow::*of) {
      return io::or_null(
          [of](const TradeRow& row) { return row.specimens > 0 ? std::optional(row.*of) : std::nullopt; });
    };
    list.push_back({"cpu_s", "cpu_s", cost(&TradeRow::cpu_seconds),
                    io::ShownColumn{.heading = "CPU [s]", .width = 8, .digits = 2}});
    list.push_back({"steps", "steps", cost(&TradeRow::steps)});
    return list;
  }();
  return columns;
}

/// A law, and the limiting error of one specimen at the defaults of the study.
struct NamedLaw {
  const char* name;
  const studies::ErrorLaw& law;
  double inertial_number; ///< default of the study
  double grains;
};

std::vector<NamedLaw> named(const TradeScene& trade, const studies::TradeLaws& laws) {
  const double compression = trade.compression_inertial_number;
  const auto grains = static_cast<double>(trade.scene.study.grains);
  return {{"G, dense", laws.dense_modulus, compression, grains},
          {"s, dense", laws.dense_exponent, compression, grains},
          {"G, loose", laws.loose_modulus, compression, grains},
          {"s, loose", laws.loose_exponent, compression, grains},
          {"peak, dense", laws.dense_peak, trade.shear_inertial_number, grains}};
}

const io::Columns<NamedLaw>& law_columns() {
  const auto shown = [](std::string heading, int width, int digits, bool sign) {
    return io::ShownColumn{
        .heading = std::move(heading), .width = width, .digits = digits, .fixed = true, .sign = sign};
  };
  static const io::Columns<NamedLaw> columns = {
      {"", "", &NamedLaw::name, io::ShownColumn{.heading = "", .width = -12}},
      {"", "scatter_c", [](const NamedLaw& l) { return l.law.size.scatter; }, shown("c", 7, 3, false)},
      {"", "size_bias_b", [](const NamedLaw& l) { return l.law.size.bias; }},
      {"", "size_bias_error", [](const NamedLaw& l) { return l.law.size.bias_error; }},
      {"", "rate_bias_k", [](const NamedLaw& l) { return l.law.rate.bias; }},
      {"", "rate_bias_error", [](const NamedLaw& l) { return l.law.rate.bias_error; }},
      {"", "",
       [](const NamedLaw& l) {
         return Measured{l.law.size.bias, l.law.size.bias_error};
       },
       shown("b", 16, 2, true)},
      {"", "",
       [](const NamedLaw& l) {
         return Measured{l.law.rate.bias, l.law.rate.bias_error};
       },
       shown("k", 16, 2, true)},
      {"", "", [](const NamedLaw& l) { return studies::scatter_of(l.law, l.grains); },
       shown("scatter", 9, 4, false)},
      {"", "", [](const NamedLaw& l) { return studies::size_bias_of(l.law, l.grains); },
       shown("size", 9, 4, true)},
      {"", "", [](const NamedLaw& l) { return studies::rate_bias_of(l.law, l.inertial_number); },
       shown("rate", 9, 4, true)},
  };
  return columns;
}

} // namespace

std::string trade_table(const TradeScene& trade, const std::vector<TradeRow>& rows) {
  std::string out;
  for (const Varied varied : studies::all_varied) {
    std::vector<TradeRow> block;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(block),
                 [varied](const TradeRow& row) { return row.varied == varied; });
    if (!block.empty())
      out += title(trade, varied) + "\n" + io::table_text(row_columns(), block) + "\n";
  }
  if (!out.empty())
    out += "  n: specimens; bias: mean minus that of the reference (*), +- standard error;\n"
           "  scatter: standard deviation of G between specimens, or between their\n"
           "  differences from the reference, in %; s: of G ~ p^s; peak: largest q/p', its\n"
           "  bias; CPU: processor time of the cost named above each table\n\n";
  return out;
}

std::string laws_table(const TradeScene& trade, const studies::TradeLaws& laws) {
  std::string out =
      fmt::format("errors as power laws: scatter c N^(-1/2), bias b/N + k I; N: grains, I: inertial\n"
                  "number; scatter, size (b/N) and rate (k I): of one specimen of {} grains at the\n"
                  "default I; G and peak relative, s absolute\n{}\n",
                  trade.scene.study.grains, io::heading_line(law_columns()));
  for (const NamedLaw& law : named(trade, laws))
    if (law.law.size.scatter > 0)
      out += io::row_line(law_columns(), law) + "\n";
  return out + "\n";
}

std::string trade_csv(const std::vector<TradeRow>& rows) {
  return io::csv_text(
      row_columns(), rows,
      {{"program", fmt::format("granum {} trade", version())},
       {"bias", "mean minus that of the reference (reference = 1), for G and peak divided by it; error: "
                "standard error of the bias"},
       {"scatter", "standard deviation between specimens; between their differences from the reference where "
                   "both have the same packings"}});
}

std::string samples_csv(const TradeScene& trade, const std::vector<TradeSample>& samples) {
  io::Columns<TradeSample> columns = subject_columns<TradeSample>();
  const auto add = [&](const std::string& heading, auto of) { columns.emplace_back(heading, "", of); };
  add("seed", &TradeSample::seed);
  for (std::size_t k = 0; k < trade.scene.study.pressures.size(); ++k)
    add(fmt::format("G_at_{}kPa_Pa", short_text(trade.scene.study.pressures[k] / 1e3)),
        [k](const TradeSample& sample) {
          return k < sample.shear_modulus.size() ? std::optional(sample.shear_modulus[k]) : std::nullopt;
        });
  add("s", &TradeSample::exponent);
  add("peak_q_over_p", &TradeSample::peak_ratio);
  add("cpu_s", &TradeSample::cpu_seconds);
  add("steps", &TradeSample::steps);
  add("failure", &TradeSample::failure);
  return io::csv_text(columns, samples,
                      {{"program", fmt::format("granum {} trade", version())},
                       {"scene", json_text(json_of(trade), -1)},
                       {"G", "at each pressure; in rows of shear only the first column has a value, G_vh at "
                             "q/p' = 0.8"}});
}

std::string trade_picture(const std::vector<TradeRow>& rows) {
  std::vector<plot::Chart> panels;
  for (const Varied varied : studies::all_varied) {
    plot::Chart panel{.title = panel_title(varied),
                      .x = {"processor time [s]", plot::Scale::logarithmic},
                      .y = {"error of G [%]", plot::Scale::logarithmic, 0.01},
                      .width = 260,
                      .height = 220,
                      .legend_below = true};
    for (const TradeRow& row : rows)
      if (row.varied == varied && is_drawn(row))
        add_row(panel, row);
    if (!panel.series.empty())
      panels.push_back(std::move(panel));
  }
  if (panels.empty()) // axes with this title
    panels.push_back({.title = "Nothing was measured"});
  constexpr std::size_t panels_in_a_row = 3;
  return plot::svg(panels, panels_in_a_row);
}

ordered_json json_of(const TradeScene& trade) {
  ordered_json json = json_of(trade.scene);
  json["trade"] = {{"compression_inertial_number", trade.compression_inertial_number},
                   {"shear_inertial_number", trade.shear_inertial_number},
                   {"time_step_fraction", trade.time_step_fraction},
                   {"shear_strain", trade.shear_strain},
                   {"grains", trade.grains},
                   {"compression", trade.compression},
                   {"shear", trade.shear},
                   {"time_step", trade.time_step},
                   {"probe", trade.probe},
                   {"walls", trade.walls}};
  return json;
}

ordered_json json_of(const std::vector<TradeRow>& rows) { return members_of_all(row_columns(), rows); }

ordered_json json_of(const studies::TradeLaws& laws) {
  ordered_json json;
  for (const NamedLaw& law : named({}, laws))
    json[law.name] = members(law_columns(), law);
  return json;
}

} // namespace granum::cli
