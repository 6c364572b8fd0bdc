// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/effective/rungs.hpp>
#include <granum/estimate/answer.hpp>

/// Choosing a rung: what each of them says of a packing, how far it may be trusted, and the cheapest that is
/// good enough.
namespace granum::estimate {

/// Why a rung was or was not taken.
enum class RungVerdict {
  chosen,           ///< the cheapest that fits the tolerance, or the best if none does
  cheaper_does,     ///< fits as well, but a cheaper one does
  beyond_tolerance, ///< its stated error exceeds the tolerance
  error_unknown,    ///< the packing may not be rigid: nothing is known of the error
  inputs_missing,   ///< needs what is not given
};
/// The name of the enumerator.
[[nodiscard]] const char* name(RungVerdict verdict);

/// One rung of the ladder.
struct RungAssessment {
  const effective::Rung* rung = nullptr;
  std::vector<std::string> missing;                        ///< inputs that it needs and has not
  std::optional<elastic::TransverselyIsotropic> stiffness; ///< where no input is missing
  /// Stated errors of K, G_hh and G_vh against a packing's own contact network, over the latter.
  std::optional<effective::ModulusErrors> relative_error;
  std::string error_source; ///< where they come from
  RungVerdict verdict = RungVerdict::inputs_missing;
  std::string reason; ///< the verdict in words

  /// Largest of the three; nothing where none is stated.
  [[nodiscard]] std::optional<double> largest_error() const;
};

/// The ladder for one packing, and the rung to take.
struct Ladder {
  double tolerance = 0;
  bool tolerance_met = false;
  Range mechanical_coordination_number; ///< of the answer, which the errors are stated with
  std::vector<RungAssessment> rungs;    ///< in the order of their numbers; those of a packing lack it
  std::size_t chosen = 0;
  std::vector<std::string> advice; ///< inputs that would allow a better or a cheaper rung
  Validity validity;               ///< notes of the answer, and one if the tolerance is not met

  [[nodiscard]] const RungAssessment& choice() const { return rungs[chosen]; }
};

/// Takes the cheapest rung whose stated error fits the tolerance and whose inputs are given; else the one of
/// the smallest error. A looser tolerance never takes a dearer rung.
///
/// The stated error of rung 3 is half of the range of the answer over its value. Rungs 0 to 2 follow the mean
/// strain and are too stiff, by as much as rung 3 states: their stated error is |X/X_3 - 1| of a modulus X
/// plus the error of X_3, times X/X_3. So some two thirds of packings lie within the stated error of rung 3,
/// and 19 of 20 within twice of it; small ones, of some hundred grains, scatter more. A fabric that is an
/// assumption of the answer is missing for the rungs that need it. Where the modulus is exactly zero (no
/// contacts, or no stress on contacts that need it) rung 0 is exact.
/// \param    tolerance   > 0, of the largest stated error among K, G_hh and G_vh, 0.05 for 5 % [1]
/// \return   without stated errors (verdict error_unknown) where z* is at or below the isostatic point
/// \throws   InvalidArgument unless tolerance is positive, and for the answer of a sand
/// Accuracy  of stated errors see validation/ladder. Checked by tests/estimate/test_ladder.cpp
[[nodiscard]] Ladder choose(const Answer& answer, double tolerance);

} // namespace granum::estimate
