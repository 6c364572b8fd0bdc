// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <granum/core/validity.hpp>
#include <granum/effective/state.hpp>

/// How many contacts a packing may have of which only void ratio and stress are known: between those of
/// grains prepared with much friction and the most that this void ratio allows. Calibrated on granum's own
/// packings; validation/contact_prior holds the fit and the errors.
namespace granum::effective {

/// Contacts that bear load, and the grains that bear none.
struct ContactCounts {
  double mechanical_coordination_number = State::unset; ///< z* >= 0, without rattlers [1]
  double rattler_fraction = State::unset;               ///< x_0 in [0, 1) [1]

  /// C_n = z* (1 - x_0), over all grains [1].
  [[nodiscard]] double coordination_number() const {
    return mechanical_coordination_number * (1 - rattler_fraction);
  }
};

/// How grains came together, as far as it decides how many touch.
struct Preparation {
  enum class Kind {
    unknown,
    dense,   ///< as if without friction: the most contacts that the void ratio allows
    loose,   ///< with the friction of minerals, 0.3 to 0.5, all the way
    friction ///< with the friction coefficient below all the way
  };
  Kind kind = Kind::unknown;
  double friction_coefficient = 0; ///< tangent of the friction angle of two grains, > 0, of Kind::friction

  bool operator==(const Preparation&) const = default;
};

/// "dense", "loose", or "friction:0.3".
/// \throws   InvalidArgument for another text, or a coefficient that is not positive
/// Checked by tests/effective/test_contact_prior.cpp
[[nodiscard]] Preparation preparation_of(std::string_view text);

/// The contacts that a packing may have.
struct ContactPrior {
  ContactCounts loosest; ///< the fewest contacts
  ContactCounts middle;  ///< half way, by z*
  ContactCounts densest; ///< the most
  /// Standard deviation of z* of packings about each; larger where no packing of spheres exists [1].
  double coordination_error = 0;
  double packing_scatter = 0; ///< what it is where packings of spheres exist [1]
  double rattler_error = 0;   ///< that of ln x_0 [1]
  /// Overlap of the mean force over the diameter, in the middle: what decides how z* grows [1].
  double relative_overlap = 0;
  Validity validity;
};

/// Contacts of a packing of that void ratio and mean stress.
/// Friction both holds grains apart and lets them rest on fewer contacts. Grains compressed from a gas end on
/// the densest line, where each void ratio has its friction and its z*; shaken or tapped denser, they keep
/// the few contacts of their friction. Without preparation the range goes from friction 0.5, the most that
/// smooth minerals have, to that line. Less friction than the void ratio needs means the line as well. At
/// one preparation and pressure a denser packing is never softer. Of unequal grains, which pack denser, the
/// line is an upper bound, and many more rattle.
/// Assumes   equal spheres, isotropic stress that has not been larger before, no cement.
/// \param    state         law, radius, void_ratio, stresses and contacts; its coordination number is not
///                         used
/// \return   notes where no packing of equal spheres is so loose or so dense, where friction is too small
///           for the void ratio, of unequal grains, and where overlaps exceed those of the calibration
/// \throws   InvalidArgument naming a member of the state or of the preparation that is out of its range
/// Accuracy  of recipes left out of the fit see validation/contact_prior; relative overlaps below 0.01.
///           Rounding: relative 1e-12.
/// Checked by tests/effective/test_contact_prior.cpp, validation/contact_prior
[[nodiscard]] ContactPrior contact_prior(const State& state, const Preparation& preparation = {});

/// x_0 that packings of z* have, by the fit of the prior.
/// \param    mechanical_coordination_number   z* >= 0 [1]
/// \param    relative_overlap                 as in ContactPrior, >= 0 [1]
/// \return   at most 0.9, which a z* far below the isostatic point would exceed
/// \throws   InvalidArgument outside of these ranges
/// Accuracy  of equal grains within a factor of 1.3 (one standard deviation).
///           Checked by tests/effective/test_contact_prior.cpp, validation/contact_prior
[[nodiscard]] double typical_rattler_fraction(double mechanical_coordination_number, double relative_overlap);

/// Contacts carried from the mean stress at which they are known to another.
struct CarriedContacts {
  ContactCounts counts;
  double void_ratio = 0;       ///< overlaps change it [1]
  double relative_overlap = 0; ///< as in ContactPrior [1]
  /// Standard deviation of z* that carrying adds: 0 where nothing changes, and as the root of what the root
  /// of the overlap changes by [1]
  double coordination_error = 0;
  Validity validity;
};

/// How z* and rattlers of one and the same packing change with pressure: overlaps close gaps. Of z* the root
/// of what is missing to the densest line falls as the root of the overlap grows; fast in packings opened a
/// little below the densest, slowly in those compressed with friction from a gas, as each void ratio has it.
/// The way back is the same: packings unloaded from 3 MPa retrace it within 0.25.
/// Assumes   isotropic stress, no sliding that rebuilds the packing.
/// \param    known      law, radius, void_ratio, contacts, and the stresses at which the counts are known
/// \param    counts     z* and x_0 there
/// \param    pressure   p >= 0 to carry them to [Pa]
/// \throws   InvalidArgument naming the first that is out of its range; no z* is too small
/// Accuracy  z* within coordination_error (one standard deviation): of quartz spheres from 10 kPa on 0.04 to
///           100 kPa, 0.07 to 1 MPa and 0.14 to 30 MPa.
///           Carrying there and back: 1e-9, unless z* met the densest line on the way.
/// Checked by tests/effective/test_contact_prior.cpp, validation/contact_prior
[[nodiscard]] CarriedContacts carried_contacts(const State& known, const ContactCounts& counts,
                                               double pressure);

} // namespace granum::effective
