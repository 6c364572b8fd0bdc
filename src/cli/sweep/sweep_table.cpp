// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>
#include <granum/plot/chart.hpp>

#include "answer_columns.hpp"
#include "answer_rows.hpp"
#include "cli/estimate/answer_report.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "sweep.hpp"

namespace granum::cli {

namespace {

using effective::PackingAnswer;
using io::CsvTable;
using nlohmann::ordered_json;

/// What is said of a row.
struct RowResult {
  std::optional<AnswerCase> answer;
  StateResult rungs; ///< with the notes and the error of the answer
};

/// A point of the picture.
struct RowPoint {
  double mean_stress, void_ratio;
  effective::Range shear_modulus;
};

/// Collects the rows of the answer as CSV or JSON.
class TableSweep {
 public:
  TableSweep(const SweepOptions& options, const Rungs& rungs)
      : options_(options), rungs_(rungs), table_(io::read_csv(options.table)),
        reader_(table_, options.packing, options.answer) {
    for (const std::string& heading : headings_of_results())
      if (std::find(table_.headings().begin(), table_.headings().end(), heading) != table_.headings().end())
        throw FileError(options.table, 0, "has a column '" + heading + "' already, a name of the results");
    for (std::size_t row = 0; row < table_.row_count(); ++row)
      add(row);
  }

  [[nodiscard]] std::string csv() const {
    std::vector<std::string> headings = table_.headings();
    for (const std::string& heading : headings_of_results())
      headings.push_back(heading);
    return io::csv_text({.notes = csv_notes(inputs(), rungs_, remarks()), .headings = headings, .rows = {}}) +
           rows_;
  }

  [[nodiscard]] ordered_json json() const {
    ordered_json json = sweep_json_head(inputs(), rungs_);
    json["states"] = states_;
    json["notes"] = remarks();
    for (const std::string& note : tally_.validity().notes)
      json["notes"].push_back(note);
    return json;
  }

  [[nodiscard]] const Tally& tally() const { return tally_; }
  [[nodiscard]] const std::vector<RowPoint>& points() const { return points_; }

 private:
  [[nodiscard]] std::vector<std::string> headings_of_results() const {
    std::vector<std::string> headings = answer_headings(options_.all_columns);
    for (const std::string& heading : result_headings(rungs_))
      headings.push_back(heading);
    return headings;
  }

  RowResult result_of(std::size_t row) {
    try {
      AnswerRow question = reader_.row(row);
      if (!remarks_)
        remarks_ = solve_answer(question.packing, question.answer, {}).assumptions;
      RowResult result{.answer = bare_answer(question.packing, question.answer), .rungs = {}};
      result.rungs = rungs_at(question.packing, result.answer->answer);
      result.rungs.slips = slips_in(question, result.answer->question.state);
      return result;
    } catch (const Error& error) {
      return {.answer = std::nullopt, .rungs = failed(error.what(), rungs_)};
    }
  }

  static std::vector<std::string> slips_in(const AnswerRow& row, const effective::State& state) {
    Validity slips = likely_mistakes(row.packing, state);
    slips.merge(likely_mistakes(row.answer.grain_density));
    return slips.notes;
  }

  /// The rungs take the contacts of the answer where the row does not give them.
  [[nodiscard]] StateResult rungs_at(PackingOptions& packing, const PackingAnswer& answer) const {
    StateResult result;
    if (!packing.coordination_number.given())
      packing.coordination_number.value = answer.coordination_number.value;
    if (!rungs_.empty())
      result = evaluate({resolve_state(packing, resolve_stresses(packing)),
                         resolve_mechanical_coordination_number(packing)},
                        rungs_, !options_.rungs.empty());
    for (const std::string& note : answer.validity.notes)
      if (std::find(result.notes.begin(), result.notes.end(), note) == result.notes.end())
        result.notes.push_back(note);
    return result;
  }

  void add(std::size_t row) {
    const RowResult result = result_of(row);
    tally_.count(result.rungs, fmt::format("line {}", table_.line(row)));
    if (result.answer && !options_.picture.empty()) {
      const effective::State& state = result.answer->question.state;
      points_.push_back({.mean_stress = (state.stress_v + 2 * state.stress_h) / 3,
                         .void_ratio = state.void_ratio,
                         .shear_modulus = result.answer->answer.shear_modulus});
    }
    if (options_.output.json)
      add_json(row, result);
    else
      add_csv(row, result);
  }

  void add_json(std::size_t row, const RowResult& result) {
    ordered_json state = {{"line", table_.line(row)}, {"answer", ordered_json()}};
    if (result.answer) {
      state["answer"] = answer_json(*result.answer);
      state["answer"].erase("notes");
    }
    add_result(state, result.rungs, rungs_);
    states_.push_back(std::move(state));
  }

  void add_csv(std::size_t row, const RowResult& result) {
    std::vector<io::CsvCell> cells(table_.fields(row).begin(), table_.fields(row).end());
    append_answer_cells(cells, result.answer ? std::optional(result.answer->answer) : std::nullopt,
                        options_.all_columns);
    append_cells(cells, result.rungs);
    rows_ += io::csv_line(cells);
  }

  [[nodiscard]] ordered_json inputs() const {
    return {{"table", options_.table}, {"rows", table_.row_count()}};
  }

  [[nodiscard]] std::vector<std::string> remarks() const {
    std::vector<std::string> remarks = remarks_.value_or(std::vector<std::string>());
    const std::vector<std::string> unread = reader_.unread();
    if (!unread.empty())
      remarks.push_back(fmt::format("columns that are no inputs: {}", fmt::join(unread, ", ")));
    return remarks;
  }

  const SweepOptions& options_;
  const Rungs& rungs_;
  CsvTable table_;
  AnswerRows reader_;
  std::string rows_;
  ordered_json states_ = ordered_json::array();
  std::optional<std::vector<std::string>> remarks_; ///< from the first row that is a packing
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
  if (!o.picture.empty())
    require_svg(o.picture);
  require_free(o.output, {o.output.out, o.picture});
  const TableSweep sweep(o, rungs);
  const ExitCode code = deliver(o.output, o.output.json ? "" : sweep.csv(),
                                o.output.json ? sweep.json() : ordered_json(), sweep.tally().validity());
  if (!o.picture.empty())
    io::write_file(o.picture, plot::svg(chart_of(sweep.points())),
                   o.output.force ? io::Existing::replace : io::Existing::keep);
  return sweep.tally().conclude(code);
}

} // namespace granum::cli
