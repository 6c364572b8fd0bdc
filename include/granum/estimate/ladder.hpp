// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/effective/rungs.hpp>
#include <granum/estimate/answer.hpp>

/// Choosing a rung: the result of each rung for a packing, its stated error, and the cheapest rung that is
/// accurate enough.
namespace granum::estimate {

/// Why a rung was or was not taken.
enum class RungVerdict {
  chosen,           ///< the cheapest that fits the tolerance, or the best if none does
  cheaper_does,     ///< fits as well, but a cheaper one does too
  beyond_tolerance, ///< its stated error exceeds the tolerance
  error_unknown,    ///< the packing may not be rigid: the error is not known
  inputs_missing,   ///< an input is not given
};
/// The name of the enumerator.
[[nodiscard]] const char* name(RungVerdict verdict);

/// One rung of the ladder.
struct RungAssessment {
  const effective::Rung* rung = nullptr;
  std::vector<std::string> missing;                        ///< inputs that are needed and not given
  std::optional<elastic::TransverselyIsotropic> stiffness; ///< if no input is missing
  /// Stated errors of K, G_hh and G_vh relative to the moduli of the packing's contact network.
  std::optional<effective::ModulusErrors> relative_error;
  std::string error_source; ///< their source
  RungVerdict verdict = RungVerdict::inputs_missing;
  std::string reason; ///< the verdict in words

  /// Largest of the three; empty if none is stated.
  [[nodiscard]] std::optional<double> largest_error() const;
};

/// The ladder for one packing, and the rung to take.
struct Ladder {
  double tolerance = 0;
  bool tolerance_met = false;
  Range mechanical_coordination_number; ///< of the answer, used for the errors
  std::vector<RungAssessment> rungs;    ///< in the order of their numbers; rungs that need a packing lack it
  std::size_t chosen = 0;
  std::vector<std::string> advice; ///< inputs that would allow a better or a cheaper rung
  Validity validity;               ///< notes of the answer, and one if the tolerance is not met

  [[nodiscard]] const RungAssessment& choice() const { return rungs[chosen]; }
};

/// Chooses the cheapest rung whose stated error is within the tolerance and whose inputs are given; else the
/// one with the smallest error. A larger tolerance never leads to a more expensive rung.
///
/// The stated error of rung 3 is half of the range of the answer over its value. Rungs 0 to 2 follow the mean
/// strain and are too stiff compared with rung 3: their stated error is |X/X_3 - 1| of a modulus X plus the
/// error of X_3, times X/X_3. About two thirds of packings lie within the stated error of rung 3, and 19 of
/// 20 within twice that error; packings of some hundred grains scatter more. An assumed fabric counts as
/// missing for the rungs that need it. Where the modulus is exactly zero (no contacts, or no stress on
/// contacts whose stiffness depends on force) rung 0 is exact.
/// \param    tolerance   > 0, of the largest stated error among K, G_hh and G_vh, 0.05 for 5 % [1]
/// \return   without stated errors (verdict error_unknown) where z* is at or below the isostatic point
/// \throws   InvalidArgument unless tolerance is positive, and for the answer of a sand
/// Accuracy  of stated errors see validation/ladder. Checked by tests/estimate/test_ladder.cpp
[[nodiscard]] Ladder choose(const Answer& answer, double tolerance);

} // namespace granum::estimate
