// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <granum/effective/contact_prior.hpp>
#include <granum/inverse/inference.hpp>

namespace granum::inverse::detail {

// The model of infer(): measured values as functions of a vector of parameters.

/// Measurements at one state, whose errors share the scatter of rung 3 there.
struct StateGroup {
  std::vector<std::size_t> members;
  Eigen::MatrixXd scatter;   ///< change of ln value with one deviation of K and of G
  Eigen::VectorXd noise;     ///< standard errors of ln value as measured
  Eigen::MatrixXd whitening; ///< W with W (noise^2 + scatter scatter^T) W^T = 1
};

/// Parameters: ln(z* - isostatic point) at the reference stress, and g if it is fitted; then deviations from
/// the expected values, in standard deviations: of ln x_0, of K and G of rung 3, of the growth of z*, of
/// another packing prepared alike, of the inputs, of ln of the parameters of the contact law.
class ContactModel {
 public:
  /// \throws   InvalidArgument as infer
  ContactModel(std::span<const Observation> measurements, const InferenceOptions& options);

  /// Least squares, starting from the z* implied by a measurement. If parameters of the law are inferred
  /// there may be several minima: the smallest of those found from their expected values and one deviation
  /// off them.
  [[nodiscard]] static Inference solve(std::shared_ptr<const ContactModel> model, double start);

  /// z* and rattlers.
  [[nodiscard]] effective::ContactCounts contacts(const Eigen::VectorXd& theta, const effective::State& at,
                                                  AskedPacking specimen) const;
  /// \param    saturation   without it options_.pore_density holds
  [[nodiscard]] double log_value(const Eigen::VectorXd& theta, Quantity quantity, const effective::State& at,
                                 AskedPacking specimen, std::optional<double> saturation = {}) const;
  /// Change of ln value with one deviation of K and of G in this state only.
  [[nodiscard]] Eigen::RowVector2d own_scatter(const Eigen::VectorXd& theta, Quantity quantity,
                                               const effective::State& at, AskedPacking specimen) const;
  [[nodiscard]] double void_ratio_at(const Eigen::VectorXd& theta, double mean_stress) const;
  /// The state with the contact law of the parameters.
  [[nodiscard]] effective::State with_law(const Eigen::VectorXd& theta, effective::State state) const;

 private:
  [[nodiscard]] static Inference solve_from(const std::shared_ptr<const ContactModel>& model,
                                            Eigen::VectorXd theta);
  [[nodiscard]] std::vector<StateGroup> groups(const Eigen::VectorXd& theta) const;
  [[nodiscard]] Eigen::VectorXd residuals(const std::vector<StateGroup>& groups,
                                          const Eigen::VectorXd& theta) const;
  void describe(Inference& inference, const std::vector<StateGroup>& groups, const Eigen::VectorXd& theta,
                const Eigen::MatrixXd& jacobian) const;
  [[nodiscard]] ImpliedContacts implied_contacts(const std::vector<StateGroup>& groups,
                                                 const Eigen::VectorXd& theta,
                                                 const Eigen::MatrixXd& jacobian) const;
  [[nodiscard]] std::optional<Quantity> would_determine(const std::vector<StateGroup>& groups,
                                                        const Eigen::VectorXd& theta,
                                                        const Eigen::MatrixXd& jacobian) const;
  /// z* and the parameters of the contact law, with errors from a covariance of all parameters.
  [[nodiscard]] std::vector<ImpliedNumber> implied_numbers(const Eigen::VectorXd& theta,
                                                           const Eigen::MatrixXd& covariance) const;
  [[nodiscard]] std::vector<double> contact_numbers(const Eigen::VectorXd& theta) const;
  /// Mean contact force of the first measurement, at its z*.
  [[nodiscard]] double first_force(const Eigen::VectorXd& theta) const;
  /// Rattlers at a z* in a state of the first measurement.
  [[nodiscard]] effective::ContactCounts counts_in(const Eigen::VectorXd& theta,
                                                   const effective::State& first) const;
  [[nodiscard]] effective::ContactCounts first_contacts(const Eigen::VectorXd& theta) const;
  [[nodiscard]] effective::ContactCounts at_stress(const Eigen::VectorXd& theta, double mean_stress) const;
  /// \throws   InvalidArgument for a speed that is impossible with these densities
  void require_known_density(const QuantityRow& row, std::optional<double> saturation) const;
  [[nodiscard]] Eigen::Index parameter_count() const;
  [[nodiscard]] Eigen::Index law_parameter(std::size_t number) const;
  [[nodiscard]] Eigen::Index free_count() const { return options_.growth == GrowthRule::fitted ? 2 : 1; }
  [[nodiscard]] std::string source_of(Eigen::Index prior) const;

  std::vector<Observation> measurements_;
  InferenceOptions options_;
  effective::State first_; ///< of the first measurement
  double isostatic_ = 0;
  double reference_stress_ = 0;
};

/// Density of what fills the pores of a measurement [kg/m3].
/// \throws   InvalidArgument for a saturation outside of [0, 1]
[[nodiscard]] double pore_density(const InferenceOptions& options, std::optional<double> saturation);

/// (J^T J)^-1.
[[nodiscard]] Eigen::MatrixXd inverse_information(const Eigen::MatrixXd& jacobian);

/// The derivatives of a function by the parameters, one column each, by central differences: relative 1e-10
/// for functions that change by their own size over a distance of 1.
template <class Function>
Eigen::MatrixXd slopes(const Function& function, const Eigen::VectorXd& theta) {
  constexpr double step = 1e-5;
  Eigen::MatrixXd matrix(Eigen::VectorXd(function(theta)).size(), theta.size());
  for (Eigen::Index k = 0; k < theta.size(); ++k) {
    Eigen::VectorXd above = theta, below = theta;
    above[k] += step;
    below[k] -= step;
    matrix.col(k) = (Eigen::VectorXd(function(above)) - Eigen::VectorXd(function(below))) / (2 * step);
  }
  return matrix;
}

/// Refuses measurements at one state that no stable solid has together: a compression wave whose modulus is
/// smaller than 4/3 of a shear modulus or than a bulk modulus, by more than three standard errors.
/// Assumes   dry or drained, as require_measured checks before
/// \param    grain_density   to compare speeds with moduli [kg/m3]
/// \throws   InvalidArgument naming the compression wave
/// Checked by tests/inverse/test_inference.cpp, test_sand_inference.cpp
void require_possible_together(std::span<const Observation> all, std::optional<double> grain_density);

/// Refuses a fitted exponent of growth with stress that the measurements do not determine, or that is outside
/// of [0, 1] by more than two standard errors: a forecast by it would be no forecast.
/// \param    limit   largest standard error
/// \throws   InvalidArgument
void require_determined_growth(const Measured& exponent, double limit);

} // namespace granum::inverse::detail
