// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <granum/core/measured.hpp>
#include <granum/core/validity.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// Choosing a rung: what each of them says of a packing, how far it may be trusted, and the cheapest that is
/// good enough.
namespace granum::effective {

/// z* from C_n alone, for packings whose rattlers were not counted: z* = C_n + x with x = exp(2.732 - 0.961
/// C_n), the mean of granum's own specimens. Taken to lie anywhere from no rattlers at all to twice x, which
/// holds 537 of 540 of them (the others miss it by 0.01 at most) and, for C_n
/// around 4, published packings with up to 13 % rattlers [AgnolinRoux2007a]; the standard error is that of
/// a rectangular distribution, x/sqrt(3).
/// Assumes   equal spheres at rest; specimens had C_n from 3.6 to 8.7.
/// \param    coordination_number   C_n >= 0 over all grains [1]
/// \throws   InvalidArgument if the value is out of its range
/// Accuracy  as stated.  Checked by tests/effective/test_ladder.cpp, validation/ladder
[[nodiscard]] Measured estimated_mechanical_coordination_number(double coordination_number);

/// What is known of a packing. Inputs without a standard error are taken to be exact.
struct KnownPacking {
  State state; ///< law, k_t/k_n, grains, e, C_n, a, stresses
  /// z*, if it was counted, or the rattlers: one of the two, or none.
  std::optional<Measured> mechanical_coordination_number = std::nullopt;
  std::optional<Measured> rattler_fraction = std::nullopt;
  /// Of state.fabric_anisotropy; nothing: a was not measured, and the state holds an assumption.
  std::optional<double> fabric_standard_error = 0.0;
};

/// Why a rung was or was not taken.
enum class RungVerdict {
  chosen,           ///< the cheapest that fits the tolerance, or the best if none does
  cheaper_does,     ///< fits as well, but a cheaper one does
  beyond_tolerance, ///< its stated error exceeds the tolerance
  error_unknown,    ///< the packing may not be rigid: nothing is known of the error
  inputs_missing,   ///< needs what is not given
};

/// One rung of the ladder.
struct RungAssessment {
  int rung = 0;
  std::string title;
  double typical_time = 0;          ///< of one evaluation, as measured in validation/ladder [s]
  std::vector<std::string> missing; ///< inputs that it needs and has not
  std::optional<elastic::TransverselyIsotropic> stiffness; ///< where no input is missing
  /// Stated errors of K, G_hh and G_vh against a packing's own contact network, over the latter.
  std::optional<ModulusErrors> relative_error;
  std::string error_source; ///< where they come from
  RungVerdict verdict = RungVerdict::inputs_missing;
  std::string reason; ///< the verdict in words

  /// Largest of the three; nothing where none is stated.
  [[nodiscard]] std::optional<double> largest_error() const;
};

/// The ladder for one packing, and the rung to take.
struct LadderEstimate {
  double tolerance = 0;
  bool tolerance_met = false;
  Measured mechanical_coordination_number; ///< that the errors are stated with
  bool coordination_estimated = false;     ///< it comes from C_n alone
  std::array<RungAssessment, 6> rungs;     ///< 0 to 5; 4 and 5 always lack a packing
  std::size_t chosen = 0;
  std::vector<std::string> advice; ///< inputs that would allow a better or a cheaper rung
  /// Notes of the chosen rung and of what its error is stated with, and one if the tolerance is not met.
  Validity validity;

  [[nodiscard]] const RungAssessment& choice() const { return rungs[chosen]; }
};

/// Takes the cheapest rung whose stated error fits the tolerance and whose inputs are given; else the one of
/// the smallest error. A looser tolerance never takes a dearer rung.
///
/// The stated error of rung 3 is its standard error, with what the standard errors of z* and of a make of it
/// in quadrature. Rungs 0 to 2 follow the mean strain and are too stiff, by as much as rung 3 tells: their
/// stated error is |X/X_3 - 1| of a modulus X plus the standard error of X_3, times X/X_3. So some two
/// thirds of packings lie within the stated error of rung 3, and 19 of 20 within twice of it; small ones,
/// of some hundred grains, scatter more. Where rattlers were not counted z* is
/// estimated_mechanical_coordination_number; a fabric that was not measured has a standard error of
/// hypot(0.012, 0.2 ln(stress_v/stress_h)), the rms of granum's specimens, which were made without a
/// preferred direction. Where the modulus is exactly zero (no contacts, or no stress on contacts that
/// need it) rung 0 is exact.
/// \param    tolerance   > 0, of the largest stated error among K, G_hh and G_vh, 0.05 for 5 % [1]
/// \return   without stated errors (verdict error_unknown) where z* is at or below the isostatic point
/// \throws   InvalidArgument as require_valid(State) and relaxed, unless tolerance is positive, if a
///           standard error is negative, or if z* and the rattlers are both given
/// Accuracy  validation/ladder sets stated and actual errors side by side.
/// Checked by tests/effective/test_ladder.cpp
[[nodiscard]] LadderEstimate estimate(const KnownPacking& packing, double tolerance);

} // namespace granum::effective
