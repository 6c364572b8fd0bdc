// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/estimate/answer.hpp>
#include <granum/estimate/notes.hpp>
#include <granum/sands/known_sands.hpp>
#include <granum/stress/stress.hpp>

#include "cli/options/input_options.hpp"

/// The answer to the options of a command, with published laws of sands beside it and its assumptions.
namespace granum::cli {

/// The value of a law measured on sands; empty if it has none here.
struct SandAnswer {
  const sands::MeasuredLaw* law;
  std::optional<sands::SandModulus> modulus;

  /// Whether tests of the law cover this state.
  [[nodiscard]] bool tested() const { return modulus && modulus->validity.ok(); }
};

struct AnswerCase {
  estimate::Question question;
  std::vector<estimate::UncertainInput> inputs;
  estimate::Answer answer;
  /// The answer for a sand, if the kind of grains is not given; `answer` is then that for spheres.
  std::optional<estimate::Answer> sand_answer = std::nullopt;
  /// Why there is no answer for spheres, though the kind of grains is not given: `answer` is that for a sand.
  std::string beads_refused = {};
  /// Why there is no answer for a sand, though the kind of grains is not given.
  std::string sand_refused = {};
  double sand_grain_modulus = 0; ///< G_g of sand_answer, if there is one [Pa]
  double uniformity = 0;         ///< C_u of the measured laws [1]
  bool uniformity_assumed = false;
  std::vector<SandAnswer> sands = {}; ///< empty without stress
  estimate::Notes assumptions = {};   ///< of shape, grains and fabric, with their deviations

  /// The answer for grains of a kind, if there is one.
  [[nodiscard]] const estimate::Answer* of_kind(estimate::GrainShape shape) const;
  [[nodiscard]] const estimate::Answer* of_sand() const { return of_kind(estimate::GrainShape::sand); }
};

/// Computes the answer, without laws measured on sands and without assumptions.
/// \throws   InvalidArgument as estimate::answer
[[nodiscard]] AnswerCase bare_answer(const InputValues& values,
                                     const std::vector<std::string>& uncertainties = {});
/// Computes the answer.
/// \throws   InvalidArgument as estimate::answer
[[nodiscard]] AnswerCase solve_answer(const InputValues& values,
                                      const std::vector<std::string>& uncertainties);

/// Values with the stresses replaced by those of a state.
[[nodiscard]] InputValues at_stress(InputValues values, const stress::AxialStress& stress);

/// Adds the values of published laws.
void add_measured_laws(AnswerCase& answer);
/// Whether each of them was tested in this state, in the order of sands::measured_laws().
[[nodiscard]] std::vector<bool> laws_tested(const AnswerCase& answer);
/// The range from the lowest to the highest of some of them, or of all if none is named, with the geometric
/// mean of both ends as value. Empty without stress.
[[nodiscard]] std::optional<estimate::Range> range_of_laws(const AnswerCase& answer,
                                                           const std::vector<bool>& some);

} // namespace granum::cli
