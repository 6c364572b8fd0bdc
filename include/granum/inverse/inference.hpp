// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/core/measured.hpp>
#include <granum/core/validity.hpp>
#include <granum/effective/implied_coordination.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>
#include <granum/inverse/contacts.hpp>
#include <granum/inverse/growth.hpp>
#include <granum/inverse/quantity.hpp>

/// Calibrate once, predict elsewhere: the contact number that measured moduli or wave speeds imply through
/// rung 3, with its standard error, and what follows of it at another stress, void ratio or direction.
/// Checked by tests/inverse/test_inference.cpp, validation/infer
namespace granum::inverse {

/// A measured value and the state it was measured at; the state's coordination number is not used.
struct Observation {
  Quantity quantity = Quantity::G_vh;
  Measured value; ///< > 0 [Pa or m/s]; errors below 0.01 % count as 0.01 %
  effective::State state;
};

/// Inputs that all measurements share and whose errors they share.
struct SharedInputs {
  std::vector<std::string> keys; ///< one a number
  /// Moves all of them at once, each by so many of its standard deviations, in a state and in the density of
  /// the grains [kg/m3].
  std::function<void(effective::State& state, double& grain_density, std::span<const double> deviations)>
      move;
};

struct InferenceOptions {
  std::optional<double> grain_density = std::nullopt; ///< of the solid; speeds ask for it [kg/m3]
  /// Of what fills the pores, 0: dry [kg/m3]. In wet ones no compression wave is asked for: it is that of the
  /// water above all.
  double pore_density = 0;
  /// At the first measurement, where it is known; else that of effective::expected_rattlers.
  std::optional<double> rattler_fraction = std::nullopt;
  GrowthRule growth = GrowthRule::packings;
  SharedInputs inputs = {};
  UnknownContacts contacts = {}; ///< numbers of the contact law that are asked for as well
  std::size_t iteration_limit = 100;
};

/// Of the variance of z*, 0 to 1, what one source makes.
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

/// A measurement beside what all of them together say of it.
struct FittedObservation {
  Measured value;       ///< as fitted [Pa or m/s]
  double deviation = 0; ///< ln of measured over fitted, in standard errors of measurement and rung 3
};

namespace detail {
class ContactModel;
}

/// What the measurements together say of the packing, and of every other state of it.
class Inference {
 public:
  /// The stress that z*() belongs to: that of the first measurement [Pa].
  [[nodiscard]] double reference_stress() const { return reference_stress_; }
  /// Contacts at a state.
  [[nodiscard]] InferredPacking packing(const effective::State& at,
                                        AskedPacking specimen = AskedPacking::same) const;
  /// A quantity at another state of the same packing. What measurement and prediction have in common, as the
  /// error of the grains' modulus or of the preparation, cancels as far as they have it in common.
  /// \throws   InvalidArgument as relaxed(), for a speed without grain density, and for a compression wave in
  ///           wet pores
  [[nodiscard]] Measured predict(Quantity quantity, const effective::State& at,
                                 AskedPacking specimen = AskedPacking::same) const;
  /// What makes a prediction at that state doubtful: the remarks of estimate::answer on the packing with its
  /// contacts there.
  /// \throws   InvalidArgument as estimate::answer
  [[nodiscard]] Validity doubts(const effective::State& at, AskedPacking specimen = AskedPacking::same) const;
  /// The packing at a state, with its contacts, to ask any rung.
  [[nodiscard]] effective::State state(effective::State at, AskedPacking specimen = AskedPacking::same) const;
  /// Void ratio of the packing at another mean stress [Pa]: overlaps change it under GrowthRule::packings;
  /// else it stays that of the first measurement.
  [[nodiscard]] double void_ratio_at(double mean_stress) const;

  [[nodiscard]] const std::vector<FittedObservation>& measurements() const { return fitted_; }
  [[nodiscard]] const std::vector<ErrorShare>& error_shares() const { return shares_; }
  /// g of GrowthRule::fitted.
  [[nodiscard]] const std::optional<Measured>& growth_exponent() const { return growth_; }
  /// Where numbers of the contact law were asked for.
  [[nodiscard]] const std::optional<ImpliedContacts>& contacts() const { return contacts_; }
  /// Sum of squared deviations, how many of them are free, and the probability that errors as stated make
  /// it so large; 1 where none is free.
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

/// What one measurement says by itself.
struct AloneAnswer {
  effective::ImpliedCoordination implied;                 ///< bounds in Pa, also for a speed
  std::optional<Measured> mechanical_coordination_number; ///< z* with its error, where there is one
};

struct InferenceAnswer {
  std::vector<AloneAnswer> alone;    ///< one a measurement
  std::optional<Inference> together; ///< nothing where no measurement can be explained by any contact number
  Validity validity;                 ///< what cannot be explained, or contradicts, in words
};

/// z* by weighted least squares in ln of the measured values. Unknown besides z* are, each within its error,
/// the share of rattlers, how z* grows, how much the packing differs from the calibration of rung 3 (the part
/// that packings of one preparation share; the rest differs from state to state), the inputs named as
/// uncertain, and the numbers of the contact law that are asked for.
/// Assumes   independent, normal errors of ln values; one packing, whose contact law is the same everywhere.
///           `alone` is what a measurement says with the law of its state.
/// \throws   InvalidArgument without measurements, for values or states out of range, for a speed without
///           grain density, for a compression wave in wet pores, and for GrowthRule::fitted at one stress;
///           NotConverged if least squares fail
/// Accuracy  a modulus computed at z* gives z* back to 1e-10. Errors: to first order
/// Checked by tests/inverse/test_inference.cpp; own packings: validation/infer
[[nodiscard]] InferenceAnswer infer(std::span<const Observation> measurements,
                                    const InferenceOptions& options);

} // namespace granum::inverse
