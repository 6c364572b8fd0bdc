// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <granum/core/error.hpp>

#include "cli/frame/json_members.hpp"
#include "cli/options/answer_rows.hpp"
#include "depth.hpp"

namespace granum::cli {

namespace {

using estimate::Field;
using io::CsvTable;
using nlohmann::ordered_json;

/// Stresses at a row that is a depth in the ground; none where the row failed.
using RowStress = std::optional<stress::GroundStress>;

io::Columns<RowStress> stress_columns() {
  const auto of = [](double (*number)(const stress::GroundStress&)) {
    return [number](const RowStress& at) { return at ? std::optional(number(*at)) : std::nullopt; };
  };
  return {{"pore_pressure_Pa", "pore_pressure", of([](const auto& at) { return at.pore_pressure; })},
          {"sigma_v_Pa", "stress_v", of([](const auto& at) { return at.effective.v; })},
          {"sigma_h_Pa", "stress_h", of([](const auto& at) { return at.effective.h; })},
          {"p_Pa", "mean_stress", of([](const auto& at) { return at.effective.mean(); })}};
}

/// Measured V_s over that of the answer (that for a sand, if there are two); empty without either.
using SpeedRatio = std::optional<double>;

SpeedRatio speed_ratio(const SweptState& state, const std::optional<double>& measured) {
  if (!state.answer || !measured)
    return std::nullopt;
  const estimate::Answer* const sand = state.answer->of_sand();
  const auto& answer = (sand != nullptr ? *sand : state.answer->answer).find(Field::shear_wave_speed);
  return answer && answer->value > 0 ? SpeedRatio(*measured / answer->value) : std::nullopt;
}

io::Columns<SpeedRatio> speed_columns() {
  return {
      {"V_s_measured_over_answer", "measured_over_answer", [](const SpeedRatio& ratio) { return ratio; }}};
}

/// A point of the picture.
struct RowPoint {
  double mean_stress, void_ratio;
  estimate::Range shear_modulus;          ///< of the answer
  std::optional<estimate::Range> of_sand; ///< beside it
  bool beads;                             ///< whether the answer is that for spheres
  std::optional<estimate::Range> of_laws;
};

/// Answers the rows of a table one by one, because a table may have millions.
class TableSweep {
 public:
  TableSweep(const SweepOptions& options, const Rungs& rungs)
      : options_(options), rungs_(rungs), table_(io::read_csv(options.table)),
        reader_(table_, options.inputs, options.ground),
        stresses_(
            SweptRows::in_units(reader_.in_ground() ? stress_columns() : io::Columns<RowStress>{}, options)),
        speeds_(
            SweptRows::in_units(reader_.has_speed() ? speed_columns() : io::Columns<SpeedRatio>{}, options)),
        output_(options_of_rows(), rungs, leading_headings(), asked_of_rows(), table_.manner()) {
    std::vector<std::string> results = output_.result_headings();
    for (const std::vector<std::string>& more : {io::headings_of(stresses_), io::headings_of(speeds_)})
      results.insert(results.end(), more.begin(), more.end());
    for (const std::string& heading : results)
      if (std::find(table_.headings().begin(), table_.headings().end(), heading) != table_.headings().end())
        throw FileError(options.table, 0, "already has a column '" + heading + "', the name of a result");
    for (std::size_t row = 0; row < table_.row_count(); ++row)
      add(row);
  }

  [[nodiscard]] Document document() && {
    Document to = std::move(output_).document(remarks());
    to.add(Seen::data, Data{"inputs", {{"table", options_.table}, {"rows", table_.row_count()}}});
    to.warnings = tally_.validity();
    return to;
  }
  [[nodiscard]] const Tally& tally() const { return tally_; }
  [[nodiscard]] const std::vector<RowPoint>& points() const { return points_; }

 private:
  /// Rows with depths describe soil.
  const SweepOptions& options_of_rows() {
    options_.inputs.ground = reader_.in_ground();
    return options_;
  }

  /// Read before the first row is answered, because columns are the same for all.
  AskedOfRows asked_of_rows() {
    AskedOfRows all;
    for (std::size_t row = 0; row < table_.row_count() && !(all.both && all.strained); ++row)
      try {
        const AnswerRow question = reader_.row(row);
        const AskedOfRows here = asked_of(question.inputs);
        all = {.both = all.both || here.both, .strained = all.strained || here.strained};
      } catch (const Error&) { // the row reports it when it is answered
      }
    return all;
  }

  [[nodiscard]] std::vector<std::string> leading_headings() const {
    std::vector<std::string> all = table_.headings();
    for (const std::vector<std::string>& more : {io::headings_of(stresses_), io::headings_of(speeds_)})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// The answer at a depth, with the ground of the row.
  SweptState state_at_depth(const AnswerRow& question, RowStress& stress) {
    const RowInGround at = in_ground(question);
    SweptState state = swept(at.inputs, rungs_);
    stress = at.stress;
    if (!assumptions_) {
      assumptions_ = at.ground.assumptions;
      const AnswerCase solved = solve_answer(at_stress(question.inputs, at.stress.effective), {});
      assumptions_->insert(assumptions_->end(), solved.assumptions.begin(), solved.assumptions.end());
    }
    for (const std::string& note : at.ground.validity.notes)
      state.notes.push_back(note);
    return state;
  }

  SweptState state_of(std::size_t row, RowStress& stress, SpeedRatio& ratio) {
    try {
      const AnswerRow question = reader_.row(row);
      if (!reader_.in_ground() && !complete_) {
        const AnswerCase solved = solve_answer(question.inputs, {});
        complete_ = solved.beads_refused.empty();
        if (complete_ || !assumptions_)
          assumptions_ = solved.assumptions;
      }
      SweptState state =
          reader_.in_ground() ? state_at_depth(question, stress) : swept(question.inputs, rungs_);
      ratio = speed_ratio(state, question.shear_wave_speed);
      if (const std::string remark = ratio ? sands::level_remark(*ratio * *ratio) : ""; !remark.empty())
        state.notes.push_back("according to the measured V_s, " + remark);
      return state;
    } catch (const Error& error) {
      return failed(error.what(), rungs_);
    }
  }

  void add(std::size_t row) {
    RowStress stress;
    SpeedRatio ratio;
    const SweptState state = state_of(row, stress, ratio);
    tally_.count(state, fmt::format("line {}", table_.line(row)));
    if (state.answer && outlets_of(options_).draws()) {
      const effective::State& packing = state.answer->answer.state();
      points_.push_back(
          {.mean_stress = packing.mean_stress(),
           .void_ratio = packing.void_ratio,
           .shear_modulus = state.answer->answer[Field::shear_modulus],
           .of_sand = state.answer->sand_answer ? state.answer->sand_answer->find(Field::shear_modulus)
                                                : std::nullopt,
           .beads = state.answer->question.grain_shape == estimate::GrainShape::sphere,
           .of_laws = options_.law_columns ? range_of_laws(*state.answer, laws_tested(*state.answer))
                                           : std::nullopt});
    }
    const std::vector<std::string>& fields = table_.fields(row);
    std::vector<io::CsvCell> cells(fields.begin(), fields.end());
    io::add_cells(cells, stresses_, stress);
    io::add_cells(cells, speeds_, ratio);
    ordered_json place = {{"line", table_.line(row)}};
    if (!stresses_.empty())
      place.update(members(stresses_, stress));
    if (!speeds_.empty())
      place["shear_wave_speed"] = members(speeds_, ratio);
    output_.add(std::move(cells), std::move(place), state);
  }

  [[nodiscard]] estimate::Notes remarks() const {
    estimate::Notes remarks = assumptions_.value_or(estimate::Notes());
    name_remarks(remarks, reader_.remarks());
    return remarks;
  }

  SweepOptions options_;
  const Rungs& rungs_;
  CsvTable table_;
  AnswerRows reader_;
  io::Columns<RowStress> stresses_; ///< if rows are depths
  io::Columns<SpeedRatio> speeds_;  ///< if V_s was measured
  SweptRows output_;
  std::optional<estimate::Notes> assumptions_; ///< of the first row with all answers, or else any
  bool complete_ = false;                      ///< whether that row has all
  std::vector<RowPoint> points_;
  Tally tally_;
};

/// G with its range over the mean stress, or over the void ratio if all rows have one stress.
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
                    .y = {.title = "G [MPa]", .scale = scale, .unit = 1e6}};
  if (one_stress)
    chart.x = {.title = "void ratio"};
  const auto x_of = [&](const RowPoint& point) { return one_stress ? point.void_ratio : point.mean_stress; };
  double least = INFINITY, most = -INFINITY;
  for (const RowPoint& point : points) {
    least = std::min(least, x_of(point));
    most = std::max(most, x_of(point));
  }
  // Side by side, so that ranges of one row do not hide each other.
  const auto beside = [&](double x, int side) {
    return logarithmic ? x * std::pow(1.02, side) : x + 0.008 * side * (most > least ? most - least : x);
  };
  const auto add = [&](const std::string& name, plot::Colour colour, int side, std::size_t style,
                       const auto& range_of) {
    plot::Series ranges{.name = name == "answer" ? "range" : name + ", range",
                        .mark = plot::Mark::line,
                        .style = 0,
                        .tone = plot::Tone::faint,
                        .colour = colour};
    plot::Series answers{.name = name, .mark = plot::Mark::marker, .style = style, .colour = colour};
    for (const RowPoint& point : points)
      if (const std::optional<estimate::Range> range = range_of(point)) {
        const double x = beside(x_of(point), side);
        answers.add(x, range->value);
        for (const double end : {range->low, range->high, nothing}) {
          ranges.add(x, end); // a gap after each range
        }
      }
    if (answers.x.empty())
      return;
    chart.series.push_back(std::move(ranges));
    chart.series.push_back(std::move(answers));
  };
  const bool both = std::any_of(points.begin(), points.end(),
                                [](const RowPoint& point) { return point.of_sand.has_value(); });
  add("published laws", plot::Colour::power_law, -1, 1, [](const RowPoint& point) { return point.of_laws; });
  add("sand", plot::Colour::measured, 0, 2, [both](const RowPoint& point) {
    return both && !point.beads ? std::optional(point.shear_modulus) : point.of_sand;
  });
  add(both ? "beads" : "answer", plot::Colour::closed_form, both ? 1 : 0, 0, [both](const RowPoint& point) {
    return both && !point.beads ? std::nullopt : std::optional(point.shear_modulus);
  });
  return chart;
}

} // namespace

ExitCode sweep_table(const SweepOptions& o, const Rungs& rungs) {
  const Outlets to = outlets_of(o);
  require_free(to);
  TableSweep sweep(o, rungs);
  Document document = std::move(sweep).document();
  document.title = "Stiffness at the states of a table";
  add_sources(document);
  if (to.draws())
    document.add(Seen::data, Picture{{chart_of(sweep.points())}});
  return sweep.tally().conclude(deliver_sweep(to, document));
}

} // namespace granum::cli
