// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <granum/core/error.hpp>

#include "answer_rows.hpp"
#include "sweep.hpp"

namespace granum::cli {

namespace {

using estimate::Field;
using io::CsvTable;
using nlohmann::ordered_json;

/// A point of the picture.
struct RowPoint {
  double mean_stress, void_ratio;
  estimate::Range shear_modulus;
};

/// Answers the rows of a table, one after the other: a table may have millions.
class TableSweep {
 public:
  TableSweep(const SweepOptions& options, const Rungs& rungs)
      : options_(options), rungs_(rungs), table_(io::read_csv(options.table)),
        reader_(table_, options.packing, options.answer),
        output_(options, rungs, table_.headings(), table_.manner()) {
    for (const std::string& heading : output_.result_headings())
      if (std::find(table_.headings().begin(), table_.headings().end(), heading) != table_.headings().end())
        throw FileError(options.table, 0, "has a column '" + heading + "' already, a name of the results");
    for (std::size_t row = 0; row < table_.row_count(); ++row)
      add(row);
  }

  [[nodiscard]] std::string csv() const {
    return output_.csv({{"inputs", json_text(inputs(), -1)}}, remarks());
  }
  [[nodiscard]] ordered_json json() const { return output_.json({{"inputs", inputs()}}, remarks()); }
  [[nodiscard]] const Tally& tally() const { return tally_; }
  [[nodiscard]] const std::vector<RowPoint>& points() const { return points_; }

 private:
  SweptState state_of(std::size_t row) {
    try {
      const AnswerRow question = reader_.row(row);
      if (!assumptions_)
        assumptions_ = solve_answer(question.packing, question.answer, {}).assumptions;
      return swept(question.packing, question.answer, rungs_);
    } catch (const Error& error) {
      return failed(error.what(), rungs_);
    }
  }

  void add(std::size_t row) {
    const SweptState state = state_of(row);
    tally_.count(state, fmt::format("line {}", table_.line(row)));
    if (state.answer && !options_.picture.empty()) {
      const effective::State& packing = state.answer->answer.state();
      points_.push_back({.mean_stress = packing.mean_stress(),
                         .void_ratio = packing.void_ratio,
                         .shear_modulus = state.answer->answer[Field::shear_modulus]});
    }
    const std::vector<std::string>& fields = table_.fields(row);
    output_.add({fields.begin(), fields.end()}, {{"line", table_.line(row)}}, state);
  }

  [[nodiscard]] ordered_json inputs() const {
    return {{"table", options_.table}, {"rows", table_.row_count()}};
  }

  [[nodiscard]] std::vector<std::string> remarks() const {
    std::vector<std::string> remarks = assumptions_.value_or(std::vector<std::string>());
    const std::vector<std::string> unread = reader_.unread();
    if (!unread.empty())
      remarks.push_back(fmt::format("columns that are no inputs: {}", fmt::join(unread, ", ")));
    return remarks;
  }

  const SweepOptions& options_;
  const Rungs& rungs_;
  CsvTable table_;
  AnswerRows reader_;
  SweepOutput output_;
  std::optional<std::vector<std::string>> assumptions_; ///< of the first row that is a packing
  std::vector<RowPoint> points_;
  Tally tally_;
};

/// G with its range over the mean stress, or over the void ratio where all rows have one stress.
plot::Chart chart_of(const std::vector<RowPoint>& points) {
  const bool one_stress = std::all_of(points.begin(), points.end(), [&](const RowPoint& point) {
    return point.mean_stress == points.front().mean_stress;
  });
  const bool logarithmic =
      !one_stress && std::all_of(points.begin(), points.end(), [](const RowPoint& point) {
        return point.mean_stress > 0 && point.shear_modulus.low > 0;
      });
  const plot::Scale scale = logarithmic ? plot::Scale::logarithmic : plot::Scale::linear;
  plot::Chart chart{.title = "shear modulus",
                    .x = {.title = "p' [kPa]", .scale = scale, .unit = 1e3},
                    .y = {.title = "G [MPa]", .scale = scale, .unit = 1e6},
                    .series = {}};
  if (one_stress)
    chart.x = {.title = "void ratio"};
  plot::Series ranges{.name = "range",
                      .mark = plot::Mark::line,
                      .x = {},
                      .y = {},
                      .style = 0,
                      .tone = plot::Tone::faint,
                      .colour = plot::Colour::closed_form};
  plot::Series answers{.name = "answer",
                       .mark = plot::Mark::marker,
                       .x = {},
                       .y = {},
                       .style = 0,
                       .colour = plot::Colour::closed_form};
  for (const RowPoint& point : points) {
    const double x = one_stress ? point.void_ratio : point.mean_stress;
    answers.x.push_back(x);
    answers.y.push_back(point.shear_modulus.value);
    for (const double end : {point.shear_modulus.low, point.shear_modulus.high, nothing}) {
      ranges.x.push_back(x);
      ranges.y.push_back(end); // a gap after each range
    }
  }
  chart.series = {std::move(ranges), std::move(answers)};
  return chart;
}

} // namespace

ExitCode sweep_table(const SweepOptions& o, const Rungs& rungs) {
  require_free(o.output, o.picture);
  const TableSweep sweep(o, rungs);
  return sweep.tally().conclude(
      deliver_sweep(o, "", sweep.csv(), sweep.json(), sweep.tally().validity(), {chart_of(sweep.points())}));
}

} // namespace granum::cli
