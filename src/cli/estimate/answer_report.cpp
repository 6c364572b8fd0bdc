// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

namespace granum::cli {

namespace {

using effective::PackingAnswer;
using effective::Range;
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
std::vector<std::string> with_spreads(std::vector<std::string> notes, const std::vector<Spread>& spreads) {
  for (const Spread& spread : spreads)
    for (std::string& note : notes) {
      const std::string begin = "assumed --" + spread.key + " ";
      if (spread.assumed && note.starts_with(begin)) {
        const std::size_t end = std::min(note.find(','), note.size());
        note.insert(end, " +- " + spread.text);
      }
    }
  return notes;
}

bool anisotropic(const effective::PackingQuestion& q) {
  return q.state.stress_v != q.state.stress_h || q.state.fabric_anisotropy != 0;
}

bool counted(const effective::PackingQuestion& q) {
  return q.coordination_number || q.mechanical_coordination_number || q.rattler_fraction;
}

ordered_json json_of(const Range& range) {
  return {{"value", range.value}, {"low", range.low}, {"high", range.high}};
}
ordered_json json_of(const std::optional<Range>& range) { return range ? json_of(*range) : ordered_json(); }

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
std::string speed(double value) { return short_text(value, 4) + " m/s"; }
std::string number(double value) { return short_text(value, 3); }
std::string density(double value) { return short_text(value, 4) + " kg/m3"; }

std::string line(const char* label, const Range& range, std::string (*text)(double),
                 const std::string& meaning) {
  return fmt::format("  {:<8}{:>12}{:>14}{:>14}   {}\n", label, text(range.value), text(range.low),
                     text(range.high), meaning);
}

std::string moduli_text(const AnswerCase& c) {
  const PackingAnswer& a = c.answer;
  const bool wet = c.question.saturation > 0, by_direction = anisotropic(c.question);
  const std::string pores =
      wet ? fmt::format("{} % of the pores water", short_text(100 * c.question.saturation, 3)) : "dry";
  std::string text = fmt::format("  {:<8}{:>12}{:>14}{:>14}\n", "", "answer", "low", "high");
  text += line(by_direction ? "G_vh" : "G", a.shear_modulus, pressure,
               by_direction ? "shear modulus, vertical plane" : "shear modulus");
  text += line("V_s", *a.shear_wave_speed, speed, by_direction ? "shear wave, vertical" : "shear wave");
  text += line("V_p", *a.compression_wave_speed, speed,
               (by_direction ? "compression wave, vertical" : "compression wave") +
                   std::string(wet ? "; Gassmann" : ""));
  text += line("K", a.bulk_modulus, pressure, wet ? "bulk modulus, drained" : "bulk modulus");
  text += line(by_direction ? "E_v" : "E", a.young_modulus, pressure,
               std::string(by_direction ? "Young's modulus, vertical" : "Young's modulus") +
                   (wet ? ", drained" : ""));
  text += line(by_direction ? "nu_vh" : "nu", a.poisson_ratio, number,
               std::string("Poisson's ratio") + (wet ? ", drained" : ""));
  if (by_direction) {
    text += line("G_hh", a.G_hh, pressure, "shear modulus, horizontal plane");
    text += line("V_s,h", *a.horizontal_shear_wave_speed, speed, "shear wave in the horizontal plane");
    text += line("V_p,h", *a.horizontal_compression_wave_speed, speed, "compression wave, horizontal");
    text += line("E_h", a.horizontal_young_modulus, pressure, "Young's modulus, horizontal");
  }
  text += line("density", *a.bulk_density, density, pores);
  text += line("z*", a.mechanical_coordination_number, number, "contacts of a grain that bears load");
  return text;
}

/// "contacts 81 %, grain-shear-modulus 12 %": without what rounds to nothing.
std::string shares_text(const PackingAnswer& answer) {
  std::string text;
  for (const effective::Share& share : answer.shares)
    if (share.share >= 0.005)
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", share.input, 100 * share.share);
  return text.empty() ? "" : "\n  the range of G: " + text + "\n";
}

std::string preparation_remark(const AnswerCase& c) {
  if (counted(c.question))
    return "";
  if (c.question.preparation.kind != effective::Preparation::Kind::unknown)
    return fmt::format("  contacts of the preparation {}, as sphere packings have them\n",
                       preparation_text(c.question.preparation));
  return "  how the grains came together is not known: from friction 0.5 to the densest contacts of\n"
         "  this void ratio; --preparation, --rattler-fraction or --mechanical-coordination-number narrow "
         "it\n";
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
                  short_text(s.void_ratio), pressure((s.stress_v + 2 * s.stress_h) / 3),
                  short_text(c.uniformity), c.uniformity_assumed ? " assumed" : "");
  for (const SandAnswer& sand : c.sands)
    text += fmt::format("    {:<26}{:>12}   {}{}\n", sand.law->key,
                        sand.modulus ? pressure(sand.modulus->shear_modulus) : "none", sand.law->sand,
                        sand.modulus && sand.modulus->validity.ok() ? "" : " (not tested here)");
  return text + "    " + comparison_text(c.answer.shear_modulus, c.sands);
}

} // namespace

AnswerCase bare_answer(const PackingOptions& packing, const AnswerOptions& options,
                       const std::vector<std::string>& uncertainties) {
  AnswerCase c{.question = question_of(packing, options),
               .spreads = spreads_of(packing, options, uncertainties),
               .answer = {},
               .sands = {},
               .assumptions = {}};
  c.answer = answer_with_spreads(packing, options, c.spreads);
  return c;
}

AnswerCase solve_answer(const PackingOptions& packing, const AnswerOptions& options,
                        const std::vector<std::string>& uncertainties) {
  AnswerCase c = bare_answer(packing, options, uncertainties);
  const auto& s = c.question.state;
  const std::optional<double> of_sand = options.sand != nullptr ? options.sand->uniformity : std::nullopt;
  c.uniformity =
      packing.sizes ? sizes::gradation(*packing.sizes, 1).uniformity() : of_sand.value_or(uniform_sand);
  c.uniformity_assumed = !packing.sizes && !of_sand;
  c.sands = measured_sands({.void_ratio = s.void_ratio,
                            .mean_stress = (s.stress_v + 2 * s.stress_h) / 3,
                            .uniformity = c.uniformity});
  c.assumptions = assumed_grains(packing, s);
  if (!options.grain_density.given())
    c.assumptions.push_back(
        fmt::format("assumed --grain-density {}", pretty(options.grain_density.value, Dimension::density)));
  c.assumptions = with_spreads(std::move(c.assumptions), c.spreads);
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
  const PackingAnswer& a = c.answer;
  ordered_json json = {{"shear_modulus", json_of(a.shear_modulus)},
                       {"shear_wave_speed", json_of(a.shear_wave_speed)},
                       {"compression_wave_speed", json_of(a.compression_wave_speed)},
                       {"bulk_modulus", json_of(a.bulk_modulus)},
                       {"young_modulus", json_of(a.young_modulus)},
                       {"poisson_ratio", json_of(a.poisson_ratio)},
                       {"horizontal_shear_modulus", json_of(a.G_hh)},
                       {"horizontal_shear_wave_speed", json_of(a.horizontal_shear_wave_speed)},
                       {"horizontal_compression_wave_speed", json_of(a.horizontal_compression_wave_speed)},
                       {"horizontal_young_modulus", json_of(a.horizontal_young_modulus)},
                       {"bulk_density", json_of(a.bulk_density)},
                       {"mechanical_coordination_number", json_of(a.mechanical_coordination_number)},
                       {"rattler_fraction", json_of(a.rattler_fraction)},
                       {"coordination_number", json_of(a.coordination_number)},
                       {"preparation", preparation_text(c.question.preparation)},
                       {"grain_density", *c.question.grain_density},
                       {"saturation", c.question.saturation}};
  json["shares"] = ordered_json::object();
  for (const effective::Share& share : a.shares)
    json["shares"][share.input] = share.share;
  json["assumed_deviations"] = ordered_json::object();
  for (const Spread& spread : c.spreads)
    if (spread.assumed)
      json["assumed_deviations"][spread.key] = spread.deviation;
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
