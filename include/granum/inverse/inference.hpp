// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>
#include <granum/estimate/input_values.hpp>
#include <granum/inverse/contacts.hpp>
#include <granum/inverse/quantity.hpp>

/// Calibrate once, predict elsewhere: infers the coordination number from measured moduli or wave speeds by
/// rung 3, with its standard error, and predicts quantities at another stress, void ratio or direction.
/// Checked by tests/inverse/test_inference.cpp, validation/infer
namespace granum::inverse {

/// A measured value and its state; the coordination number of the state is not used.
struct Observation {
  Quantity quantity = Quantity::G_vh;
  Measured value; ///< > 0 [Pa or m/s], error at most the value; errors below 0.01 % count as 0.01 %
  effective::State state;
  /// Of its pores by water, for speeds; without it that of all measurements, [0, 1] [1].
  std::optional<double> saturation = {};
};

/// Uncertain inputs common to all measurements.
struct SharedInputs {
  std::vector<std::string> keys; ///< one per input
  /// Changes all inputs together, each by a number of its standard deviations, in a state and in the density
  /// of the grains [kg/m3].
  std::function<void(effective::State& state, double& grain_density, std::span<const double> deviations)>
      move;
};

struct InferenceOptions {
  std::optional<double> grain_density = std::nullopt; ///< of the solid; needed for speeds [kg/m3]
  /// Density of the pore fluid, 0 for dry [kg/m3]. In wet pores compression waves are refused: they travel
  /// mainly in the water.
  double pore_density = 0;
  /// At the first measurement, if known; else that of effective::expected_rattlers.
  std::optional<double> rattler_fraction = std::nullopt;
  GrowthRule growth = GrowthRule::packings;
  SharedInputs inputs = {};
  UnknownContacts contacts = {}; ///< parameters of the contact law to be inferred as well
  std::size_t iteration_limit = 100;
};

/// Share of one source in the variance of z*, 0 to 1.
struct ErrorShare {
  std::string source; ///< "measurement", "rung 3", "rattlers", "growth", or the key of an input
  double share = 0;
};

/// Contacts of the packing at one stress.
struct InferredPacking {
  Measured mechanical_coordination_number; ///< z*
  Measured rattler_fraction;               ///< x_0
  Measured coordination_number;            ///< C_n = z* (1 - x_0)
};

/// A measurement compared with the fit of all measurements.
struct FittedObservation {
  Measured value;       ///< as fitted [Pa or m/s]
  double deviation = 0; ///< ln of measured over fitted, in standard errors of measurement and rung 3
};

namespace detail {
class ContactModel;
}

/// The packing as determined by all measurements, and predictions for its other states.
class Inference {
 public:
  /// The stress at which z*() applies: that of the first measurement [Pa].
  [[nodiscard]] double reference_stress() const { return reference_stress_; }
  /// Contacts at a state.
  [[nodiscard]] InferredPacking packing(const effective::State& at,
                                        AskedPacking specimen = AskedPacking::same) const;
  /// A quantity at another state of the same packing. Errors common to measurement and prediction, such as
  /// those of the grains' modulus or of the preparation, cancel.
  /// \param    saturation   of the pores there, for speeds; without it that of all measurements, [0, 1] [1]
  /// \throws   InvalidArgument as relaxed(), for a speed without grain density, and for a compression wave in
  ///           wet pores
  [[nodiscard]] Measured predict(Quantity quantity, const effective::State& at,
                                 AskedPacking specimen = AskedPacking::same,
                                 std::optional<double> saturation = {}) const;
  /// The notes of estimate::answer on the packing, with its contacts, at that state: why a prediction there
  /// is doubtful.
  /// \throws   InvalidArgument as estimate::answer
  [[nodiscard]] Validity doubts(const effective::State& at, AskedPacking specimen = AskedPacking::same) const;
  /// The packing at a state, with its contacts, as input of any rung.
  [[nodiscard]] effective::State state(effective::State at, AskedPacking specimen = AskedPacking::same) const;
  /// Void ratio of the packing at another mean stress [Pa]: changed by the overlaps under
  /// GrowthRule::packings; else that of the first measurement.
  [[nodiscard]] double void_ratio_at(double mean_stress) const;

  [[nodiscard]] const std::vector<FittedObservation>& measurements() const { return fitted_; }
  [[nodiscard]] const std::vector<ErrorShare>& error_shares() const { return shares_; }
  /// g of GrowthRule::fitted.
  [[nodiscard]] const std::optional<Measured>& growth_exponent() const { return growth_; }
  /// Present if parameters of the contact law were inferred.
  [[nodiscard]] const std::optional<ImpliedContacts>& contacts() const { return contacts_; }
  /// Sum of squared deviations, its degrees of freedom, and the probability of a sum at least as large if the
  /// errors are as stated; 1 without degrees of freedom.
  [[nodiscard]] double chi_square() const { return chi_square_; }
  [[nodiscard]] std::size_t degrees_of_freedom() const { return degrees_of_freedom_; }
  [[nodiscard]] double probability() const { return probability_; }

 private:
  friend class detail::ContactModel;
  Inference() = default;

  std::shared_ptr<const detail::ContactModel> model_;
  std::vector<double> parameters_;
  std::vector<double> covariance_; ///< by rows
  double reference_stress_ = 0;
  std::vector<FittedObservation> fitted_;
  std::vector<ErrorShare> shares_;
  std::optional<Measured> growth_;
  std::optional<ImpliedContacts> contacts_;
  double chi_square_ = 0;
  std::size_t degrees_of_freedom_ = 0;
  double probability_ = 1;
};

/// The result of one measurement by itself.
struct AloneAnswer {
  effective::ImpliedCoordination implied;                 ///< bounds in Pa, also for a speed
  std::optional<Measured> mechanical_coordination_number; ///< z* with its error, if one exists
};

struct InferenceAnswer {
  std::vector<AloneAnswer> alone;    ///< one per measurement
  std::optional<Inference> together; ///< empty if no coordination number fits any of the measurements
  Validity validity;                 ///< notes on measurements that cannot be fitted, and on contradictions
};

/// z* by weighted least squares in ln of the measured values. Further unknowns, each within its error: the
/// fraction of rattlers; the growth of z*; the deviation of the packing from the calibration of rung 3 (the
/// part common to packings of one preparation; the rest differs from state to state); the uncertain inputs;
/// and the parameters of the contact law to be inferred.
/// Assumes   independent, normal errors of ln values; one packing with one contact law.
///           `alone` uses the contact law of the state of each measurement.
/// \throws   InvalidArgument without measurements, for values or states out of range, for V_p of less than
///           sqrt(4/3) V_s at one state, for a fitted exponent of growth that the measurements do not
///           determine (its standard error above 0.5) or that lies outside of 0 to 1, for a speed without
///           grain density, for a compression wave in wet pores, and for GrowthRule::fitted at one stress;
///           NotConverged if least squares fail
/// Accuracy  a modulus computed at z* gives z* back to 1e-10. Errors: to first order
/// Checked by tests/inverse/test_inference.cpp; own packings: validation/infer
[[nodiscard]] InferenceAnswer infer(std::span<const Observation> measurements,
                                    const InferenceOptions& options);

/// \file
/// Uncertain inputs that all measurements of a packing have in common: its material, size and density,
/// but neither stresses nor contacts.

/// The rows that all measurements share and that the packing depends on.
[[nodiscard]] std::vector<const estimate::InputRow*> shared_rows(const estimate::InputValues& completed);

/// The shared ones of uncertain inputs, as an inference takes them. Changes of positive numbers keep their
/// sign; all are changed together, because two may belong to the same contact law.
/// \param    uncertain   of uncertain_inputs(completed, ...)
/// Checked by tests/inverse/test_inference.cpp
[[nodiscard]] SharedInputs shared_inputs(const estimate::InputValues& completed,
                                         std::span<const estimate::UncertainInput> uncertain);

} // namespace granum::inverse
