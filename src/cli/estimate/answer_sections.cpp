// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_sections.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <granum/core/text.hpp>
#include <granum/sands/strain.hpp>

#include "cli/options/packing_json.hpp"

namespace granum::cli {

using estimate::Answer;
using estimate::Field;
using estimate::FieldRow;
using estimate::GrainShape;
using estimate::Question;
using estimate::Range;

const char* title_of(GrainShape shape) {
  return shape == GrainShape::sand ? "sand (measured laws)" : "beads (spheres of the model)";
}

namespace {

bool differs_by_direction(const Question& q) {
  return q.state.stress_v != q.state.stress_h || q.state.fabric_anisotropy != 0;
}

/// Whether a number is on the first screen: G, wave speeds and K; and what a strain adds, or else directions,
/// or else E, nu and s.
bool is_first(Field field, const Question& q) {
  constexpr Field usual[] = {Field::shear_modulus, Field::shear_wave_speed, Field::compression_wave_speed,
                             Field::bulk_modulus};
  constexpr Field strained[] = {Field::strained_shear_modulus, Field::modulus_ratio, Field::damping_ratio};
  constexpr Field directed[] = {Field::horizontal_shear_modulus, Field::vertical_exponent,
                                Field::horizontal_exponent};
  constexpr Field isotropic[] = {Field::young_modulus, Field::poisson_ratio, Field::stress_exponent};
  const std::span<const Field> more = q.shear_strain            ? std::span<const Field>(strained)
                                      : differs_by_direction(q) ? std::span<const Field>(directed)
                                                                : std::span<const Field>(isotropic);
  const auto has = [field](std::span<const Field> fields) {
    return std::ranges::find(fields, field) != fields.end();
  };
  return has(usual) || has(more);
}

Ranges ranges_of(const Answer& answer, const Question& q, const char* key, const char* before) {
  Ranges ranges{.key = key, .title = title_of(answer.grain_shape()), .before = before};
  const bool directed = differs_by_direction(q);
  for (const FieldRow& row : estimate::fields()) {
    const bool shown = row.shown != estimate::Shown::by_direction || directed;
    ranges.rows.push_back({.key = row.key,
                           .symbol = directed ? row.directed_symbol : row.symbol,
                           .heading = row.column,
                           .meaning = std::string(directed ? row.directed_meaning : row.meaning) +
                                      (q.saturation > 0 ? row.in_water : ""),
                           .dimension = row.dimension,
                           .seen = is_first(row.field, q) ? Seen::always
                                   : shown                ? Seen::full
                                                          : Seen::data,
                           .range = answer.find(row.field)});
  }
  return ranges;
}

std::string preparation_text(const effective::Preparation& preparation) {
  switch (preparation.kind) {
  case effective::Preparation::Kind::dense: {
    std::string pressure =
        preparation.pressure > 0 ? ":" + pretty(preparation.pressure, Dimension::pressure) : "";
    std::erase(pressure, ' ');
    return "dense" + pressure;
  }
  case effective::Preparation::Kind::loose:
    return "loose";
  case effective::Preparation::Kind::friction:
    return "friction:" + short_text(preparation.friction_coefficient);
  default:
    return "unknown";
  }
}

/// The name of an input in a sentence; JSON has its key.
std::string_view input_text(std::string_view input) {
  if (input == "sand to sand")
    return "differences between sands";
  if (input == "rung 3")
    return "error of rung 3";
  return input == "exponent" ? "exponent s" : input;
}

std::string share_text(const estimate::Share& share) {
  return fmt::format("{} {:.0f} %", input_text(share.input), 100 * share.share);
}

/// An answer, and below it what its range is made of.
/// \param    remark   further line; may be empty
void add_one_answer(Document& to, const Answer& answer, const AnswerCase& c, const char* key,
                    const char* before, const std::string& remark) {
  to.add(Seen::full, ranges_of(answer, c.question, key, before));
  Prose prose;
  if (const std::string shares = shares_text(answer); !shares.empty())
    prose.lines.push_back("contributions to the range of G: " + shares);
  if (!remark.empty())
    prose.lines.push_back(remark);
  to.add(Seen::full, std::move(prose));
  Items shares{.key = std::string(key) + "/shares"}, about{.key = key};
  for (const estimate::Share& share : answer.shares())
    io::add_item(shares.items, share.input, share.share);
  io::add_item(about.items, "grain_shape", name(answer.grain_shape()));
  to.add(Seen::data, std::move(shares));
  to.add(Seen::data, std::move(about));
}

/// What the answer was computed with besides the packing.
void add_basis(Document& to, const AnswerCase& c) {
  Items about{.key = "answer"}, assumed{.key = "answer/assumed_deviations"},
      stated{.key = "answer/stated_deviations"};
  io::add_item(about.items, "preparation", preparation_text(c.question.preparation));
  io::add_item(about.items, "grain_density", c.question.grain_density);
  io::add_item(about.items, "saturation", c.question.saturation);
  for (const estimate::UncertainInput& input : c.inputs)
    io::add_item((input.assumed ? assumed : stated).items, input.input, input.deviation);
  for (Items* items : {&about, &assumed, &stated})
    to.add(Seen::data, std::move(*items));
}

/// Which inputs are not for the sand, and the grains that its z* and k/k_H are of, if they are others.
std::string sand_remark(const AnswerCase& c) {
  const bool other_grains = c.sand_grain_modulus != c.question.state.law.grain().shear_modulus &&
                            c.sand_answer->find(Field::contact_softness);
  return "The contact, R, G_g, nu_g and a above are for the beads only" +
         (other_grains ? fmt::format("; z* and k/k_H are for quartz grains of G_g = {}.",
                                     pretty(c.sand_grain_modulus, Dimension::pressure))
                       : ".");
}

} // namespace

std::string shares_text(const Answer& answer) {
  std::string text;
  for (const estimate::Share& share : answer.shares())
    if (share.share >= 0.005)
      text += (text.empty() ? "" : ", ") + share_text(share);
  return text;
}

/// Whether it is the name of an option; other shares are of the model.
bool is_input(const std::string& share) {
  const auto rows = estimate::uncertain_rows();
  return std::any_of(rows.begin(), rows.end(),
                     [&](const estimate::InputRow* const row) { return key_of(*row) == share; });
}

std::string largest_share(const Answer& answer, const Question& q) {
  const std::vector<estimate::Share> shares = answer.shares();
  if (shares.empty())
    return "";
  const std::string& input = shares.front().input;
  const std::string options = input == "contacts" ? ": --preparation, --rattler-fraction"
                              : input == "sand to sand"
                                  ? (q.sand.tests ? ": granum infer" : ": --sand, granum infer")
                              : answer.assumes(input) && is_input(input) ? ": --" + input
                                                                         : "";
  return share_text(shares.front()) + options;
}

std::string preparation_remark(const Question& q) {
  if (q.knows_contacts() || q.grain_shape == GrainShape::sand)
    return "";
  const double densest = q.preparation.densest_void_ratio;
  const std::string by_densest =
      densest > 0 ? fmt::format("; z* is estimated from the void ratio above {}, that of the "
                                "same grains packed without friction",
                                short_text(densest))
                  : "";
  if (q.preparation.kind != effective::Preparation::Kind::unknown)
    return "contacts: as in packings of spheres with the preparation " + preparation_text(q.preparation) +
           by_densest;
  return "The range is wide because the number of contacts is unknown: it reaches from packings prepared "
         "with "
         "a friction coefficient of 0.5 to the largest number possible at this void ratio" +
         by_densest + ". --preparation, --rattler-fraction or --mechanical-coordination-number narrows it.";
}

void add_packing(Document& to, const InputValues& values, const effective::State& state, bool sand_beside) {
  to.add(Seen::data, Data{"inputs", packing_json(values, state)});
  if (sand_beside)
    to.add(Seen::data, Data{"sand_inputs", packing_json(as_sand(values), state)});
}

void add_answers(Document& to, const AnswerCase& c) {
  if (c.sand_answer)
    add_one_answer(to, *c.sand_answer, c, "sand_answer", "sand_", sand_remark(c));
  else
    to.add(Seen::data, Ranges{.key = "sand_answer"});
  add_one_answer(to, c.answer, c, "answer", "", preparation_remark(c.question));
  add_basis(to, c);
}

namespace {

/// "sands by these laws are 2.4 times stiffer than these spheres".
std::string comparison_text(const AnswerCase& c) {
  constexpr double alike = 1.25;
  const std::optional<Range> laws = range_of_laws(c, laws_tested(c));
  const double G = c.answer[Field::shear_modulus].value;
  if (c.question.grain_shape == GrainShape::sand || !laws || !(G > 0) || !std::isfinite(laws->value / G) ||
      !std::isfinite(G / laws->value))
    return "";
  const double ratio = laws->value / G;
  if (ratio <= alike && ratio >= 1 / alike)
    return "sands by these laws and these spheres are equally stiff, within 25 %";
  return fmt::format("sands by these laws are {} times {} than these spheres",
                     short_text(ratio > 1 ? ratio : 1 / ratio, 2), ratio > 1 ? "stiffer" : "softer");
}

} // namespace

Table measured_laws_table(const AnswerCase& c) {
  const auto& s = c.question.state;
  const io::Columns<SandAnswer> columns = {
      {"", "law", [](const SandAnswer& of) { return of.law->key; }, shown_as("law", {}, -26)},
      {"", "sand", [](const SandAnswer& of) { return of.law->sand; }},
      {"", "source", [](const SandAnswer& of) { return of.law->source; }},
      {"", "formula", [](const SandAnswer& of) { return of.law->formula; }},
      {"", "rms_log10", [](const SandAnswer& of) { return of.law->record.rms_log10; }},
      {"", "shear_modulus", io::or_null([](const SandAnswer& of) {
         return of.modulus ? std::optional(of.modulus->shear_modulus) : std::nullopt;
       }),
       shown_as("G", Dimension::pressure, 11)},
      {"", "bias", [](const SandAnswer& of) { return of.law->record.bias; },
       io::ShownColumn{.heading = "bias", .width = 6, .digits = 2, .fixed = true}},
      {"", "",
       [](const SandAnswer& of) {
         return fmt::format(" {}{}", of.law->sand, of.tested() ? "" : " (outside its tests)");
       },
       shown_as(" sand", {}, -1)},
      {"", "notes", [](const SandAnswer& of) {
         return of.modulus ? of.modulus->validity.notes : std::vector<std::string>();
       }}};
  Table laws = table_of(
      "measured_sands",
      fmt::format("G of published laws at e = {}, p' = {}, C_u = {}{}; bias: mean ratio of calculated to "
                  "measured G in 166 tests of 23 clean sands",
                  short_text(s.void_ratio), pretty(s.mean_stress(), Dimension::pressure),
                  short_text(c.uniformity), c.uniformity_assumed ? " assumed" : ""),
      columns, c.sands);
  laws.remark = comparison_text(c);
  return laws;
}

Table strain_laws_table(const AnswerCase& c) {
  const Question& q = c.question;
  using sands::StrainLaw;
  const auto ratio = [&q](const StrainLaw& law) {
    return law.ratio({.strain = *q.shear_strain,
                      .void_ratio = q.state.void_ratio,
                      .mean_stress = q.state.mean_stress(),
                      .sand = q.sand});
  };
  const io::Columns<StrainLaw> columns = {
      {"", "law", &StrainLaw::key, shown_as("law", {}, -26)},
      {"", "formula", &StrainLaw::formula},
      {"", "modulus_ratio", ratio, io::ShownColumn{.heading = "G/G0", .width = 11, .digits = 3}},
      {"", "source", &StrainLaw::source, shown_as("source", {}, 24)}};
  const bool strained = q.shear_strain && q.state.mean_stress() > 0 && c.of_sand() != nullptr;
  const std::span<const StrainLaw> laws = sands::strain_laws();
  return table_of(
      "strain_laws",
      fmt::format("G/G0 of published laws at a shear strain of {}; small strain is 0.001 % and less",
                  percent_text(q.shear_strain.value_or(0))),
      columns, strained ? std::vector(laws.begin(), laws.end()) : std::vector<StrainLaw>());
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

std::vector<double> spread(double first, double last, std::size_t n, bool logarithmic) {
  std::vector<double> values;
  for (std::size_t k = 0; k < n; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(n - 1);
    values.push_back(logarithmic ? first * std::pow(last / first, share) : first + (last - first) * share);
  }
  values.back() = last;
  return values;
}

void add_band(plot::Chart& chart, const Band& band, bool sideways, const std::string& name,
              plot::Colour colour) {
  plot::Series line{.name = name, .mark = plot::Mark::line, .style = 0, .colour = colour};
  plot::Series area{.name = name == "answer" ? "range" : name + ", range",
                    .mark = plot::Mark::area,
                    .style = 0,
                    .colour = colour};
  const auto put = [sideways](plot::Series& series, double at, double number) {
    series.add(sideways ? number : at, sideways ? at : number);
  };
  for (std::size_t k = 0; k < band.at.size(); ++k) {
    put(line, band.at[k], band.ranges[k].value);
    put(area, band.at[k], band.ranges[k].low);
  }
  for (std::size_t k = band.at.size(); k-- > 0;)
    put(area, band.at[k], band.ranges[k].high);
  chart.series.push_back(std::move(area));
  chart.series.push_back(std::move(line));
}

} // namespace granum::cli
