// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/implied_coordination.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>

#include "contact_prior_coefficients.hpp"
#include "contact_prior_kernel.hpp"
#include "core/root.hpp"

namespace granum::effective {

namespace {

/// Largest number of neighbours that equal spheres can touch.
constexpr double most_contacts = 12;
/// z* above the isostatic point at which a network counts as just rigid.
constexpr double just_rigid = 1e-9;

double modulus_with(const State& state, double z, std::optional<double> rattlers, Modulus which) {
  const double fraction = rattlers ? *rattlers : expected_rattlers(state, z).fraction;
  return modulus(relaxed(with_contacts(state, z, fraction), z).stiffness, which);
}

void require_growing(Modulus which) {
  if (which == Modulus::K || which == Modulus::G_hh || which == Modulus::G_vh || which == Modulus::C11 ||
      which == Modulus::C33)
    return;
  throw InvalidArgument(
      "a coordination number follows from K, G_hh, G_vh, C11 or C33, which grow with it; the given "
      "modulus may not");
}

} // namespace

ExpectedRattlers expected_rattlers(const State& state, double mechanical_coordination_number) {
  const double z = require_positive("mechanical_coordination_number", mechanical_coordination_number);
  double fraction = 0;
  // Fewer contacts carry larger forces and overlap more: each iteration leaves a small part of the
  // difference.
  for (int round = 0; round < 60; ++round) {
    const State with = with_contacts(state, z, fraction);
    const double overlap = kernel::closing_overlap(with.law, mean_contact_force(with)) /
                           (2 * with.radius * with.contacts.branch);
    const double before = fraction;
    fraction = kernel::rattlers_of_contacts(z, overlap, kernel::rattler_coefficients);
    if (std::abs(fraction - before) <= 1e-15 * fraction)
      break;
  }
  return {.fraction = fraction, .scatter = kernel::rattler_scatter};
}

State with_contacts(State state, double mechanical_coordination_number, double rattler_fraction) {
  const double z = require_non_negative("mechanical_coordination_number", mechanical_coordination_number);
  if (!(rattler_fraction >= 0 && rattler_fraction < 1))
    throw InvalidArgument("rattler_fraction", rattler_fraction, "", "[0, 1)");
  state.coordination_number = z * (1 - rattler_fraction);
  state.mechanical_coordination_number = z;
  return state;
}

ImpliedCoordination implied_coordination(const State& state, Modulus which, double modulus,
                                         std::optional<double> rattler_fraction) {
  require_growing(which);
  require_positive("modulus", modulus, "Pa");
  require_positive("stress_v", state.stress_v, "Pa");
  const double isostatic = isostatic_coordination_number(state.tangential_ratio);
  // In ln(z* - isostatic point) a modulus is nearly a power law, also where it vanishes.
  const auto excess = [&](double logarithm) {
    return std::log(modulus_with(state, isostatic + std::exp(logarithm), rattler_fraction, which) / modulus);
  };
  const double low = std::log(just_rigid), high = std::log(most_contacts - isostatic);
  const double below = excess(low), above = excess(high);
  ImpliedCoordination implied{.mechanical_coordination_number = std::nullopt,
                              .softest = modulus * std::exp(below),
                              .stiffest = modulus * std::exp(above)};
  if (below > 0 || above < 0) {
    implied.explained = below > 0 ? Explained::too_soft : Explained::too_stiff;
    return implied;
  }
  const double at =
      middle(root_between(excess, low, high, below, above, boost::math::tools::eps_tolerance<double>()));
  implied.mechanical_coordination_number = isostatic + std::exp(at);
  return implied;
}

} // namespace granum::effective
