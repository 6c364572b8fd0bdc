// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "cli/options/likely_mistakes.hpp"
#include "depth.hpp"

namespace granum::cli {

namespace {

void give(Number& number, double value) {
  number.value = value;
  number.in_table = true;
}

/// The answer of granum estimate at the stresses and in the water of that depth.
DepthAnswer answer_at(const SweepOptions& o, const GroundCase& ground, double depth) {
  const stress::GroundStress stress = stress::stress_at(ground.ground, depth);
  PackingOptions packing = o.packing;
  AnswerOptions answer = o.answer;
  give(packing.stress_v, stress.effective.v);
  give(packing.stress_h, stress.effective.h);
  const auto& table = ground.ground.water_table;
  give(answer.saturation, table && depth > *table ? 1.0 : ground.saturation);
  return {.depth = depth, .stress = stress, .answer = solve_answer(packing, answer, {})};
}

std::vector<DepthAnswer> answers_at(const SweepOptions& o, const GroundCase& ground,
                                    const std::vector<double>& depths) {
  std::vector<DepthAnswer> answers;
  for (const double depth : depths)
    answers.push_back(answer_at(o, ground, depth));
  return answers;
}

std::vector<std::string> remarks_on(const SweepOptions& o, const DepthSweep& sweep) {
  std::vector<std::string> remarks = sweep.ground.assumptions;
  for (const DepthAnswer& at : sweep.answers)
    for (const std::string& note : at.answer.assumptions)
      if (std::find(remarks.begin(), remarks.end(), note) == remarks.end())
        remarks.push_back(note);
  const bool counted = o.packing.coordination_number.given() || o.packing.rattler_fraction.given() ||
                       o.packing.mechanical_coordination_number.given();
  remarks.emplace_back(counted
                           ? "void ratio and contacts are the same at every depth"
                           : "void ratio and preparation are the same at every depth; contacts grow with p'");
  if (sweep.ground.ground.earth_pressure_at_rest != 1)
    remarks.emplace_back(
        "unequal stresses act on each contact by its direction (rung 2, relaxed); they change "
        "no contacts: --fabric is that of the ground as it lies");
  if (sweep.answers.front().stress.effective.v == 0)
    remarks.emplace_back(
        "without stress spheres have no stiffness: at the surface G and V_s are 0, where suction "
        "and cement would hold real ground");
  return remarks;
}

DepthSweep solve(const SweepOptions& o) {
  DepthSweep sweep{.ground = resolve_ground(o), .packing = {}, .answers = {}, .remarks = {}};
  sweep.answers = answers_at(o, sweep.ground, sweep.ground.depths);
  sweep.packing = packing_json(o.packing, sweep.answers.back().answer.question.state);
  if (!o.packing.coordination_number.given())
    sweep.packing.erase("coordination_number");
  sweep.remarks = remarks_on(o, sweep);
  return sweep;
}

/// Depths close enough for smooth curves, with the jump at the water table.
std::vector<double> picture_depths(const GroundCase& c) {
  constexpr std::size_t count = 121;
  const double first = c.depths.front(), last = c.depths.back();
  std::vector<double> depths = spread(first, last, count, false);
  const auto& table = c.ground.water_table;
  if (table && *table > first && *table < last) {
    depths.push_back(*table);
    depths.push_back(std::nextafter(*table, last));
  }
  std::sort(depths.begin(), depths.end());
  return depths;
}

void draw(const SweepOptions& o, DepthSweep sweep) {
  sweep.answers = answers_at(o, sweep.ground, picture_depths(sweep.ground));
  io::write_file(o.picture, plot::svg(depth_charts(sweep)),
                 o.output.force ? io::Existing::replace : io::Existing::keep);
}

/// What formulas say of single depths, each once, and how often.
Validity validity_of(const SweepOptions& o, const DepthSweep& sweep) {
  Validity validity = likely_mistakes(o.packing, sweep.answers.back().answer.question.state);
  validity.merge(likely_mistakes(o.answer.grain_density));
  validity.merge(sweep.ground.validity);
  Tally tally;
  for (const DepthAnswer& at : sweep.answers)
    tally.count({.answers = {}, .notes = at.answer.answer.validity.notes, .slips = {}, .error = ""},
                pretty(at.depth, Dimension::length));
  validity.merge(tally.validity());
  return validity;
}

} // namespace

ExitCode sweep_depth(const SweepOptions& o) {
  if (!o.picture.empty())
    require_svg(o.picture);
  require_free(o.output, {o.output.out, o.picture});
  const DepthSweep sweep = solve(o);
  const bool csv = !o.output.out.empty() && !o.output.json;
  const ExitCode code =
      deliver(o.output, csv ? depth_csv(sweep, o.all_columns) : depth_table(sweep),
              o.output.json ? depth_json(sweep) : nlohmann::ordered_json(), validity_of(o, sweep));
  if (!o.picture.empty())
    draw(o, sweep);
  return code;
}

} // namespace granum::cli
