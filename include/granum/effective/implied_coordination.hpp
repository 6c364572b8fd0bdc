// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/state.hpp>

/// The inverse of rung 3: the number of contacts at which a packing has the measured stiffness.
namespace granum::effective {

/// Fraction of rattlers, the grains that carry no force, in granum's own packings of the same z*.
struct ExpectedRattlers {
  double fraction = 0; ///< x_0 in [0, 1) [1]
  double scatter = 0;  ///< standard deviation of ln x_0 between packings
};

/// Rattlers of a packing of z*. Their fraction decreases with z* and with the overlap.
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

/// The coordination number that follows from a modulus.
struct ImpliedCoordination {
  Explained explained = Explained::yes;
  std::optional<double> mechanical_coordination_number; ///< z*; empty if no coordination number fits
  double softest = 0;  ///< the modulus at the isostatic point, above which packings are rigid [Pa]
  double stiffest = 0; ///< that with 12 contacts [Pa]
};

/// The z* at which relaxed() has this modulus. The moduli allowed here grow with z*, so there is one
/// solution or none.
/// Assumes   as relaxed; e, contact law, fabric and stresses of the state apply to the measurement
/// \param    state     its coordination number is not used
/// \param    which     K, G_hh, G_vh, C11 or C33
/// \param    modulus   as measured, > 0 [Pa]
/// \param    rattler_fraction   x_0, if known; else that of expected_rattlers
/// \throws   InvalidArgument as relaxed; for another modulus; without stress
/// Accuracy  round trip relative 1e-10; inverse::infer adds the error of the calibration.
/// Checked by tests/effective/test_implied_coordination.cpp
[[nodiscard]] ImpliedCoordination implied_coordination(const State& state, Modulus which, double modulus,
                                                       std::optional<double> rattler_fraction = std::nullopt);

} // namespace granum::effective
