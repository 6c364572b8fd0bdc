// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/sands/strain.hpp>

#include "answer_report.hpp"
#include "cli/frame/frame.hpp"

namespace granum::cli {

namespace {

using estimate::Field;
using estimate::GrainShape;
using nlohmann::ordered_json;

sands::StrainedSand strained_sand(const estimate::Question& q) {
  return {.strain = *q.shear_strain,
          .void_ratio = q.state.void_ratio,
          .mean_stress = q.state.mean_stress(),
          .sand = q.sand};
}

bool has_strain(const AnswerCase& c) {
  return c.question.shear_strain && c.question.state.mean_stress() > 0 && answer_of_sand(c) != nullptr;
}

/// "sands by these laws are 2.4 times stiffer than these spheres".
std::string comparison_text(const AnswerCase& c) {
  constexpr double alike = 1.25;
  const std::optional<estimate::Range> laws = range_of_laws(c, laws_tested(c));
  const double G = c.answer[Field::shear_modulus].value;
  if (c.question.grain_shape == GrainShape::sand || !laws || !(G > 0) || !std::isfinite(laws->value / G) ||
      !std::isfinite(G / laws->value))
    return "";
  const double ratio = laws->value / G;
  if (ratio > alike)
    return fmt::format("    sands by these laws are {} times stiffer than these spheres\n",
                       short_text(ratio, 2));
  if (ratio < 1 / alike)
    return fmt::format("    sands by these laws are {} times softer than these spheres\n",
                       short_text(1 / ratio, 2));
  return "    sands by these laws are about as stiff as these spheres\n";
}

std::string strain_text(const AnswerCase& c) {
  if (!has_strain(c))
    return "";
  std::string text =
      fmt::format("\n  G/G0 of published laws at a shear strain of {}; small strain is 0.001 % "
                  "and less\n",
                  percent_text(*c.question.shear_strain));
  for (const sands::StrainLaw& law : sands::strain_laws())
    text += fmt::format("    {:<26}{:>11}  [{}]\n", law.key,
                        short_text(law.ratio(strained_sand(c.question)), 3), law.source);
  return text;
}

} // namespace

const char* title_of(GrainShape shape) {
  return shape == GrainShape::sand ? "sand (measured laws)" : "beads (spheres of the model)";
}

const estimate::Answer* answer_of_sand(const AnswerCase& c) {
  if (c.question.grain_shape == GrainShape::sand)
    return &c.answer;
  return c.sand_answer ? &*c.sand_answer : nullptr;
}

void add_measured_laws(AnswerCase& c) {
  const estimate::Question& q = c.question;
  c.uniformity = q.sand.uniformity.value_or(sands::uniform_sand);
  c.uniformity_assumed = !q.sand.uniformity;
  sands::SandState sand{
      .void_ratio = q.state.void_ratio, .mean_stress = q.state.mean_stress(), .uniformity = c.uniformity};
  sand.d50 = q.sand.d50.value_or(sand.d50);
  if (!(sand.mean_stress > 0))
    return;
  for (const sands::MeasuredLaw& law : sands::measured_laws()) {
    c.sands.push_back({&law, std::nullopt});
    try {
      c.sands.back().modulus = sands::shear_modulus(law, sand);
    } catch (const InvalidArgument&) { // a void ratio beyond the zero of the law, or grains that are no sand
    }
  }
}

std::vector<bool> laws_tested(const AnswerCase& c) {
  std::vector<bool> tested;
  for (const SandAnswer& sand : c.sands)
    tested.push_back(sand.modulus && sand.modulus->validity.ok());
  return tested;
}

std::optional<estimate::Range> range_of_laws(const AnswerCase& c, const std::vector<bool>& some) {
  const bool all = std::find(some.begin(), some.end(), true) == some.end();
  double low = INFINITY, high = 0;
  for (std::size_t k = 0; k < c.sands.size(); ++k)
    if (c.sands[k].modulus && (all || some.at(k))) {
      low = std::min(low, c.sands[k].modulus->shear_modulus);
      high = std::max(high, c.sands[k].modulus->shear_modulus);
    }
  if (!(high > 0))
    return std::nullopt;
  return estimate::Range{.value = std::sqrt(low * high), .low = low, .high = high};
}

std::string answer_csv(const AnswerCase& c, const ordered_json& packing) {
  const auto& s = c.question.state;
  io::CsvContent csv{
      .notes = {{"program", fmt::format("granum {} estimate", version())},
                {"inputs", json_text(packing, -1)},
                {"signs", "compression positive; z is the vertical axis v"}},
      .headings = {"e", "sigma_v_Pa", "sigma_h_Pa", "grain_shape"},
      .rows = {{s.void_ratio, s.stress_v, s.stress_h, std::string(name(c.question.grain_shape))}}};
  for (const std::string& note : c.assumptions)
    csv.notes.emplace_back("note", note);
  const auto add = [&](const estimate::Answer& answer, const char* before) {
    const io::Columns<estimate::Answer> columns = answer_columns(true, true, before);
    for (const io::Column<estimate::Answer>& column : columns)
      csv.headings.push_back(column.heading);
    io::add_cells(csv.rows.front(), columns, answer);
  };
  add(c.answer, "");
  if (c.sand_answer)
    add(*c.sand_answer, "sand_");
  return io::csv_text(csv);
}

std::string sands_text(const AnswerCase& c) {
  if (c.sands.empty())
    return "";
  const auto& s = c.question.state;
  std::string text =
      fmt::format("\n  G of published laws at e = {}, p' = {}, C_u = {}{}; beside G its bias, "
                  "the mean ratio of calculated to measured G in 789 tests of 38 clean sands\n",
                  short_text(s.void_ratio), pretty(s.mean_stress(), Dimension::pressure),
                  short_text(c.uniformity), c.uniformity_assumed ? " assumed" : "");
  for (const SandAnswer& sand : c.sands)
    text += fmt::format("    {:<26}{:>11}  {:.2f} {}{}\n", sand.law->key,
                        sand.modulus ? pretty(sand.modulus->shear_modulus, Dimension::pressure) : "none",
                        sand.law->record.bias, sand.law->sand,
                        sand.modulus && sand.modulus->validity.ok() ? "" : " (outside its tests)");
  return text + comparison_text(c) + strain_text(c);
}

ordered_json sands_json(const AnswerCase& c) {
  ordered_json json = ordered_json::array();
  for (const SandAnswer& sand : c.sands) {
    json.push_back(
        {{"law", sand.law->key},
         {"sand", sand.law->sand},
         {"source", sand.law->source},
         {"formula", sand.law->formula},
         {"bias", sand.law->record.bias},
         {"rms_log10", sand.law->record.rms_log10},
         {"shear_modulus", sand.modulus ? ordered_json(sand.modulus->shear_modulus) : ordered_json()},
         {"notes", sand.modulus ? ordered_json(sand.modulus->validity.notes) : ordered_json::array()}});
  }
  return json;
}

ordered_json strain_laws_json(const AnswerCase& c) {
  ordered_json json = ordered_json::array();
  if (has_strain(c))
    for (const sands::StrainLaw& law : sands::strain_laws())
      json.push_back({{"law", law.key},
                      {"source", law.source},
                      {"formula", law.formula},
                      {"modulus_ratio", law.ratio(strained_sand(c.question))}});
  return json;
}

} // namespace granum::cli
