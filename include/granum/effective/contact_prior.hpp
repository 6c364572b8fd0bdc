// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <granum/core/error.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/state.hpp>

/// The possible number of contacts of a packing if only void ratio and stress are known: from that of grains
/// prepared with much friction to the largest that this void ratio allows. Calibrated on granum's own
/// packings; for the fit and its errors see validation/contact_prior.
namespace granum::effective {

/// The number of load-bearing contacts and the fraction of grains without load.
struct ContactCounts {
  double mechanical_coordination_number = State::unset; ///< z* >= 0, without rattlers [1]
  double rattler_fraction = State::unset;               ///< x_0 in [0, 1) [1]

  /// C_n = z* (1 - x_0), over all grains [1].
  [[nodiscard]] double coordination_number() const {
    return mechanical_coordination_number * (1 - rattler_fraction);
  }
};

/// How the grains were brought together, as far as it determines the number of contacts.
struct Preparation {
  enum class Kind {
    unknown,
    dense,   ///< as if frictionless: the most contacts possible at the void ratio
    loose,   ///< compressed with the friction of minerals, 0.3 to 0.5
    friction ///< compressed with the friction coefficient below
  };
  Kind kind = Kind::unknown;
  double friction_coefficient = 0; ///< tangent of the interparticle friction angle, > 0, for Kind::friction
  /// For Kind::dense: up to which grains were compressed without friction, in (0, p] [Pa]; 0 if unknown. Rung
  /// 3 is more accurate with it (dense_unevenness).
  double pressure = 0;
  /// Void ratio of the densest disordered packing of the same grains, compressed without friction to the
  /// pressure above, or to 10 kPa: 0.57 of equal spheres, in specimens of few grains more, of unequal grains
  /// less. 0 if unknown.
  double densest_void_ratio = 0;

  bool operator==(const Preparation&) const = default;
};

/// "dense", "dense:10kPa", "loose", or "friction:0.3".
/// \throws   InvalidArgument for another text, or a pressure or coefficient that is not positive
/// Checked by tests/effective/test_contact_prior.cpp
[[nodiscard]] Preparation preparation_of(std::string_view text);

/// Refuses a preparation that no packing of the state can have had.
/// \throws   InvalidArgument for a pressure of preparation above the mean stress, unless that is 0: a packing
///           that was unloaded has other forces; for the void ratio of a densest packing below 0.5 (0.2 of
///           unequal grains), or above that of the state by more than overlaps explain
/// Checked by tests/effective/test_contact_prior.cpp
void require_valid(const Preparation& preparation, const State& state);

/// The contacts that a packing may have.
struct ContactPrior {
  ContactCounts loosest; ///< the fewest contacts
  ContactCounts middle;  ///< half way, by z*
  ContactCounts densest; ///< the most
  /// Standard deviation of z* about each of the three; larger where no packing of spheres exists [1].
  double coordination_error = 0;
  double packing_scatter = 0; ///< the same, where packings of spheres exist [1]
  double rattler_error = 0;   ///< standard deviation of ln x_0 [1]
  /// Overlap at the mean force over the diameter, for `middle`: determines how z* grows with stress. Of rough
  /// spheres that of smooth ones under the same force, as what roughness adds makes no counted contacts [1].
  double relative_overlap = 0;
  Validity validity;
};

/// Contacts of a packing of that void ratio and mean stress.
/// Friction both keeps grains apart and lets them rest on fewer contacts. Grains compressed from a gas reach
/// the densest line, where each void ratio has its friction and its z*. If they are then shaken or tapped
/// denser, they keep the few contacts of their friction. Without a given preparation the range extends from
/// friction 0.5, the largest of smooth minerals, to the densest line. If the friction is too small for the
/// void ratio, the densest line is taken too. At one preparation and pressure a denser packing is never
/// softer. Unequal grains pack denser: for them the line is an upper bound, and many more are rattlers.
/// Where the densest packing of the same grains is known, 1 + e is taken over its own: the void ratios above
/// are those of equal spheres, whose densest has 0.569. Then the shape of the contacts and the sizes of the
/// grains shift z* of packings compressed with friction by 0.060 - 0.141 b - 0.44 sqrt(v), v the relative
/// variance of branches. A void ratio above 0.58 is none of a densest packing of spheres, with a note.
/// Assumes   equal spheres, isotropic stress that has not been larger before, no cement.
/// \param    state         law, radius, void_ratio, stresses and contacts; its coordination number is not
///                         used
/// \return   notes where no packing of equal spheres is so loose or so dense, where friction is too small
///           for the void ratio, of unequal grains, and where overlaps exceed those of the calibration
/// \throws   InvalidArgument naming a member of the state or of the preparation that is out of its range, and
///           as require_valid of both
/// Accuracy  of recipes left out of the fit, and of rough spheres, see validation/contact_prior; relative
///           overlaps below 0.01. Rounding: relative 1e-12.
/// Checked by tests/effective/test_contact_prior.cpp, validation/contact_prior
[[nodiscard]] ContactPrior contact_prior(const State& state, const Preparation& preparation = {});

/// x_0 of packings of z*, according to the fit of the prior.
/// \param    mechanical_coordination_number   z* >= 0 [1]
/// \param    relative_overlap                 as in ContactPrior, >= 0 [1]
/// \return   limited to 0.9; the fit exceeds it at z* far below the isostatic point
/// \throws   InvalidArgument outside of these ranges
/// Accuracy  of equal grains within a factor of 1.3 (one standard deviation).
///           Checked by tests/effective/test_contact_prior.cpp, validation/contact_prior
[[nodiscard]] double typical_rattler_fraction(double mechanical_coordination_number, double relative_overlap);

/// Contacts of the same packing at another mean stress than the one where they are known.
struct CarriedContacts {
  ContactCounts counts;
  double void_ratio = 0;       ///< changed by the overlaps [1]
  double relative_overlap = 0; ///< as in ContactPrior [1]
  /// Standard deviation of z* due to the change of stress: 0 if nothing changes, and proportional to the
  /// square root of the change of the square root of the overlap [1]
  double coordination_error = 0;
  Validity validity;
};

/// Change of z* and rattlers of one packing with pressure: overlaps close gaps between grains. The square
/// root of the difference between z* and its value on the densest line decreases linearly with the square
/// root of the overlap: fast in packings slightly looser than the densest, slowly in those compressed with
/// friction from a gas, with a rate that depends on the void ratio. Unloading follows the same path: packings
/// unloaded from 3 MPa retrace it within 0.25.
/// Assumes   isotropic stress, no sliding that rearranges the packing.
/// \param    known      law, radius, void_ratio, contacts, and the stresses at which the counts are known
/// \param    counts     z* and x_0 there
/// \param    pressure   p >= 0 at which they are wanted [Pa]
/// \throws   InvalidArgument naming the first that is out of its range; no z* is too small
/// Accuracy  z* within coordination_error (one standard deviation): of quartz spheres from 10 kPa on 0.04 to
///           100 kPa, 0.07 to 1 MPa and 0.14 to 30 MPa.
///           Round trip: 1e-9, unless z* reached the densest line.
/// Checked by tests/effective/test_contact_prior.cpp, validation/contact_prior
[[nodiscard]] CarriedContacts carried_contacts(const State& known, const ContactCounts& counts,
                                               double pressure);

/// \file
/// The inverse of rung 3: the number of contacts at which a packing has the measured stiffness.

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
