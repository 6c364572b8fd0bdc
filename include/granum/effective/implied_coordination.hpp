// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/state.hpp>

/// The inverse of rung 3: how many contacts a packing must have to be as stiff as it was measured.
namespace granum::effective {

/// Share of grains that carry no force, as own packings of that z* have it.
struct ExpectedRattlers {
  double fraction = 0; ///< x_0 in [0, 1) [1]
  double scatter = 0;  ///< standard deviation of ln x_0 of packings
};

/// Rattlers of a packing of z*: the fewer, the more contacts there are and the larger the overlaps.
/// \param    state   its coordination number is not used
/// \throws   InvalidArgument as require_valid(State), and unless z* > 0
/// Accuracy  its scatter; see validation/contact_prior.
/// Checked by tests/effective/test_implied_coordination.cpp
[[nodiscard]] ExpectedRattlers expected_rattlers(const State& state, double mechanical_coordination_number);

/// The state with z* and C_n = z* (1 - x_0).
/// \throws   InvalidArgument unless z* >= 0 and x_0 is in [0, 1)
[[nodiscard]] State with_contacts(State state, double mechanical_coordination_number,
                                  double rattler_fraction);

enum class Explained {
  yes,
  too_soft, ///< softer than the loosest rigid network of contacts
  too_stiff ///< stiffer than with 12 contacts, the most that equal spheres can have
};

/// What a modulus says of the contacts.
struct ImpliedCoordination {
  Explained explained = Explained::yes;
  std::optional<double> mechanical_coordination_number; ///< z*; nothing where no number explains it
  double softest = 0;  ///< the modulus at the isostatic point, above which packings are rigid [Pa]
  double stiffest = 0; ///< that with 12 contacts [Pa]
};

/// The z* at which relaxed() has this modulus. Every modulus that may be asked
/// for grows with z*, so that there is one or none.
/// Assumes   as relaxed; e, contact law, fabric and stresses of the state are those of the measurement
/// \param    state     its coordination number is not used
/// \param    which     K, G_hh, G_vh, C11 or C33
/// \param    modulus   as measured, > 0 [Pa]
/// \param    rattler_fraction   x_0, where it is known; else that of expected_rattlers
/// \throws   InvalidArgument as relaxed; for another modulus; without stress
/// Accuracy  round trip relative 1e-10; what the calibration leaves open is the matter of inverse::infer.
/// Checked by tests/effective/test_implied_coordination.cpp
[[nodiscard]] ImpliedCoordination implied_coordination(const State& state, Modulus which, double modulus,
                                                       std::optional<double> rattler_fraction = std::nullopt);

} // namespace granum::effective
