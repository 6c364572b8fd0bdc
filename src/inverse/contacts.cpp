// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/contacts.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include <granum/core/error.hpp>

#include "contact_model.hpp"

namespace granum::inverse {

namespace {

constexpr std::array<std::string_view, 3> all_names{"given", "rough", "power-law"};

const contact::PowerLaw& smooth_sphere(const contact::NormalLaw& given) {
  const contact::PowerLaw* const law = given.power_law();
  if (law == nullptr || law->alpha() != 2)
    throw InvalidArgument(
        "inferred contacts replace the law of smooth spheres: the given law must be of smooth spheres");
  return *law;
}

} // namespace

std::span<const std::string_view> unknown_contact_names() { return all_names; }

contact::PowerLaw power_law_through(const contact::GrainMaterial& grain, double alpha, double force,
                                    double stiffness) {
  require_positive("alpha", alpha);
  require_positive("force", force, "N");
  require_positive("stiffness", stiffness, "N/m");
  // k_n = m f/d, so that d = m f/k_n and c = f/d^m.
  const double m = 1 + 1 / alpha;
  return contact::PowerLaw::of_numbers(grain, {alpha, force * std::pow(m * force / stiffness, -m)});
}

UnknownContacts unknown_contacts(std::string_view name) {
  if (name == "given")
    return {};
  if (name == "rough")
    return {.name = "rough",
            .numbers = {{.key = "roughness", .expected = 20e-9, .scatter = std::log(10.0), .unit = "m"}},
            .law = [](const contact::NormalLaw& given, double, std::span<const double> numbers) {
              return contact::RoughSphere::of_numbers(given.grain(),
                                                      {2, smooth_sphere(given).coefficient(), numbers[0]});
            }};
  if (name == "power-law")
    return {.name = "power-law",
            .numbers = {{.key = "softness", .expected = 1, .scatter = std::log(3.0)},
                        {.key = "alpha", .expected = 2, .scatter = std::log(2.0)}},
            .law = [](const contact::NormalLaw& given, double force, std::span<const double> numbers) {
              const double hertz = smooth_sphere(given).stiffness_at_force(force);
              return power_law_through(given.grain(), numbers[1], force, numbers[0] * hertz);
            }};
  throw InvalidArgument("contacts '" + std::string(name) + "' is unknown; known are given, rough, power-law");
}

} // namespace granum::inverse

namespace granum::inverse::detail {

namespace {

/// Relative error of a hypothetical measurement.
constexpr double careful = 0.02;
/// Prior of z* for unknown grains: uniform from the isostatic point to the z* of frictionless grains.
constexpr double most_contacts = 6;

bool all_determined(const std::vector<ImpliedNumber>& numbers) {
  for (const ImpliedNumber& number : numbers)
    if (!number.determined())
      return false;
  return true;
}

} // namespace

std::vector<ImpliedNumber> ContactModel::implied_numbers(const Eigen::VectorXd& theta,
                                                         const Eigen::MatrixXd& covariance) const {
  const double above = std::exp(theta[0]);
  std::vector<ImpliedNumber> implied;
  implied.push_back({.key = "z*",
                     .unit = {},
                     .value = {isostatic_ + above, above * std::sqrt(covariance(0, 0))},
                     .before = (most_contacts - isostatic_) / std::sqrt(12.0)});
  const std::vector<double> values = contact_numbers(theta);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const UnknownNumber& number = options_.contacts.numbers[k];
    const Eigen::Index place = law_parameter(k);
    implied.push_back({.key = number.key,
                       .unit = number.unit,
                       .value = {values[k], values[k] * number.scatter * std::sqrt(covariance(place, place))},
                       .before = values[k] * number.scatter});
  }
  return implied;
}

std::optional<Quantity> ContactModel::would_determine(const std::vector<StateGroup>& groups,
                                                      const Eigen::VectorXd& theta,
                                                      const Eigen::MatrixXd& jacobian) const {
  constexpr std::array candidates{Quantity::V_p, Quantity::V_s, Quantity::K, Quantity::G_vh};
  for (const Quantity quantity : candidates) {
    const QuantityRow& row = row_of(quantity);
    const auto measured = [quantity](const Observation& m) { return m.quantity == quantity; };
    if (std::any_of(measurements_.begin(), measurements_.end(), measured))
      continue;
    if (row.speed && (!options_.grain_density || options_.pore_density > 0))
      continue;
    const auto values = [&](const Eigen::VectorXd& at) {
      Eigen::VectorXd all(static_cast<Eigen::Index>(groups.size()));
      for (std::size_t k = 0; k < groups.size(); ++k) {
        const effective::State& state = measurements_[groups[k].members.front()].state;
        const double noise =
            std::hypot(careful, own_scatter(theta, quantity, state, AskedPacking::same).norm());
        all[static_cast<Eigen::Index>(k)] = log_value(at, quantity, state, AskedPacking::same) / noise;
      }
      return all;
    };
    const Eigen::MatrixXd further = slopes(values, theta);
    Eigen::MatrixXd both(jacobian.rows() + further.rows(), jacobian.cols());
    both << jacobian, further;
    if (all_determined(implied_numbers(theta, inverse_information(both))))
      return quantity;
  }
  return std::nullopt;
}

ImpliedContacts ContactModel::implied_contacts(const std::vector<StateGroup>& groups,
                                               const Eigen::VectorXd& theta,
                                               const Eigen::MatrixXd& jacobian) const {
  const Eigen::MatrixXd covariance = inverse_information(jacobian);
  ImpliedContacts implied;
  implied.numbers = implied_numbers(theta, covariance);
  const auto place = [this](std::size_t number) { return number == 0 ? 0 : law_parameter(number - 1); };
  for (std::size_t i = 0; i < implied.numbers.size(); ++i)
    for (std::size_t k = 0; k < implied.numbers.size(); ++k)
      implied.correlation.push_back(
          i == k ? 1
                 : covariance(place(i), place(k)) /
                       std::sqrt(covariance(place(i), place(i)) * covariance(place(k), place(k))));
  const double force = first_force(theta);
  implied.law = with_law(theta, first_).law;
  implied.local_exponent = implied.law->exponent_at_force(force);
  implied.softness = implied.law->stiffness_at_force(force) / first_.law.stiffness_at_force(force);
  if (!all_determined(implied.numbers))
    implied.would_determine = would_determine(groups, theta, jacobian);
  return implied;
}

} // namespace granum::inverse::detail
