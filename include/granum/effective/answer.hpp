// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// One number and its range: relaxed moduli and wave speeds of a packing of which the contacts, and other
/// inputs, may be known poorly or not at all.
namespace granum::effective {

/// What is known of a packing.
struct PackingQuestion {
  /// Law, k_t/k_n, grains, e, a, stresses; its coordination number is not used.
  State state;
  Preparation preparation = {};
  std::optional<double> coordination_number = std::nullopt;            ///< C_n, if it was counted
  std::optional<double> mechanical_coordination_number = std::nullopt; ///< z*
  std::optional<double> rattler_fraction = std::nullopt;               ///< x_0
  std::optional<double> grain_density = std::nullopt; ///< [kg/m3] > 0; without it no wave speeds
  double saturation = 0;                              ///< share of the pores' volume that is water, in [0, 1]
};

/// An input that is known to within a standard deviation: the question with one less of it and with one more.
struct InputSpread {
  std::string name;
  PackingQuestion less;
  PackingQuestion more;
};

/// A number and the range that holds what is not known of it.
struct Range {
  double value = 0;
  double low = 0;
  double high = 0;
};

/// How much of the range of G_vh an input makes: of the sum of the squares of all widths.
struct Share {
  std::string input;
  double share = 0; ///< [0, 1]; all of them are 1 together
};

/// Relaxed stiffness. Vertical quantities are those of isotropic packings too.
struct PackingAnswer {
  Range shear_modulus;                              ///< G_vh [Pa]
  Range bulk_modulus;                               ///< K of the skeleton [Pa]
  Range young_modulus;                              ///< E_v of the skeleton [Pa]
  Range poisson_ratio;                              ///< nu_vh of the skeleton [1]
  Range G_hh;                                       ///< [Pa]
  Range horizontal_young_modulus;                   ///< E_h [Pa]
  std::optional<Range> shear_wave_speed;            ///< up and down, or sideways in a vertical plane [m/s]
  std::optional<Range> compression_wave_speed;      ///< up and down, undrained [m/s]
  std::optional<Range> horizontal_shear_wave_speed; ///< in the horizontal plane [m/s]
  std::optional<Range> horizontal_compression_wave_speed; ///< undrained [m/s]
  std::optional<Range> bulk_density;                      ///< with the water in its pores [kg/m3]
  Range coordination_number;                              ///< C_n
  Range mechanical_coordination_number;                   ///< z*
  Range rattler_fraction;                                 ///< x_0
  std::vector<Share> shares;                              ///< largest first, none of nothing
  Validity validity;
};

/// Rung 3 at the contacts that are known, or else in the middle of those that the packing may have.
/// The range holds what moves the answer, each by itself, in quadrature of its logarithm (of nu: of itself):
/// the contacts from the loosest to the densest of the preparation with the scatter of z*, one standard error
/// of rung 3, and one deviation of each uncertain input, to each side as far as it goes there. Of z* alone,
/// C_n follows with the prior's rattlers; of C_n alone z* does; of rattlers alone z* does, within the prior's
/// range. A stiffness of 0 is in the range where z* may be at the isostatic point.
/// Assumes   as relaxed, contact_prior and saturated; air in the pores of a saturation below 1 makes them
///           nearly as soft as dry.
/// \throws   InvalidArgument as relaxed and contact_prior, for a saturation or density out of its range, and
///           if C_n, z* and x_0 are all given
/// Accuracy  of the middle as relaxed at its z*. Checked by tests/effective/test_answer.cpp
[[nodiscard]] PackingAnswer answer(const PackingQuestion& question,
                                   std::span<const InputSpread> uncertain = {});

} // namespace granum::effective
