// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <granum/estimate/answer.hpp>
#include <granum/inverse/inference.hpp>

/// Forecasts for a sand with measurements. They determine the level of G and, if sufficient, its exponent of
/// stress and Poisson's ratio. Every forecast is computed by estimate::answer.
/// Checked by tests/inverse/test_sand_inference.cpp, validation/sands
namespace granum::inverse {

enum class SandGrowth {
  measured, ///< s of measured sands within its deviation, moved by measurements at several pressures
  fitted    ///< s from the measurements alone; needs two pressures
};

/// The sand as determined by all measurements.
class SandInference {
 public:
  /// A quantity at another state of the same sand. One standard deviation of ln G from one measurement is
  /// sqrt(0.04^2 + (0.045 ln(p/p_0))^2 + measurement^2), half of that for a speed; it is multiplied by
  /// widening() where the measurements contradict each other.
  /// \param    saturation   of the pores there, for speeds; without it that of the sand, [0, 1] [1]
  /// \throws   InvalidArgument as estimate::answer, for a speed without the density of the grains, and for a
  ///           compression wave in wet pores
  [[nodiscard]] Measured predict(Quantity quantity, const effective::State& at,
                                 std::optional<double> saturation = {}) const;
  /// The notes of estimate::answer on the sand at that state: why a forecast there is doubtful.
  /// \throws   InvalidArgument as estimate::answer
  [[nodiscard]] Validity doubts(const effective::State& at) const;
  /// The question for estimate::answer at a state, including the measured properties.
  [[nodiscard]] estimate::Question question(const effective::State& at) const;
  /// z* and contact stiffness at a state, implied by the measured Poisson's ratio and G.
  [[nodiscard]] estimate::Range contacts(estimate::Field field, const effective::State& at) const;

  /// G of this sand over G of the pooled law.
  [[nodiscard]] const Measured& level() const { return level_; }
  /// s above 50 kPa.
  [[nodiscard]] const Measured& exponent() const { return exponent_; }
  /// At the first measurement.
  [[nodiscard]] const Measured& poisson_ratio() const { return poisson_ratio_; }
  /// Whether the measurements determine Poisson's ratio, and with it the contacts: V_p and V_s, or K and G.
  [[nodiscard]] bool tells_contacts() const { return tells_contacts_; }
  [[nodiscard]] const std::vector<FittedObservation>& measurements() const { return fitted_; }
  [[nodiscard]] double chi_square() const { return chi_square_; }
  [[nodiscard]] std::size_t degrees_of_freedom() const { return degrees_of_freedom_; }
  [[nodiscard]] double probability() const { return probability_; }
  /// Factor on the errors: 1, or sqrt(chi^2/degrees of freedom) if the measurements contradict each other.
  [[nodiscard]] double widening() const { return widening_; }
  /// Notes on contradictions and their possible causes.
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

/// Level, exponent and Poisson's ratio by least squares in ln of the measured values. The values of the
/// tested sands for the last two, with their deviations, enter as additional measurements.
/// Assumes   dry or drained sand; values from one ground, with a scatter from test to test of 4 % of G
/// \param    sand   its properties; the state in it is not used
/// \throws   InvalidArgument without measurements, for values not positive, for V_p of less than sqrt(4/3)
///           V_s at one state, for an exponent that fitted measurements do not determine (its standard error
///           above 0.25) or that lies outside of 0 to 1, for a speed without the density
///           of the grains, for a compression wave or K in wet pores, and for SandGrowth::fitted at one
///           stress
/// Accuracy  a modulus of the pooled law gives level 1 to 1e-9.
[[nodiscard]] SandInference infer_sand(std::span<const Observation> measurements,
                                       const estimate::Question& sand,
                                       SandGrowth growth = SandGrowth::measured);

} // namespace granum::inverse
