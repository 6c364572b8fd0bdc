// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_report.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/estimate/notes.hpp>

namespace granum::cli {

namespace {

using estimate::Answer;
using estimate::Field;
using estimate::FieldRow;
using estimate::Range;
using nlohmann::ordered_json;

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

std::string moduli_text(const AnswerCase& c, const Answer& answer) {
  const bool wet = c.question.saturation > 0, by_direction = anisotropic(c.question);
  std::string text = fmt::format("  {:<7}{:>11} {:>11} {:>11}\n", "", "answer", "low", "high");
  for (const FieldRow& row : estimate::fields()) {
    const std::optional<Range>& range = answer.find(row.field);
    if (!range || !is_shown(row, by_direction))
      continue;
    text +=
        fmt::format("  {:<7}{:>11} {:>11} {:>11}  {}{}\n", by_direction ? row.directed_symbol : row.symbol,
                    field_text(row, range->value), field_text(row, range->low), field_text(row, range->high),
                    by_direction ? row.directed_meaning : row.meaning, wet ? row.in_water : "");
  }
  return text;
}

/// The name of an input in a sentence; JSON has its key.
std::string_view input_text(std::string_view input) {
  if (input == "sand to sand")
    return "differences between sands";
  if (input == "rung 3")
    return "error of rung 3";
  return input == "exponent" ? "exponent s" : input;
}

/// "contacts 81 %, grain-shear-modulus 12 %": without shares that round to 0.
std::string shares_text(const Answer& answer) {
  std::string text;
  for (const estimate::Share& share : answer.shares())
    if (share.share >= 0.005)
      text +=
          fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", input_text(share.input), 100 * share.share);
  return text.empty() ? "" : "\n  contributions to the range of G: " + text + "\n";
}

std::string preparation_remark(const AnswerCase& c) {
  if (c.question.knows_contacts() || c.question.grain_shape == estimate::GrainShape::sand)
    return "";
  if (c.question.preparation.kind != effective::Preparation::Kind::unknown)
    return fmt::format("  contacts: as in packings of spheres with the preparation {}\n",
                       preparation_text(c.question.preparation));
  return "  preparation unknown: the range covers every number of contacts, from packings prepared with "
         "a friction coefficient of 0.5 to the largest number possible at this void ratio; --preparation, "
         "--rattler-fraction or --mechanical-coordination-number narrows it\n";
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

io::Columns<Answer> answer_columns(bool all, bool strained, const std::string& before) {
  std::vector<Field> usual{Field::shear_modulus, Field::shear_wave_speed, Field::compression_wave_speed,
                           Field::mechanical_coordination_number, Field::stress_exponent};
  if (strained)
    usual.insert(usual.end(), {Field::strained_shear_modulus, Field::modulus_ratio, Field::damping_ratio});
  io::Columns<Answer> columns;
  for (const FieldRow& row : estimate::fields()) {
    if (!all && std::find(usual.begin(), usual.end(), row.field) == usual.end())
      continue;
    const std::string unit(si_symbol(row.dimension));
    for (const auto& [name, part] :
         {std::pair{"answer", &Range::value}, {"low", &Range::low}, {"high", &Range::high}})
      columns.emplace_back(
          fmt::format("{}{}_{}{}{}", before, row.column, name, unit.empty() ? "" : "_", unit), "",
          [field = row.field, part = part](const Answer& answer) {
            const std::optional<Range>& range = answer.find(field);
            return range ? std::optional((*range).*part) : std::nullopt;
          });
  }
  return columns;
}

AnswerCase bare_answer(const InputValues& values, const std::vector<std::string>& uncertainties) {
  estimate::Question question = question_of(values);
  std::vector<estimate::UncertainInput> inputs = uncertain_inputs(values, uncertainties);
  std::optional<estimate::Answer> of_sand;
  double sand_grain_modulus = 0;
  if (!told_shape(values)) {
    try {
      const InputValues sand = as_sand(values);
      const estimate::Question of_grains = question_of(sand);
      of_sand = estimate::answer(of_grains, uncertain_inputs(sand, uncertainties));
      sand_grain_modulus = of_grains.state.law.grain().shear_modulus;
    } catch (const InvalidArgument&) { // a sand cannot be so, but a packing of spheres can
    }
  }
  estimate::Answer answer = estimate::answer(question, inputs);
  return {.question = std::move(question),
          .inputs = std::move(inputs),
          .answer = std::move(answer),
          .sand_answer = std::move(of_sand),
          .sand_grain_modulus = sand_grain_modulus};
}

AnswerCase solve_answer(const InputValues& values, const std::vector<std::string>& uncertainties) {
  AnswerCase c = bare_answer(values, uncertainties);
  add_measured_laws(c);
  for (const estimate::Note& note : notes_of(values, c.question, c.inputs, answer_of_sand(c) != nullptr))
    c.assumptions.push_back(note.sentence());
  return c;
}

namespace {

/// The numbers of an answer, and the contributions to the range of G.
ordered_json fields_json(const Answer& answer) {
  ordered_json json = ordered_json::object();
  for (const FieldRow& row : estimate::fields())
    json[row.key] = json_of(answer.find(row.field));
  json["shares"] = ordered_json::object();
  for (const estimate::Share& share : answer.shares())
    json["shares"][share.input] = share.share;
  return json;
}

} // namespace

ordered_json answer_json(const AnswerCase& c) {
  ordered_json json = fields_json(c.answer);
  json["grain_shape"] = name(c.question.grain_shape);
  json.update({{"preparation", preparation_text(c.question.preparation)},
               {"grain_density", *c.question.grain_density},
               {"saturation", c.question.saturation}});
  json["assumed_deviations"] = ordered_json::object();
  json["stated_deviations"] = ordered_json::object();
  for (const estimate::UncertainInput& input : c.inputs)
    json[input.assumed ? "assumed_deviations" : "stated_deviations"][input.input] = input.deviation;
  json["notes"] = c.assumptions;
  return json;
}

ordered_json sand_answer_json(const AnswerCase& c) {
  if (!c.sand_answer)
    return {};
  ordered_json json = fields_json(*c.sand_answer);
  json["grain_shape"] = name(estimate::GrainShape::sand);
  return json;
}

std::string range_text(const AnswerCase& c) { return shares_text(c.answer) + preparation_remark(c); }

namespace {

/// Both answers, one line each, with their names.
std::string both_text(const AnswerCase& c) {
  using estimate::GrainShape;
  std::string text = "  G of the sand does not depend on the contact, R, G_g, nu_g and fabric above\n"
                     "  the kind of grains is not given; choose with --grain-shape sand or sphere\n";
  for (const auto& [shape, answer] :
       {std::pair{GrainShape::sand, &*c.sand_answer}, {GrainShape::sphere, &c.answer}}) {
    const Range& G = (*answer)[Field::shear_modulus];
    text += fmt::format("  {:<29} G = {} ({} to {})\n", title_of(shape), pressure(G.value), pressure(G.low),
                        pressure(G.high));
  }
  return text + "\n";
}

/// The grains that z* and k/k_H of the sand are of, if they are not those of the spheres.
std::string sand_grains_text(const AnswerCase& c) {
  const double modulus = c.sand_grain_modulus;
  if (modulus == c.question.state.law.grain().shear_modulus || !c.sand_answer->find(Field::contact_softness))
    return "";
  return fmt::format("  z* and k/k_H are for quartz grains of G_g = {}, not for G_g above\n",
                     pressure(modulus));
}

} // namespace

std::string answer_table(const AnswerCase& c) {
  if (!c.sand_answer)
    return fmt::format("{}\n", title_of(c.question.grain_shape)) + moduli_text(c, c.answer) + range_text(c) +
           sands_text(c);
  return both_text(c) + title_of(estimate::GrainShape::sand) + "\n" + moduli_text(c, *c.sand_answer) +
         sand_grains_text(c) + shares_text(*c.sand_answer) + sands_text(c) + "\n" +
         title_of(estimate::GrainShape::sphere) + "\n" + moduli_text(c, c.answer) + range_text(c);
}

} // namespace granum::cli
