// SPDX-License-Identifier: GPL-3.0-or-later
#include "slips.hpp"

#include <algorithm>

#include <granum/core/text.hpp>
#include <granum/effective/contact_prior.hpp>

namespace granum::cli {

namespace {

constexpr double kilo = 1e3, mega = 1e6, milli = 1e-3;

std::string meant_text(const Typed& number, double meant) {
  return "did you mean " + pretty(meant, number.dimension) + "?";
}

std::string typed_text(const Typed& number) {
  return number.name + " " + pretty(number.value, number.dimension);
}

} // namespace

void judge_void_ratio(const Typed& number, bool unequal, Validity& validity) {
  constexpr double loosest = 3, densest = 0.1, least_per_cent = 10;
  const double e = number.value;
  const bool as_porosity = e < 0.40 && e >= 0.25 && !unequal;
  if (e <= loosest && e >= densest && !as_porosity)
    return;
  const std::string value = short_text(e), typed = number.name + " " + value + ": ";
  if (as_porosity)
    validity.add(typed + "denser than sands of one size are; is it a porosity, --porosity " + value + "?");
  else if (e >= least_per_cent && e < 100)
    validity.add(typed + "is it per cent, " + value + "%, or a porosity, --porosity " + value + "%?");
  else
    validity.add(typed + (e > loosest ? "looser" : "denser") +
                 " than any soil of grains; is it a porosity (--porosity), or the share of the solid "
                 "(--solid-fraction)?");
}

void judge_contacts(const Typed& number, bool without_rattlers, const effective::State& state,
                    Validity& validity) {
  constexpr double deviations = 3, largest_error = 0.3; // larger in the prior where no packing is so loose
  if (!(state.void_ratio > 0))
    return;
  const effective::ContactPrior prior =
      effective::contact_prior(state, {.kind = effective::Preparation::Kind::dense});
  const double most = prior.densest.mechanical_coordination_number +
                      deviations * std::min(prior.coordination_error, largest_error);
  constexpr double beside_counts = 1.2,
                   possible = 12; // C_n often comes from other codes; beyond 12 there is another message
  const double z = number.value;
  if (z > (without_rattlers ? most : beside_counts * most) && (without_rattlers || z <= possible))
    validity.add(number.name + " " + short_text(z) + ": no packing of equal spheres of void ratio " +
                 short_text(state.void_ratio) + " has so many contacts, " + short_text(most, 2) +
                 " at most at this stress; does it belong to another packing, or include near neighbours?");
}

void judge_stress(const Typed& number, Validity& validity) {
  constexpr double least = 150, most = 100e6; // [Pa]
  const double p = number.value;
  if (p <= 0 || (p >= least && p <= most))
    return;
  if (p < least)
    validity.add(typed_text(number) + " is below the weight of a centimetre of sand; " +
                 meant_text(number, p * kilo));
  else
    validity.add(typed_text(number) + ": grains break at smaller stresses; " +
                 meant_text(number, p / (p > most * kilo ? mega : kilo)));
}

void judge_length(const Typed& number, Validity& validity) {
  constexpr double least = 1e-7, most = 0.1; // [m]
  if (number.value <= 0 || (number.value >= least && number.value <= most))
    return;
  const bool large = number.value > most;
  validity.add(typed_text(number) + ": grains so " + (large ? "large" : "small") + " are not sand; " +
               meant_text(number, number.value * (large ? milli : kilo)));
}

void judge_modulus(const Typed& number, Validity& validity) {
  constexpr double rubber = 10e6, softest = 200e6, hardest = 1e12; // [Pa]
  double meant = number.value;
  if (meant <= 0 || (meant >= softest && meant <= hardest))
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
  validity.add(typed_text(number) + ": " + kind + "; " + meant_text(number, meant) +
               " Quartz has 30 to 45 GPa");
}

void judge_density(const Typed& number, Validity& validity) {
  constexpr double lightest = 500, heaviest = 20000; // [kg/m3]: wood, gold
  const double density = number.value;
  if (density >= lightest && density <= heaviest)
    return;
  validity.add(typed_text(number) + ": no mineral has this density; " +
               meant_text(number, density < lightest ? density * kilo : density / kilo));
}

} // namespace granum::cli
