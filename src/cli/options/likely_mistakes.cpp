// SPDX-License-Identifier: GPL-3.0-or-later
#include "likely_mistakes.hpp"

#include <algorithm>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/effective/contact_prior.hpp>

namespace granum::cli {

namespace {

constexpr double kilo = 1e3, mega = 1e6, milli = 1e-3;

/// Sands with shells or mica reach 2; no packing of grains is denser than 0.1, and only wide gradings are
/// denser than 0.4, where porosities lie.
void judge_void_ratio(const PackingOptions& o, const effective::State& state, Validity& validity) {
  constexpr double loosest = 3, densest = 0.1, least_per_cent = 10;
  const double e = state.void_ratio;
  const bool as_porosity = e < 0.40 && e >= 0.25 && !o.sizes;
  if (!o.void_ratio.given() || o.void_ratio.preset || (e <= loosest && e >= densest && !as_porosity))
    return;
  const std::string value = short_text(e);
  if (as_porosity) {
    validity.add(
        fmt::format("--void-ratio {}: denser than sands of one size are; is it a porosity, --porosity {}?",
                    value, value));
    return;
  }
  if (e >= least_per_cent && e < 100)
    validity.add(fmt::format("--void-ratio {}: is it per cent, {}%, or a porosity, --porosity {}%?", value,
                             value, value));
  else
    validity.add(
        fmt::format("--void-ratio {}: {} than any soil of grains; is it a porosity (--porosity), or the "
                    "share of the solid (--solid-fraction)?",
                    value, e > loosest ? "looser" : "denser"));
}

void judge_contacts(const PackingOptions& o, const effective::State& state, Validity& validity) {
  const bool by_z = o.mechanical_coordination_number.given();
  const Number& z = by_z ? o.mechanical_coordination_number : o.coordination_number;
  constexpr double deviations = 3, largest_error = 0.3; // where no packing is so loose the prior's is larger
  if (!z.given() || o.sizes || !(state.void_ratio > 0))
    return;
  const effective::ContactPrior prior =
      effective::contact_prior(state, {.kind = effective::Preparation::Kind::dense});
  const double most = prior.densest.mechanical_coordination_number +
                      deviations * std::min(prior.coordination_error, largest_error);
  constexpr double beside_counts = 1.2, possible = 12; // C_n is often of other codes; beyond 12 others speak
  if (z.value > (by_z ? most : beside_counts * most) && (by_z || z.value <= possible))
    validity.add(
        fmt::format("{} {}: no packing of equal spheres of void ratio {} has so many contacts, {} at most "
                    "at this stress; is it of another packing, or does it count near neighbours?",
                    z.name, short_text(z.value), short_text(state.void_ratio), short_text(most, 2)));
}

void judge_stress(const Number& number, Validity& validity) {
  constexpr double least = 150, most = 100e6; // [Pa]
  const double p = number.value;
  if (!number.given() || p <= 0 || (p >= least && p <= most))
    return;
  const std::string value = pretty(p, number.dimension);
  if (p < least)
    validity.add(fmt::format("{} {} is below the weight of a centimetre of sand; did you mean {}?",
                             number.name, value, pretty(p * kilo, number.dimension)));
  else
    validity.add(fmt::format("{} {}: grains break before that; did you mean {}?", number.name, value,
                             pretty(p / (p > most * kilo ? mega : kilo), number.dimension)));
}

void judge_length(const Number& number, Validity& validity) {
  constexpr double least = 1e-7, most = 0.1; // [m]
  if (!number.given() || number.value <= 0 || (number.value >= least && number.value <= most))
    return;
  const bool large = number.value > most;
  validity.add(fmt::format("{} {}: grains so {} are not sand; did you mean {}?", number.name,
                           pretty(number.value, number.dimension), large ? "large" : "small",
                           pretty(number.value * (large ? milli : kilo), number.dimension)));
}

/// Quartz has 30 to 45 GPa, plastics 1 GPa, diamond 500 GPa.
void judge_modulus(const Number& number, Validity& validity) {
  constexpr double rubber = 10e6, softest = 200e6, hardest = 1e12; // [Pa]
  double meant = number.value;
  if (!number.given() || meant <= 0 || (meant >= softest && meant <= hardest))
    return;
  const std::string kind = meant < rubber    ? "softer than rubber"
                           : meant < softest ? "as soft as rubber"
                                             : "harder than diamond";
  while (meant < softest)
    meant *= kilo;
  while (meant > hardest)
    meant /= kilo;
  if (meant < 1e9 && meant * kilo < hardest)
    meant *= kilo; // 44 kPa: of GPa, not of MPa
  validity.add(fmt::format("{} {}: {}; did you mean {}? Quartz has 30 to 45 GPa", number.name,
                           pretty(number.value, number.dimension), kind, pretty(meant, number.dimension)));
}

} // namespace

Validity likely_mistakes(const PackingOptions& o, const effective::State& state) {
  Validity validity;
  judge_void_ratio(o, state, validity);
  judge_contacts(o, state, validity);
  for (const Number* stress : {&o.pressure, &o.stress_v, &o.stress_h})
    judge_stress(*stress, validity);
  for (const Number* length : {&o.radius, &o.d50})
    judge_length(*length, validity);
  judge_modulus(o.grain_shear_modulus, validity);
  return validity;
}

Validity likely_mistakes(const Number& grain_density) {
  constexpr double lightest = 500, heaviest = 20000; // [kg/m3]: wood, gold
  Validity validity;
  const double density = grain_density.value;
  if (!grain_density.given() || (density >= lightest && density <= heaviest))
    return validity;
  const double meant = density < lightest ? density * kilo : density / kilo;
  validity.add(fmt::format("{} {}: no mineral has it; did you mean {}?", grain_density.name,
                           pretty(density, Dimension::density), pretty(meant, Dimension::density)));
  return validity;
}

namespace {

Number key_of_scene(const char* name, double value, Dimension dimension) {
  Number number{value, dimension};
  number.name = name;
  number.in_table = true;
  return number;
}

} // namespace

Validity likely_mistakes(const studies::Scene& scene) {
  Validity validity;
  judge_length(key_of_scene("grain.radius", scene.grain.radius, Dimension::length), validity);
  judge_modulus(key_of_scene("grain.shear_modulus", scene.grain.shear_modulus, Dimension::pressure),
                validity);
  validity.merge(likely_mistakes(key_of_scene("grain.density", scene.grain.density, Dimension::density)));
  for (const double pressure : scene.study.pressures) {
    const std::size_t before = validity.notes.size();
    judge_stress(key_of_scene("study.pressures", pressure, Dimension::pressure), validity);
    if (validity.notes.size() > before)
      break; // the others are of the same unit
  }
  return validity;
}

double require_share(const Number& number, double most) {
  if (!(number.value >= 0 && number.value <= most))
    number.refuse_share(fmt::format("[0, {}]", short_text(most)), most);
  return number.value;
}

} // namespace granum::cli
