// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <granum/estimate/answer.hpp>
#include <granum/inverse/inference.hpp>

/// Forecasts for a sand of which something is measured: its level, and as far as measurements tell them how
/// it grows with stress and its Poisson's ratio. Every forecast is an answer of estimate::answer.
/// Checked by tests/inverse/test_sand_inference.cpp, validation/sands
namespace granum::inverse {

enum class SandGrowth {
  measured, ///< s of measured sands within its deviation, moved by measurements at several pressures
  fitted    ///< s by the measurements alone; asks for two pressures
};

/// What the measurements together say of the sand.
class SandInference {
 public:
  /// A quantity at another state of the same sand. One standard deviation of ln G from one measurement is
  /// sqrt(0.05^2 + (0.05 ln(p/p_0))^2 + measurement^2), half of that for a speed; where the measurements
  /// contradict one another it is as much larger as they do.
  /// \throws   InvalidArgument as estimate::answer, for a speed without the density of the grains, and for a
  ///           compression wave in wet pores
  [[nodiscard]] Measured predict(Quantity quantity, const effective::State& at) const;
  /// What makes a forecast at that state doubtful: the remarks of estimate::answer on the sand there.
  /// \throws   InvalidArgument as estimate::answer
  [[nodiscard]] Validity doubts(const effective::State& at) const;
  /// The question of the sand at a state, with what was measured in it.
  [[nodiscard]] estimate::Question question(const effective::State& at) const;
  /// z* and the softness of contacts that the measured Poisson's ratio and G imply at a state.
  [[nodiscard]] estimate::Range contacts(estimate::Field field, const effective::State& at) const;

  /// G of this sand over that of the pooled law.
  [[nodiscard]] const Measured& level() const { return level_; }
  /// s from 50 kPa on.
  [[nodiscard]] const Measured& exponent() const { return exponent_; }
  /// At the first measurement.
  [[nodiscard]] const Measured& poisson_ratio() const { return poisson_ratio_; }
  /// Whether measurements tell Poisson's ratio, and with it contacts: V_p beside V_s, K beside G.
  [[nodiscard]] bool tells_contacts() const { return tells_contacts_; }
  [[nodiscard]] const std::vector<FittedObservation>& measurements() const { return fitted_; }
  [[nodiscard]] double chi_square() const { return chi_square_; }
  [[nodiscard]] std::size_t degrees_of_freedom() const { return degrees_of_freedom_; }
  [[nodiscard]] double probability() const { return probability_; }
  /// By how much errors are larger than stated: 1, or sqrt(chi^2/degrees of freedom) of a contradiction.
  [[nodiscard]] double widening() const { return widening_; }
  /// What contradicts, and what it may be, in words.
  [[nodiscard]] const Validity& validity() const { return validity_; }

 private:
  friend SandInference infer_sand(std::span<const Observation> measurements, const estimate::Question& sand,
                                  SandGrowth growth);
  explicit SandInference(estimate::Question known) : known_(std::move(known)) {}

  estimate::Question known_;
  std::array<double, 9> covariance_{}; ///< of ln level, s and nu, by rows
  Measured level_, exponent_, poisson_ratio_;
  bool tells_contacts_ = false;
  std::vector<FittedObservation> fitted_;
  double chi_square_ = 0;
  std::size_t degrees_of_freedom_ = 0;
  double probability_ = 1, widening_ = 1;
  Validity validity_;
};

/// Level, exponent and Poisson's ratio by least squares in ln of the measured values; the last two have those
/// of measured sands with their deviations as measurements of their own.
/// Assumes   dry or drained sand; values of one ground, whose scatter from test to test is 5 % of G
/// \param    sand   what is known of it besides its states; its own state is not used
/// \throws   InvalidArgument without measurements, for values not positive, for a speed without the density
///           of the grains, for a compression wave or K in wet pores, and for SandGrowth::fitted at one
///           stress
/// Accuracy  a modulus of the pooled law gives level 1 back to 1e-9.
[[nodiscard]] SandInference infer_sand(std::span<const Observation> measurements,
                                       const estimate::Question& sand,
                                       SandGrowth growth = SandGrowth::measured);

} // namespace granum::inverse
