// SPDX-License-Identifier: GPL-3.0-or-later
// A study of speed against accuracy as documents, and its rows read from a file again.
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>

#include "cli/frame/help.hpp"
#include "cli/options/scene_file.hpp"
#include "trade.hpp"

namespace granum::cli {

namespace {

using studies::Boundary;
using studies::Deviation;
using studies::TradeRow;
using studies::TradeSample;
using studies::TradeScene;
using studies::Varied;
using triaxial::Density;

/// A varied quantity: the titles of its panel and of its block on the screen.
struct Block {
  Varied varied;
  const char* panel;
  const char* title;
};
constexpr std::array blocks{
    Block{Varied::grains, "Grains",
          "number of grains, periodic cell; G and s by the network; cost from packing to peak"},
    Block{Varied::compression, "Rate of compression",
          "inertial number of compression; cost of compression through all pressures"},
    Block{Varied::shear, "Rate of shear",
          "inertial number of triaxial compression; G_vh at q/p' = 0.8; cost of the test to an axial strain "
          "of {}"},
    Block{Varied::time_step, "Time step",
          "time step over its stability limit; cost of compression, and of shear where there is a peak"},
    Block{Varied::probe, "Probe strain",
          "strain of the cyclic probe divided by (mean overlap/diameter), 0: the network; G_vh; cost of one "
          "modulus"},
    Block{Varied::boundary, "Walls",
          "boundary and number of grains: periodic cell, smooth or rough walls; mean of G_hh and G_vh by "
          "the probe; cost of the specimen"}};

/// A measured quantity of a row: its name, and how its bias and scatter look.
struct Figure {
  const char* name;
  std::optional<Deviation> TradeRow::*of;
  const char* shown;
  int width, digits;
  double unit;
  int scatter_width;
};
constexpr std::array figures{Figure{"G", &TradeRow::shear_modulus, "G bias [%]", 13, 2, 0.01, 8},
                             Figure{"s", &TradeRow::exponent, "s bias", 16, 4, 1, 0},
                             Figure{"peak", &TradeRow::peak_ratio, "peak [%]", 12, 2, 0.01, 0}};

// ---- rows

/// Label of a row, with a star if the others are compared with it.
std::string label(const TradeRow& row) {
  const std::string value = short_text(row.value) + (row.reference ? "*" : "");
  if (row.varied != Varied::boundary)
    return value;
  const std::string boundary(studies::name(row.boundary));
  return boundary.substr(0, boundary.find('-')) + " " + value;
}

/// The first columns of rows and samples.
template <class Row>
io::Columns<Row> subject_columns() {
  return {{"varied", "varied", [](const Row& row) { return studies::name(row.varied); }},
          {"boundary", "boundary", [](const Row& row) { return studies::name(row.boundary); }},
          {"value", "value", &Row::value},
          {"density", "density", [](const Row& row) { return studies::name(row.density); }}};
}

io::ShownColumn number_look(std::string heading, int width, int digits, bool sign, double unit = 1) {
  return {.heading = std::move(heading),
          .width = width,
          .digits = digits,
          .fixed = true,
          .unit = unit,
          .absent = "-",
          .sign = sign};
}

/// Adds the parts of a deviation, and the look of its mean.
void add_figure(io::Columns<TradeRow>& to, const Figure& figure) {
  const std::string name = figure.name;
  const auto of = figure.of;
  to.emplace_back("", name, [of](const TradeRow& row) { return row.*of ? io::Value() : io::Value(nullptr); });
  to.emplace_back(
      "", "",
      [of](const TradeRow& row) {
        return row.*of ? std::optional(Measured{(row.*of)->bias, (row.*of)->standard_error}) : std::nullopt;
      },
      number_look(figure.shown, figure.width, figure.digits, true, figure.unit));
  for (const auto& [heading, key, part] : {std::tuple{"_bias", "/bias", &Deviation::bias},
                                           {"_error", "/standard_error", &Deviation::standard_error},
                                           {"_scatter", "/scatter", &Deviation::scatter}})
    to.emplace_back(name + heading, name + key, [of, part = part](const TradeRow& row) {
      return row.*of ? std::optional((*(row.*of)).*part) : std::nullopt;
    });
  to.back().shown = number_look("scatter", figure.scatter_width, figure.digits, false, figure.unit);
}

io::Columns<TradeRow> row_columns() {
  io::Columns<TradeRow> columns = subject_columns<TradeRow>();
  columns.insert(columns.begin(), {"", "", label, io::ShownColumn{.heading = "*reference", .width = -14}});
  columns.back().shown = io::ShownColumn{.heading = "", .width = -5};
  columns.push_back(
      {"specimens", "specimens", &TradeRow::specimens, io::ShownColumn{.heading = "n", .width = 3}});
  columns.push_back({"reference", "", [](const TradeRow& row) { return row.reference ? 1 : 0; }});
  columns.push_back({"", "reference", &TradeRow::reference});
  for (const Figure& figure : figures)
    add_figure(columns, figure);
  const auto cost = [](double TradeRow::*of) {
    return io::or_null(
        [of](const TradeRow& row) { return row.specimens > 0 ? std::optional(row.*of) : std::nullopt; });
  };
  columns.push_back({"cpu_s", "cpu_s", cost(&TradeRow::cpu_seconds),
                     io::ShownColumn{.heading = "CPU [s]", .width = 8, .digits = 2}});
  columns.push_back({"steps", "steps", cost(&TradeRow::steps)});
  return columns;
}

std::vector<TradeRow> rows_of(Varied varied, const std::vector<TradeRow>& rows) {
  std::vector<TradeRow> block;
  std::ranges::copy_if(rows, std::back_inserter(block),
                       [varied](const TradeRow& row) { return row.varied == varied; });
  return block;
}

// ---- picture

/// Quantities with an error due to the varied setting, relative to the reference.
bool is_drawn(const TradeRow& row) {
  const bool other_boundary = row.varied == Varied::boundary && row.boundary == Boundary::periodic;
  const bool is_reference = row.reference && row.varied != Varied::grains;
  return row.shear_modulus && row.boundary != Boundary::smooth_walls && !other_boundary && !is_reference;
}

/// Adds the error of a row over its cost to the series of its density.
void add_row(plot::Chart& panel, const TradeRow& row) {
  const std::string name(studies::name(row.density));
  auto series = std::ranges::find(panel.series, name, &plot::Series::name);
  if (series == panel.series.end()) {
    const bool dense = row.density == Density::dense;
    series = panel.series.insert(series, plot::Series{.name = name,
                                                      .style = dense ? 0 : 1,
                                                      .tone = dense ? plot::Tone::full : plot::Tone::hollow,
                                                      .colour = plot::Colour::measured});
  }
  series->add(row.cpu_seconds, error_of(row), row.shear_modulus->standard_error);
}

Picture picture_of(const std::vector<TradeRow>& rows) {
  Picture out{.charts = {}, .in_a_row = 3};
  for (const Block& block : blocks) {
    plot::Chart panel{.title = block.panel,
                      .x = {"processor time [s]", plot::Scale::logarithmic},
                      .y = {"error of G [%]", plot::Scale::logarithmic, 0.01},
                      .width = 260,
                      .height = 220,
                      .legend_below = true};
    for (const TradeRow& row : rows_of(block.varied, rows))
      if (is_drawn(row))
        add_row(panel, row);
    if (!panel.series.empty())
      out.charts.push_back(std::move(panel));
  }
  if (out.charts.empty()) // axes with this title
    out.charts.push_back({.title = "Nothing was measured"});
  return out;
}

// ---- laws

/// A law, and the limiting error of one specimen at the defaults of the study.
struct NamedLaw {
  const char* name;
  studies::ErrorLaw law;
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

io::Columns<NamedLaw> law_columns() {
  using Of = const NamedLaw&;
  return {
      {"", "", &NamedLaw::name, io::ShownColumn{.heading = "", .width = -12}},
      {"", "scatter_c", [](Of l) { return l.law.size.scatter; }, number_look("c", 7, 3, false)},
      {"", "size_bias_b", [](Of l) { return l.law.size.bias; }},
      {"", "size_bias_error", [](Of l) { return l.law.size.bias_error; }},
      {"", "rate_bias_k", [](Of l) { return l.law.rate.bias; }},
      {"", "rate_bias_error", [](Of l) { return l.law.rate.bias_error; }},
      {"", "",
       [](Of l) {
         return Measured{l.law.size.bias, l.law.size.bias_error};
       },
       number_look("b", 16, 2, true)},
      {"", "",
       [](Of l) {
         return Measured{l.law.rate.bias, l.law.rate.bias_error};
       },
       number_look("k", 16, 2, true)},
      {"", "", [](Of l) { return studies::scatter_of(l.law, l.grains); },
       number_look("scatter", 9, 4, false)},
      {"", "", [](Of l) { return studies::size_bias_of(l.law, l.grains); }, number_look("size", 9, 4, true)},
      {"", "", [](Of l) { return studies::rate_bias_of(l.law, l.inertial_number); },
       number_look("rate", 9, 4, true)}};
}

/// All laws in JSON, and on the screen those that rows determine.
void add_laws(Document& to, const TradeOutcome& outcome) {
  std::vector<NamedLaw> laws = named(outcome.trade, studies::laws_of(outcome.rows));
  to.add(Seen::data, table_of("laws", "", law_columns(), laws, Table::Form::named));
  std::erase_if(laws, [](const NamedLaw& law) { return !(law.law.size.scatter > 0); });
  if (laws.empty())
    return;
  to.add(
      Seen::always,
      table_of("",
               fmt::format("errors as power laws: scatter c N^(-1/2), bias b/N + k I; N: grains, I: inertial "
                           "number; scatter, size (b/N) and rate (k I): of one specimen of {} grains at the "
                           "default I; G and peak relative, s absolute",
                           outcome.trade.scene.study.grains),
               law_columns(), laws));
}

nlohmann::ordered_json scene_json(const TradeScene& trade) {
  nlohmann::ordered_json json = json_of(trade.scene);
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

} // namespace

Document rows_document(const std::vector<TradeRow>& rows) {
  Document out{.command = "trade", .signs = ""};
  out.add(Seen::data, table_of("rows", "", row_columns(), rows));
  out.add(Seen::data, picture_of(rows));
  out.comments = {
      {"bias", "mean minus that of the reference (reference = 1), for G and peak divided by it; error: "
               "standard error of the bias"},
      {"scatter", "standard deviation between specimens; between their differences from the reference where "
                  "both have the same packings"}};
  return out;
}

Document samples_document(const TradeOutcome& outcome) {
  io::Columns<TradeSample> columns = subject_columns<TradeSample>();
  columns.emplace_back("seed", "", &TradeSample::seed);
  const std::vector<double>& pressures = outcome.trade.scene.study.pressures;
  for (std::size_t k = 0; k < pressures.size(); ++k)
    columns.emplace_back(
        fmt::format("G_at_{}kPa_Pa", short_text(pressures[k] / 1e3)), "", [k](const TradeSample& sample) {
          return k < sample.shear_modulus.size() ? std::optional(sample.shear_modulus[k]) : std::nullopt;
        });
  columns.emplace_back("s", "", &TradeSample::exponent);
  columns.emplace_back("peak_q_over_p", "", &TradeSample::peak_ratio);
  columns.emplace_back("cpu_s", "", &TradeSample::cpu_seconds);
  columns.emplace_back("steps", "", &TradeSample::steps);
  columns.emplace_back("failure", "", &TradeSample::failure);
  Document out{.command = "trade", .signs = ""};
  out.add(Seen::data, Data{"scene", scene_json(outcome.trade)});
  out.add(Seen::data, table_of("", "", columns, outcome.samples));
  out.comments = {{"G", "at each pressure; in rows of shear only the first column has a value, G_vh at "
                        "q/p' = 0.8"}};
  return out;
}

namespace {

bool any_measured(const std::vector<TradeRow>& rows) {
  return std::ranges::any_of(rows, [](const TradeRow& row) { return row.specimens > 0; });
}

/// Question, answer and picture of the page: the cheapest numbers of grains whose error is small.
void add_answer(Document& to, const TradeOutcome& outcome) {
  to.question = "How much accuracy does computing time buy on this machine?";
  if (!any_measured(outcome.rows)) {
    to.sentences.push_back("No specimen was finished before the run was stopped.");
    to.add(Seen::always, Prose{{"no specimen was finished"}});
    return;
  }
  constexpr double limit = 0.02;
  for (const Density density : {Density::dense, Density::loose}) {
    const TradeRow* best = nullptr;
    for (const TradeRow& row : outcome.rows)
      if (row.varied == Varied::grains && row.density == density && is_drawn(row) && error_of(row) <= limit &&
          (best == nullptr || row.cpu_seconds < best->cpu_seconds))
        best = &row;
    const std::string kind(studies::name(density));
    to.sentences.push_back(
        best != nullptr
            ? fmt::format("G of a {} packing within {} %: {} grains, {:.2g} s of one processor.", kind,
                          short_text(100 * limit), short_text(best->value), best->cpu_seconds)
            : fmt::format("No number of grains of this run had G of a {} packing within {} %.", kind,
                          short_text(100 * limit)));
  }
  Picture picture = picture_of(outcome.rows);
  picture.caption = "Error of G of one specimen over the processor time that it costs, each with one setting "
                    "varied. Dots further left cost less; lower ones are more accurate.";
  to.add(Seen::full, std::move(picture));
}

} // namespace

Document trade_document(const TradeOutcome& outcome, const StudyOptions& options) {
  const std::size_t threads = studies::thread_count(outcome.trade.scene);
  Document out{.command = "trade"};
  out.title = fmt::format("Speed against accuracy: {} samples in {:.1f} s on {}", outcome.samples.size(),
                          outcome.seconds, threads_text(threads));
  Items run;
  io::add_item(run.items, "wall_time_s", outcome.seconds);
  io::add_item(run.items, "complete", outcome.failures.empty());
  io::add_item(run.items, "failure", outcome.failures);
  io::add_item(run.items, "scene_file", options.scene_file);
  out.add(Seen::data, std::move(run));
  out.add(Seen::data, Data{"settings", options.settings});
  out.add(Seen::data, Data{"scene", scene_json(outcome.trade)});
  out.add(Seen::data, Data{"threads_used", threads});
  out.add(Seen::data, table_of("rows", "", row_columns(), outcome.rows));
  add_answer(out, outcome);
  // After a stop some rows have no specimens: they are left out, and tables without rows.
  for (const Block& block : blocks) {
    std::vector<TradeRow> rows = rows_of(block.varied, outcome.rows);
    std::erase_if(rows, [](const TradeRow& row) { return row.specimens == 0; });
    if (!rows.empty())
      out.add(Seen::always,
              table_of("", fmt::format(fmt::runtime(block.title), percent_text(outcome.trade.shear_strain)),
                       row_columns(), rows));
  }
  if (any_measured(outcome.rows))
    out.add(Seen::always,
            Prose{{"n: specimens; bias: mean minus that of the reference (*), +- standard error;",
                   "scatter: standard deviation of G between specimens, or between their",
                   "differences from the reference, in %; s: of G ~ p^s; peak: largest q/p', its",
                   "bias; CPU: processor time of the cost named above each table"}});
  add_laws(out, outcome);
  return out;
}

// ---- rows of a file

namespace {

/// A row of a table that trade wrote.
struct RowReader {
  const io::CsvTable& table;
  std::size_t row;

  [[nodiscard]] const std::string& text(const std::string& heading) const {
    const auto found = std::ranges::find(table.headings(), heading);
    if (found == table.headings().end())
      throw FileError(table.name(), table.heading_line(), "has no column " + heading);
    return table.fields(row)[static_cast<std::size_t>(found - table.headings().begin())];
  }
  [[nodiscard]] FileError refused(const std::string& heading) const {
    return {table.name(), table.line(row),
            "column " + heading + " contains '" + text(heading) + "', which is not written by trade"};
  }
  [[nodiscard]] std::optional<double> number_or_nothing(const std::string& heading) const {
    const std::optional<double> number = parse_number(text(heading));
    if (!number && !text(heading).empty())
      throw refused(heading);
    return number;
  }
  [[nodiscard]] double number(const std::string& heading) const {
    if (const std::optional<double> given = number_or_nothing(heading))
      return *given;
    throw refused(heading);
  }
  template <class Names>
  [[nodiscard]] auto named(const std::string& heading, const Names& all) const {
    const auto found =
        std::ranges::find_if(all, [&](auto value) { return studies::name(value) == text(heading); });
    if (found == std::end(all))
      throw refused(heading);
    return *found;
  }
};

TradeRow row_of(const RowReader& from) {
  TradeRow row{.varied = from.named("varied", studies::all_varied),
               .boundary = from.named(
                   "boundary", std::array{Boundary::periodic, Boundary::smooth_walls, Boundary::rough_walls}),
               .value = from.number("value"),
               .density = from.named("density", std::array{Density::dense, Density::loose}),
               .specimens = static_cast<std::size_t>(from.number("specimens")),
               .reference = from.number("reference") != 0,
               .shear_modulus = {},
               .exponent = {},
               .peak_ratio = {},
               .cpu_seconds = from.number_or_nothing("cpu_s").value_or(0),
               .steps = from.number_or_nothing("steps").value_or(0)};
  for (const Figure& figure : figures) {
    const std::string name = figure.name;
    if (const std::optional<double> bias = from.number_or_nothing(name + "_bias"))
      row.*figure.of = Deviation{*bias, from.number(name + "_error"), from.number(name + "_scatter")};
  }
  return row;
}

} // namespace

std::vector<TradeRow> read_trade_rows(const std::filesystem::path& csv) {
  const io::CsvTable table = io::read_csv(csv);
  std::vector<TradeRow> rows;
  for (std::size_t k = 0; k < table.row_count(); ++k)
    rows.push_back(row_of({table, k}));
  return rows;
}

} // namespace granum::cli
