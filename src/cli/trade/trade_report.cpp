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
#include "cli/options/scene_file.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using studies::Boundary;
using studies::TradeRow;
using studies::TradeSample;
using studies::TradeScene;
using studies::Varied;

/// What a block of the table is about.
std::string title(const TradeScene& trade, Varied varied) {
  switch (varied) {
  case Varied::grains:
    return "grains N, periodic cell; G and s by the network, cost from packing to peak";
  case Varied::compression:
    return "inertial number of compression; cost of compression through all pressures";
  case Varied::shear:
    return "inertial number of triaxial compression; G_vh at q/p' = 0.8; cost of the test to " +
           percent_text(trade.shear_strain) + " strain";
  case Varied::time_step:
    return "time step over its stability limit; cost of compression, and of shear where there is a peak";
  case Varied::probe:
    return "strain of the cyclic probe in mean overlaps over the diameter, 0 the network; G_vh; cost of one "
           "answer";
  case Varied::boundary:
    return "N grains between walls, probed, and in the periodic cell; mean of G_hh and G_vh; cost of the "
           "specimen";
  }
  return {};
}

std::string in_percent(const std::optional<studies::Deviation>& d) {
  return d ? fmt::format("{:+7.2f} +- {:<5.2f}{:6.2f}", 100 * d->bias, 100 * d->standard_error,
                         100 * d->scatter)
           : fmt::format("{:>23}", "-");
}

std::string plain(const std::optional<studies::Deviation>& d) {
  return d ? fmt::format("{:+7.4f} +- {:<6.4f}{:7.4f}", d->bias, d->standard_error, d->scatter)
           : fmt::format("{:>24}", "-");
}

bool has_boundary(Varied varied) { return varied == Varied::boundary; }

std::string label(const TradeRow& row) {
  const std::string value = short_text(row.value);
  return has_boundary(row.varied) ? fmt::format("{} {}", studies::name(row.boundary), value) : value;
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

/// Root mean square error of one specimen: bias and scatter; of settings that leave the packing as it is,
/// the bias alone.
double error_of(const TradeRow& row) {
  const studies::Deviation& d = *row.shear_modulus;
  return row.varied == Varied::grains || row.varied == Varied::boundary ? std::hypot(d.bias, d.scatter)
                                                                        : std::abs(d.bias);
}

/// What has an error that its setting makes, beside those of the reference.
bool is_drawn(const TradeRow& row) {
  const bool other_boundary = row.varied == Varied::boundary && row.boundary == Boundary::periodic;
  const bool is_reference = row.reference && row.varied != Varied::grains;
  return row.shear_modulus && row.boundary != Boundary::smooth_walls && !other_boundary && !is_reference;
}

/// Adds its error over its cost to the series of its density.
void add_row(plot::Chart& panel, const TradeRow& row) {
  const std::string name(studies::name(row.density));
  auto series = std::find_if(panel.series.begin(), panel.series.end(),
                             [&](const plot::Series& s) { return s.name == name; });
  if (series == panel.series.end()) {
    const bool dense = row.density == triaxial::Density::dense;
    series = panel.series.insert(series, plot::Series{.name = name,
                                                      .x = {},
                                                      .y = {},
                                                      .style = dense ? 0 : 1,
                                                      .tone = dense ? plot::Tone::full : plot::Tone::hollow,
                                                      .colour = plot::Colour::measured});
  }
  series->x.push_back(row.cpu_seconds);
  series->y.push_back(error_of(row));
  series->y_error.push_back(row.shear_modulus->standard_error);
}

ordered_json json_of(const std::optional<studies::Deviation>& d) {
  if (!d)
    return nullptr;
  return {{"bias", d->bias}, {"standard_error", d->standard_error}, {"scatter", d->scatter}};
}

std::string text(std::string_view view) { return std::string(view); }

/// The columns that rows and samples begin with.
template <class Row>
io::Columns<Row> subject_columns() {
  return {{"varied", [](const Row& row) { return text(studies::name(row.varied)); }},
          {"boundary", [](const Row& row) { return text(studies::name(row.boundary)); }},
          {"value", "", [](const Row& row) { return row.value; }},
          {"density", [](const Row& row) { return text(studies::name(row.density)); }}};
}

struct NamedLaw {
  const char* name;
  const studies::ErrorLaw& law;
  double inertial_number; ///< that the study has as a default
};

std::vector<NamedLaw> named(const TradeScene& trade, const studies::TradeLaws& laws) {
  const double compression = trade.compression_inertial_number;
  return {{"G, dense", laws.dense_modulus, compression},
          {"s, dense", laws.dense_exponent, compression},
          {"G, loose", laws.loose_modulus, compression},
          {"s, loose", laws.loose_exponent, compression},
          {"peak, dense", laws.dense_peak, trade.shear_inertial_number}};
}

} // namespace

std::string trade_table(const TradeScene& trade, const std::vector<TradeRow>& rows) {
  std::string out;
  for (const Varied varied : studies::all_varied) {
    std::vector<TradeRow> block;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(block),
                 [varied](const TradeRow& row) { return row.varied == varied; });
    if (block.empty())
      continue;
    out += fmt::format("{}\n{:<18} {:>6} {:>3}   {:<23} {:<25} {:<23} {:>8} {:>8}\n", title(trade, varied),
                       "", "", "n", "G: bias, scatter [%]", "s: bias, scatter [1]", "peak: bias, scatter [%]",
                       "CPU [s]", "steps");
    for (const TradeRow& row : block)
      out += fmt::format("{:>18} {:>6} {:>3}   {} {} {} {:8.3g} {:8.0f}{}\n", label(row),
                         studies::name(row.density), row.specimens, in_percent(row.shear_modulus),
                         plain(row.exponent), in_percent(row.peak_ratio), row.cpu_seconds, row.steps,
                         row.reference ? "  reference" : "");
    out += "\n";
  }
  return out;
}

std::string laws_table(const TradeScene& trade, const studies::TradeLaws& laws) {
  std::string out =
      fmt::format("errors as power laws: scatter c N^(-1/2), bias b/N + k I; one specimen of {} "
                  "grains at the default I\n{:<12} {:>7} {:>18} {:>18} {:>9} {:>9} {:>9}\n",
                  trade.scene.study.grains, "", "c", "b", "k", "scatter", "size", "rate");
  for (const NamedLaw& l : named(trade, laws)) {
    const studies::SizeLaw& size = l.law.size;
    const studies::RateLaw& rate = l.law.rate;
    if (!(size.scatter > 0))
      continue;
    const double grains = static_cast<double>(trade.scene.study.grains);
    out += fmt::format("{:<12} {:7.3f} {:+8.2f} +- {:<6.2f} {:+8.2f} +- {:<6.2f} {:9.4f} {:+9.4f} {:+9.4f}\n",
                       l.name, size.scatter, size.bias, size.bias_error, rate.bias, rate.bias_error,
                       size.scatter / std::sqrt(grains), size.bias / grains, rate.bias * l.inertial_number);
  }
  return out + "\n";
}

std::string trade_csv(const std::vector<TradeRow>& rows) {
  using studies::Deviation;
  io::Columns<TradeRow> columns = subject_columns<TradeRow>();
  const auto add = [&](const std::string& heading, auto of) { columns.emplace_back(heading, "", of); };
  add("specimens", [](const TradeRow& row) { return static_cast<double>(row.specimens); });
  add("reference", [](const TradeRow& row) { return row.reference ? 1.0 : 0.0; });
  for (const auto& [quantity, deviation] : {std::pair{"G", &TradeRow::shear_modulus},
                                            {"s", &TradeRow::exponent},
                                            {"peak", &TradeRow::peak_ratio}})
    for (const auto& [part, of] : {std::pair{"_bias", &Deviation::bias},
                                   {"_error", &Deviation::standard_error},
                                   {"_scatter", &Deviation::scatter}})
      add(std::string(quantity) + part, [deviation = deviation, of = of](const TradeRow& row) {
        return row.*deviation ? std::optional((*(row.*deviation)).*of) : std::nullopt;
      });
  for (const auto& [heading, of] : {std::pair{"cpu_s", &TradeRow::cpu_seconds}, {"steps", &TradeRow::steps}})
    add(heading,
        [of = of](const TradeRow& row) { return row.specimens > 0 ? std::optional(row.*of) : std::nullopt; });
  return io::csv_text(
      columns, rows,
      {{"program", "granum " + text(version()) + " trade"},
       {"bias", "of the mean against the reference, in parts of it for G and peak"},
       {"scatter", "standard deviation of one specimen; of differences where packings are the same"}});
}

std::string samples_csv(const TradeScene& trade, const std::vector<TradeSample>& samples) {
  io::Columns<TradeSample> columns = subject_columns<TradeSample>();
  const auto add = [&](const std::string& heading, auto of) { columns.emplace_back(heading, "", of); };
  add("seed", [](const TradeSample& sample) { return static_cast<double>(sample.seed); });
  for (std::size_t k = 0; k < trade.scene.study.pressures.size(); ++k)
    add(fmt::format("G_at_{}kPa_Pa", short_text(trade.scene.study.pressures[k] / 1e3)),
        [k](const TradeSample& sample) {
          return k < sample.shear_modulus.size() ? std::optional(sample.shear_modulus[k]) : std::nullopt;
        });
  add("s", [](const TradeSample& sample) { return sample.exponent; });
  add("peak_q_over_p", [](const TradeSample& sample) { return sample.peak_ratio; });
  add("cpu_s", [](const TradeSample& sample) { return sample.cpu_seconds; });
  add("steps", [](const TradeSample& sample) { return static_cast<double>(sample.steps); });
  columns.emplace_back("failure", [](const TradeSample& sample) { return sample.failure; });
  return io::csv_text(columns, samples,
                      {{"program", "granum " + text(version()) + " trade"},
                       {"scene", json_text(json_of(trade), -1)},
                       {"G", "at each pressure; shear: one, G_vh at q/p' = 0.8, in the first column"}});
}

std::string trade_picture(const std::vector<TradeRow>& rows) {
  std::vector<plot::Chart> panels;
  for (const Varied varied : studies::all_varied) {
    plot::Chart panel{.title = panel_title(varied),
                      .x = {"processor time [s]", plot::Scale::logarithmic},
                      .y = {"error of G [%]", plot::Scale::logarithmic, 0.01},
                      .series = {},
                      .width = 260,
                      .height = 220,
                      .legend_below = true};
    for (const TradeRow& row : rows)
      if (row.varied == varied && is_drawn(row))
        add_row(panel, row);
    if (!panel.series.empty())
      panels.push_back(std::move(panel));
  }
  if (panels.empty()) // axes, and a title that says so
    panels.push_back({.title = "Nothing was measured", .x = {}, .y = {}, .series = {}});
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

ordered_json json_of(const std::vector<TradeRow>& rows) {
  ordered_json json = ordered_json::array();
  for (const TradeRow& row : rows)
    json.push_back({{"varied", studies::name(row.varied)},
                    {"boundary", studies::name(row.boundary)},
                    {"value", row.value},
                    {"density", studies::name(row.density)},
                    {"specimens", row.specimens},
                    {"reference", row.reference},
                    {"G", json_of(row.shear_modulus)},
                    {"s", json_of(row.exponent)},
                    {"peak", json_of(row.peak_ratio)},
                    {"cpu_s", row.cpu_seconds},
                    {"steps", row.steps}});
  return json;
}

ordered_json json_of(const studies::TradeLaws& laws) {
  ordered_json json;
  for (const NamedLaw& l : named({}, laws))
    json[l.name] = {{"scatter_c", l.law.size.scatter},
                    {"size_bias_b", l.law.size.bias},
                    {"size_bias_error", l.law.size.bias_error},
                    {"rate_bias_k", l.law.rate.bias},
                    {"rate_bias_error", l.law.rate.bias_error}};
  return json;
}

} // namespace granum::cli
