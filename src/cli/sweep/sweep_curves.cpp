// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of G/G0 and damping for a state, the depths of a profile or the rows of a table.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "cli/frame/help.hpp"
#include "cli/options/answer_rows.hpp"
#include "cli/options/packing_json.hpp"
#include "curves.hpp"
#include "depth.hpp"

namespace granum::cli {

namespace {

using estimate::Answer;
using estimate::Field;

/// A state whose curve is asked.
struct CurveState {
  std::string where; ///< "4 m", "line 3"; empty for the only one
  InputValues inputs = {};
  std::optional<double> depth = {};       ///< in the ground [m]
  std::optional<std::size_t> line = {};   ///< of the table
  std::optional<double> unit_weight = {}; ///< of its ground [N/m3]
  std::string error = {};                 ///< why there are no inputs
};

/// Whether the options give a single state.
bool is_alone(const SweepOptions& o) { return o.table.empty() && o.ground.depth.empty(); }

/// All of them, with what is assumed of their ground.
struct CurveStates {
  std::vector<CurveState> all = {};
  estimate::Notes assumptions = {};
};

double unit_weight_at(const stress::Ground& ground, double depth) {
  return ground.water_table && depth > *ground.water_table ? ground.saturated_unit_weight
                                                           : ground.unit_weight;
}

CurveStates states_of_profile(const SweepOptions& o) {
  CurveStates states;
  const std::vector<double> depths = depths_of(o);
  const std::vector<Layer> layers = layers_of(o);
  for (const double depth : depths) {
    const Layer& layer = layer_at(layers, depth);
    states.all.push_back({.where = pretty(depth, Dimension::length),
                          .inputs = values_at(layers, depth),
                          .depth = depth,
                          .unit_weight = unit_weight_at(layer.ground.ground, depth - layer.top)});
  }
  states.assumptions = assumptions_of(layers, depths.back());
  return states;
}

/// The state of a row, which may be a depth in a ground of its own.
void set_row(CurveState& state, const AnswerRow& row, bool of_depths) {
  state.inputs = row.inputs;
  if (!of_depths)
    return;
  RowInGround at = in_ground(row);
  state.depth = at.depth;
  state.unit_weight = unit_weight_at(at.ground.ground, at.depth);
  state.inputs = std::move(at.inputs);
}

CurveStates states_of_table(const SweepOptions& o) {
  CurveStates states;
  const io::CsvTable table = io::read_csv(o.table);
  AnswerRows reader(table, o.inputs, o.ground);
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    CurveState state{.where = fmt::format("line {}", table.line(row)), .line = table.line(row)};
    try {
      set_row(state, reader.row(row), reader.in_ground());
    } catch (const Error& error) {
      state.error = error.what();
    }
    states.all.push_back(std::move(state));
  }
  name_remarks(states.assumptions, reader.remarks());
  return states;
}

CurveStates states_of(const SweepOptions& o) {
  if (!o.table.empty())
    return states_of_table(o);
  if (!o.ground.depth.empty())
    return states_of_profile(o);
  CurveState state{.where = "", .inputs = o.inputs};
  if (const Number& k0 = o.ground.earth_pressure_at_rest; k0.given()) {
    state.inputs.give(Input::k0, k0.value);
    state.inputs = estimate::completed(std::move(state.inputs));
  }
  return {.all = {std::move(state)}};
}

/// The strains of the options, ascending, with four digits unless these are too few to differ.
std::vector<double> strains_of(const SweepOptions& o, bool alone) {
  constexpr std::size_t usual = 13;
  constexpr int digits = 4;
  const std::vector<double> exact =
      spread(o.strains[0], o.strains[1], alone && o.points_given ? o.points : usual, true);
  std::vector<double> strains = exact;
  for (std::size_t k = 1; k + 1 < strains.size(); ++k)
    strains[k] = *parse_number(short_text(strains[k], digits));
  return std::ranges::adjacent_find(strains, std::greater_equal<>()) == strains.end() ? strains : exact;
}

InputValues at_strain(const CurveState& state, double strain) {
  InputValues values = state.inputs;
  values.set(Input::shear_strain, strain);
  return values;
}

/// "granum, toyoura, C_u 1.5, 4 m, p' 38.83 kPa".
std::string name_of(const CurveState& state, const AnswerCase& c) {
  std::string name = "granum, ";
  name += state.inputs.known_sand != nullptr ? state.inputs.known_sand->key : "sand";
  if (const auto& uniformity = c.question.sand.uniformity)
    name += ", C_u " + short_text(*uniformity, 3);
  if (!state.where.empty())
    name += ", " + state.where;
  return name + ", p' " + pretty(c.question.state.mean_stress(), Dimension::pressure);
}

/// The answer for a sand at a strain: giving a strain makes the grains a sand.
StrainPoint point_of(double strain, const Answer& answer) {
  return {.strain = strain,
          .ratio = answer[Field::modulus_ratio],
          .damping = answer[Field::damping_ratio],
          .modulus = answer[Field::strained_shear_modulus]};
}

StrainCurve curve_of(const CurveState& state, const std::vector<double>& strains, const AnswerCase& last) {
  StrainCurve curve{.name = name_of(state, last),
                    .depth = state.depth,
                    .line = state.line,
                    .mean_stress = last.question.state.mean_stress(),
                    .modulus = last.answer[Field::shear_modulus],
                    .speed = last.answer[Field::shear_wave_speed]};
  curve.unit_weight = state.unit_weight.value_or(standard_gravity * last.answer[Field::bulk_density].value);
  for (const double strain : strains)
    curve.points.push_back(point_of(strain, bare_answer(at_strain(state, strain)).answer));
  return curve;
}

/// Different names for curves of one name.
void number_names(std::vector<StrainCurve>& curves) {
  std::map<std::string, std::size_t> seen;
  for (StrainCurve& curve : curves)
    if (const std::size_t times = ++seen[curve.name]; times > 1)
      curve.name += fmt::format(" ({})", times);
}

/// The curves of all states that have one, and the case of the first.
struct Curves {
  std::vector<StrainCurve> all = {};
  std::optional<AnswerCase> first = {};
  const CurveState* first_state = nullptr;
  Tally tally = {};
  std::vector<std::string> without_stress = {}; ///< where there is none, and no curve
};

Curves curves_of(const std::vector<CurveState>& states, const std::vector<double>& strains) {
  Curves curves;
  for (const CurveState& state : states) {
    // Notes are those of the largest strain.
    SweptState last =
        state.error.empty() ? swept(at_strain(state, strains.back()), {}) : failed(state.error, {});
    curves.tally.count(last, state.where.empty() ? "state 1" : state.where);
    if (!last.answer)
      continue;
    if (!last.answer->answer.find(Field::modulus_ratio)) {
      curves.without_stress.push_back(state.where);
      continue;
    }
    curves.all.push_back(curve_of(state, strains, *last.answer));
    if (curves.first_state == nullptr) {
      curves.first_state = &state;
      curves.first = std::move(last.answer);
    }
  }
  number_names(curves.all);
  return curves;
}

// ---- the document

/// Of what the curves are, for people and for the notes of files.
std::vector<std::string> comments_of(const std::vector<StrainCurve>& curves, const estimate::Notes& notes) {
  std::vector<std::string> comments;
  if (curves.size() == 1) {
    const StrainCurve& one = curves.front();
    comments.push_back(fmt::format("{}; at small strain G0 = {}, V_s = {}; unit weight {}", one.name,
                                   range_text(Dimension::pressure, one.modulus),
                                   range_text(Dimension::speed, one.speed),
                                   pretty(one.unit_weight, Dimension::unit_weight)));
  }
  for (const estimate::Note& note : notes)
    comments.push_back(note.sentence());
  return comments;
}

plot::Chart chart_of(const std::vector<StrainCurve>& curves, const char* title, double unit,
                     estimate::Range StrainPoint::*range) {
  constexpr std::size_t most = 6; // the lines of more look alike
  plot::Chart chart{.title = curves.size() == 1 ? curves.front().name : "",
                    .x = {.title = "shear strain [%]", .scale = plot::Scale::logarithmic, .unit = 0.01},
                    .y = {.title = title, .unit = unit},
                    .legend_below = true};
  const std::size_t count = std::min(most, curves.size());
  for (std::size_t k = 0; k < count; ++k) {
    const StrainCurve& curve = curves[count == 1 ? 0 : k * (curves.size() - 1) / (count - 1)];
    Band band;
    for (const StrainPoint& point : curve.points)
      band.add(point.strain, point.*range);
    if (curves.size() == 1) {
      add_band(chart, band, false);
      continue;
    }
    plot::Series line{.name = curve.name, .mark = plot::Mark::line, .style = k};
    for (const StrainPoint& point : curve.points)
      line.add(point.strain, (point.*range).value);
    chart.series.push_back(std::move(line));
  }
  return chart;
}

Document document_of(const SweepOptions& o, const Curves& curves, const estimate::Notes& notes) {
  Document to{.command = "sweep"};
  to.signs = "";
  to.title = "Stiffness and damping of a sand over shear strain";
  to.comments = {{"columns",
                  "amplitude of the shear strain and damping ratio in per cent; low and high: one standard "
                  "deviation to each side"}};
  InputValues inputs = curves.first_state->inputs;
  inputs.grain_shape = estimate::GrainShape::sand; // which the strains implied
  inputs.leave_out(Input::shear_strain);
  to.add(Seen::data, Data{"inputs", packing_json(inputs, curves.first->question.state)});
  to.add(Seen::data, curve_table(curves.all, is_alone(o)));
  if (constexpr std::size_t most_on_a_page = 8; curves.all.size() <= most_on_a_page)
    to.add(Seen::full, shown_curves(curves.all));
  to.add_notes(notes);
  const std::vector<std::string> comments = comments_of(curves.all, notes);
  if (curves.all.size() == 1)
    to.comments.emplace_back("state", comments.front());
  if (o.curves_for == "pystrata")
    to.own_text = pystrata_text(curves.all, comments);
  else if (o.curves_for == "strata")
    to.own_text = strata_text(curves.all, comments, is_alone(o));
  to.warnings = curves.tally.validity();
  if (outlets_of(o).draws())
    to.add(Seen::data, Picture{{chart_of(curves.all, "G/G0", 1, &StrainPoint::ratio),
                                chart_of(curves.all, "damping [%]", 0.01, &StrainPoint::damping)}});
  return to;
}

/// \throws   InvalidArgument for formats and strains that do not go together
void require_curve(const SweepOptions& o, const std::vector<double>& strains) {
  constexpr std::size_t least_of_strata = 3; // it interpolates from three on
  if (o.curves_for == "strata" && strains.size() < least_of_strata)
    throw InvalidArgument(fmt::format(
        "--points = {} are too few for Strata, which interpolates three and more", strains.size()));
  if (o.output.json && o.curves_for != "table")
    throw InvalidArgument(fmt::format("--for {} has a form of its own: leave out --json", o.curves_for));
}

} // namespace

ExitCode sweep_curves(const SweepOptions& o) {
  const Outlets to = outlets_of(o);
  require_free(to);
  const bool alone = is_alone(o);
  const std::vector<double> strains = strains_of(o, alone);
  require_curve(o, strains);
  const CurveStates states = states_of(o);
  if (alone)
    (void)bare_answer(at_strain(states.all.front(), strains.back())); // its refusal is that of estimate
  const Curves curves = curves_of(states.all, strains);
  if (curves.all.empty() && !curves.without_stress.empty())
    throw InvalidArgument("without stress a sand has no curve: G/G0 depends on the mean stress");
  if (curves.all.empty())
    return curves.tally.conclude(ExitCode::ok);
  estimate::Notes notes = states.assumptions;
  if (o.ground.depth.empty()) {
    const AnswerCase solved = solve_answer(at_strain(*curves.first_state, strains.back()), {});
    notes.insert(notes.begin(), solved.assumptions.begin(), solved.assumptions.end());
  }
  if (!curves.without_stress.empty())
    add_sentence(notes, "no curve at " + joined(curves.without_stress, ", ") + ", where there is no stress");
  return curves.tally.conclude(deliver_sweep(to, document_of(o, curves, notes)));
}

} // namespace granum::cli
