// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

namespace granum::cli {

namespace {

using estimate::Answer;
using estimate::Field;
using estimate::FieldRow;
using estimate::Range;
using nlohmann::ordered_json;

constexpr double uniform_sand = 1.5; ///< C_u of the measured laws where none is told

std::vector<SandAnswer> measured_sands(const hardin::SandState& sand) {
  std::vector<SandAnswer> answers;
  if (!(sand.mean_stress > 0))
    return answers;
  for (const hardin::MeasuredLaw& law : hardin::measured_laws()) {
    answers.push_back({&law, std::nullopt});
    try {
      answers.back().modulus = hardin::shear_modulus(law, sand);
    } catch (const InvalidArgument&) { // a void ratio at which the law has reached zero
    }
  }
  return answers;
}

/// "assumed --grain-shear-modulus 30 GPa +- 9 GPa, as ...".
std::vector<std::string> with_deviations(std::vector<std::string> notes, const PackingOptions& packing,
                                         const AnswerOptions& options, const AnswerCase& c) {
  for (const estimate::UncertainInput& input : c.inputs)
    for (std::string& note : notes) {
      const std::string begin = "assumed --" + input.input + " ";
      if (input.assumed && note.starts_with(begin))
        note.insert(std::min(note.find(','), note.size()), " +- " + deviation_text(packing, options, input));
    }
  return notes;
}

bool anisotropic(const estimate::Question& q) {
  return q.state.stress_v != q.state.stress_h || q.state.fabric_anisotropy != 0;
}

ordered_json json_of(const std::optional<Range>& range) {
  return range ? ordered_json{{"value", range->value}, {"low", range->low}, {"high", range->high}}
               : ordered_json();
}

std::string preparation_text(const effective::Preparation& preparation) {
  switch (preparation.kind) {
  case effective::Preparation::Kind::dense:
    return "dense";
  case effective::Preparation::Kind::loose:
    return "loose";
  case effective::Preparation::Kind::friction:
    return "friction:" + short_text(preparation.friction_coefficient);
  default:
    return "unknown";
  }
}

// ---- text

std::string pressure(double value) { return pretty(value, Dimension::pressure); }

bool is_shown(const FieldRow& row, bool by_direction) {
  return row.shown == estimate::Shown::always || (row.shown == estimate::Shown::by_direction && by_direction);
}

std::string moduli_text(const AnswerCase& c) {
  const bool wet = c.question.saturation > 0, by_direction = anisotropic(c.question);
  std::string text = fmt::format("  {:<7}{:>11}{:>12}{:>12}\n", "", "answer", "low", "high");
  for (const FieldRow& row : estimate::fields()) {
    const std::optional<Range>& range = c.answer.find(row.field);
    if (!range || !is_shown(row, by_direction))
      continue;
    text +=
        fmt::format("  {:<7}{:>11}{:>12}{:>12}  {}{}\n", by_direction ? row.directed_symbol : row.symbol,
                    field_text(row, range->value), field_text(row, range->low), field_text(row, range->high),
                    by_direction ? row.directed_meaning : row.meaning, wet ? row.in_water : "");
  }
  return text;
}

/// "contacts 81 %, grain-shear-modulus 12 %": without what rounds to nothing.
std::string shares_text(const Answer& answer) {
  std::string text;
  for (const estimate::Share& share : answer.shares())
    if (share.share >= 0.005)
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", share.input, 100 * share.share);
  return text.empty() ? "" : "\n  the range of G: " + text + "\n";
}

std::string preparation_remark(const AnswerCase& c) {
  if (c.question.knows_contacts())
    return "";
  if (c.question.preparation.kind != effective::Preparation::Kind::unknown)
    return fmt::format("  contacts of the preparation {}, as sphere packings have them\n",
                       preparation_text(c.question.preparation));
  return "  how the grains came together is not known: from friction 0.5 to the densest contacts of "
         "this void ratio; --preparation, --rattler-fraction or --mechanical-coordination-number narrow it\n";
}

/// What the laws say that were tested at this void ratio and stress; of all, if none was.
Range tested_range(const std::vector<SandAnswer>& sands) {
  const auto over = [&](bool tested) {
    Range range{.value = 0, .low = INFINITY, .high = 0};
    for (const SandAnswer& sand : sands)
      if (sand.modulus && (!tested || sand.modulus->validity.ok())) {
        range.low = std::min(range.low, sand.modulus->shear_modulus);
        range.high = std::max(range.high, sand.modulus->shear_modulus);
      }
    return range;
  };
  const Range tested = over(true);
  return tested.high > 0 ? tested : over(false);
}

/// How spheres compare with sands, and why they may differ.
std::string comparison_text(const Range& G, const std::vector<SandAnswer>& sands) {
  constexpr double alike = 1.25;
  const Range sand = tested_range(sands);
  if (!(sand.high > 0 && G.value > 0))
    return "";
  const double ratio = std::sqrt(sand.low * sand.high) / G.value;
  if (ratio > alike)
    return fmt::format("they are {} times stiffer than these spheres: angular grains hardly roll, and keep\n"
                       "    more contacts in so loose a packing\n",
                       short_text(ratio, 2));
  if (ratio < 1 / alike)
    return fmt::format(
        "they are {} times softer than these spheres: rough grains touch at small asperities,\n"
        "    and poured ones at fewer places\n",
        short_text(1 / ratio, 2));
  return "these spheres are as stiff\n";
}

std::string sands_text(const AnswerCase& c) {
  if (c.sands.empty())
    return "";
  const auto& s = c.question.state;
  std::string text =
      fmt::format("\n  G of measured sands at e = {}, p = {}, C_u = {}{}; each scatters by a factor of 1.6\n",
                  short_text(s.void_ratio), pressure(s.mean_stress()), short_text(c.uniformity),
                  c.uniformity_assumed ? " assumed" : "");
  for (const SandAnswer& sand : c.sands)
    text += fmt::format("    {:<26}{:>11}  {}{}\n", sand.law->key,
                        sand.modulus ? pressure(sand.modulus->shear_modulus) : "none", sand.law->sand,
                        sand.modulus && sand.modulus->validity.ok() ? "" : " (not tested here)");
  return text + "    " + comparison_text(c.answer[Field::shear_modulus], c.sands);
}

} // namespace

std::string field_text(const FieldRow& row, double value) {
  switch (row.dimension) {
  case Dimension::pressure:
    return pressure(value);
  case Dimension::dimensionless:
    return short_text(value, 3);
  default:
    return short_text(value, 4) + " " + std::string(si_symbol(row.dimension));
  }
}

io::Columns<Answer> answer_columns(bool all) {
  constexpr Field usual[] = {Field::shear_modulus, Field::shear_wave_speed, Field::compression_wave_speed,
                             Field::mechanical_coordination_number, Field::stress_exponent};
  io::Columns<Answer> columns;
  for (const FieldRow& row : estimate::fields()) {
    if (!all && std::find(std::begin(usual), std::end(usual), row.field) == std::end(usual))
      continue;
    const std::string unit(si_symbol(row.dimension));
    for (const auto& [name, part] :
         {std::pair{"answer", &Range::value}, {"low", &Range::low}, {"high", &Range::high}})
      columns.emplace_back(fmt::format("{}_{}{}{}", row.column, name, unit.empty() ? "" : "_", unit), "",
                           [field = row.field, part = part](const Answer& answer) {
                             const std::optional<Range>& range = answer.find(field);
                             return range ? std::optional((*range).*part) : std::nullopt;
                           });
  }
  return columns;
}

AnswerCase bare_answer(const PackingOptions& packing, const AnswerOptions& options,
                       const std::vector<std::string>& uncertainties) {
  estimate::Question question = question_of(packing, options);
  std::vector<estimate::UncertainInput> inputs = uncertain_inputs_of(packing, options, uncertainties);
  estimate::Answer answer = estimate::answer(question, inputs);
  return {.question = std::move(question), .inputs = std::move(inputs), .answer = std::move(answer)};
}

AnswerCase solve_answer(const PackingOptions& packing, const AnswerOptions& options,
                        const std::vector<std::string>& uncertainties) {
  AnswerCase c = bare_answer(packing, options, uncertainties);
  const auto& s = c.question.state;
  const std::optional<double> of_sand = options.sand != nullptr ? options.sand->uniformity : std::nullopt;
  c.uniformity =
      packing.sizes ? sizes::gradation(*packing.sizes, 1).uniformity() : of_sand.value_or(uniform_sand);
  c.uniformity_assumed = !packing.sizes && !of_sand;
  c.sands = measured_sands(
      {.void_ratio = s.void_ratio, .mean_stress = s.mean_stress(), .uniformity = c.uniformity});
  c.assumptions = assumed_grains(packing, s);
  if (!options.grain_density.given())
    c.assumptions.push_back(
        fmt::format("assumed --grain-density {}", pretty(options.grain_density.value, Dimension::density)));
  c.assumptions = with_deviations(std::move(c.assumptions), packing, options, c);
  if (options.mineral != nullptr)
    c.assumptions.push_back(fmt::format("grains of {} [{}]", options.mineral->name, options.mineral->source));
  if (options.sand != nullptr)
    c.assumptions.push_back(
        fmt::format("{} [{}]: grains are taken to be equal spheres; --uniformity makes them unequal",
                    options.sand->name, options.sand->source));
  if (c.question.saturation > 0 && c.question.saturation < 1)
    c.assumptions.emplace_back(
        "air and water share one pressure in the pores; menisci between grains are left out");
  return c;
}

ordered_json answer_json(const AnswerCase& c) {
  ordered_json json = ordered_json::object();
  for (const FieldRow& row : estimate::fields())
    json[row.key] = json_of(c.answer.find(row.field));
  json.update({{"preparation", preparation_text(c.question.preparation)},
               {"grain_density", *c.question.grain_density},
               {"saturation", c.question.saturation}});
  json["shares"] = ordered_json::object();
  for (const estimate::Share& share : c.answer.shares())
    json["shares"][share.input] = share.share;
  json["assumed_deviations"] = ordered_json::object();
  json["stated_deviations"] = ordered_json::object();
  for (const estimate::UncertainInput& input : c.inputs)
    json[input.assumed ? "assumed_deviations" : "stated_deviations"][input.input] = input.deviation;
  json["notes"] = c.assumptions;
  return json;
}

ordered_json sands_json(const AnswerCase& c) {
  ordered_json json = ordered_json::array();
  for (const SandAnswer& sand : c.sands) {
    json.push_back(
        {{"law", sand.law->key},
         {"sand", sand.law->sand},
         {"source", sand.law->source},
         {"formula", sand.law->formula},
         {"shear_modulus", sand.modulus ? ordered_json(sand.modulus->shear_modulus) : ordered_json()},
         {"notes", sand.modulus ? ordered_json(sand.modulus->validity.notes) : ordered_json::array()}});
  }
  return json;
}

std::string range_text(const AnswerCase& c) { return shares_text(c.answer) + preparation_remark(c); }

std::string answer_table(const AnswerCase& c) { return moduli_text(c) + range_text(c) + sands_text(c); }

} // namespace granum::cli
