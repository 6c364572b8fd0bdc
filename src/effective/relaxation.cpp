// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/relaxation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <granum/core/check.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/fabric/orientation.hpp>

#include "relaxation_kernel.hpp"

namespace granum::effective {

namespace {

using kernel::frictionless_isostatic;

// What the calibration covers; see validation/relaxation/README.md.
constexpr double smallest_coordination = 4.1, largest_coordination = 8.7;
constexpr double smallest_ratio = 0.1, largest_ratio = 1;
constexpr double largest_overlap = 0.01;
/// Far beyond, the factors no longer change, and powers of larger numbers would overflow.
constexpr double infinite = 1e9;
constexpr double largest_stress_ratio = 2.2, largest_anisotropy = 0.25;

/// A factor with its slopes by the coefficients, and last by the variable that the scatter acts on.
template <std::size_t n>
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, static_cast<int>(n) + 1, 1>>;

template <std::size_t n>
std::array<Dual<n>, n> variables(const std::array<double, n>& values) {
  std::array<Dual<n>, n> duals;
  for (std::size_t k = 0; k < n; ++k)
    duals[k] = Dual<n>(values[k], static_cast<int>(n) + 1, static_cast<int>(k));
  return duals;
}

/// \param  leverage   multiplies the last slope: d(variable of the scatter)/d(variable of the derivative)
template <std::size_t n>
RelaxationFactor with_error(const Dual<n>& factor, const double (&covariance)[n][n],
                            const kernel::Scatter& scatter, double leverage) {
  constexpr int size = static_cast<int>(n);
  const Eigen::Matrix<double, size, 1> slopes = factor.derivatives().template head<size>();
  const Eigen::Map<const Eigen::Matrix<double, size, size>> matrix(&covariance[0][0]);
  const double h = factor.value();
  if (!(h > 0))
    return {};
  const double shift = scatter.gain * leverage * factor.derivatives()[size] / h;
  const double variance = slopes.dot(matrix * slopes) / (h * h) + scatter.base * scatter.base + shift * shift;
  return {.value = h, .relative_error = std::sqrt(variance)};
}

RelaxationFactor shear_factor(double z, double r, double b) {
  constexpr std::size_t n = kernel::shear_coefficients.size();
  using D = Dual<n>;
  const D z_variable(z, static_cast<int>(n) + 1, static_cast<int>(n));
  return with_error<n>(
      kernel::shear_relaxation(z_variable, D(r), D(b), variables(kernel::shear_coefficients)),
      kernel::shear_covariance, kernel::shear_scatter, 1);
}

RelaxationFactor bulk_factor(double z, double r, double b) {
  constexpr std::size_t n = kernel::bulk_coefficients.size();
  using D = Dual<n>;
  const D r_variable(r, static_cast<int>(n) + 1, static_cast<int>(n));
  return with_error<n>(kernel::bulk_relaxation(D(z), r_variable, D(b), variables(kernel::bulk_coefficients)),
                       kernel::bulk_covariance, kernel::bulk_scatter, r);
}

std::string text(const char* format, double first, double second = 0) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, first, second);
  return buffer;
}

double isostatic(double r) {
  return r > 0 ? kernel::frictional_isostatic(kernel::shear_coefficients) : frictionless_isostatic;
}

void note_range(double z, double r, Validity& validity) {
  if (z < smallest_coordination || z > largest_coordination)
    validity.add(text("z* is %.3g: the relaxation factors are calibrated from 4.1 to 8.7", z));
  if (r > largest_ratio)
    validity.add(text("k_t/k_n is %.3g: the relaxation factors are calibrated up to 1", r));
  if (r > 0 && r < smallest_ratio)
    validity.add(text("k_t/k_n is %.3g: between 0 and 0.1 the relaxation factor of K depends on the "
                      "tangential forces that the packing carries, which are not known",
                      r));
}

/// ln of the stretch, and the standard error of that.
struct Stretch {
  double logarithm = 0;
  double error = 0;
};

double log_stress_ratio(const State& s) { return s.stress_h > 0 ? std::log(s.stress_v / s.stress_h) : 0; }

Stretch stretch_of(const State& s, double shear) {
  const fabric::SecondMoments F = fabric::second_moments(s.fabric_anisotropy);
  const double b = s.law.stiffness_exponent();
  const double log_fabric = std::log(F.F33 / F.F11);
  const double log_stress = log_stress_ratio(s);
  const double logarithm =
      kernel::log_stretch(shear, b, log_fabric, log_stress, kernel::stretch_coefficients);
  const Eigen::Vector2d slopes = (1 - shear) * Eigen::Vector2d(log_fabric, b * log_stress);
  const Eigen::Map<const Eigen::Matrix2d> covariance(&kernel::stretch_covariance[0][0]);
  const double scatter = kernel::stretch_scatter * logarithm;
  return {logarithm, std::sqrt(slopes.dot(covariance * slopes) + scatter * scatter)};
}

void note_state(const State& s, double z, Validity& validity) {
  if (z < 0.99 * s.coordination_number)
    validity.add(text("z* = %.4g is smaller than C_n = %.4g: taking rattlers out cannot lower the "
                      "coordination number",
                      z, s.coordination_number));
  const double overlap = s.law.overlap(mean_contact_force(s)) / (2 * s.radius);
  if (overlap > largest_overlap)
    validity.add(
        text("mean overlap is %.3g diameters: beyond 0.01 the closed forms, which take branches to be "
             "as long as the diameter, are too stiff",
             overlap));
  const double ratio = s.stress_h > 0 ? std::max(s.stress_v / s.stress_h, s.stress_h / s.stress_v) : 1;
  if (ratio > largest_stress_ratio || std::abs(s.fabric_anisotropy) > largest_anisotropy)
    validity.add(text("stress ratio %.3g or fabric anisotropy %.3g is beyond what the relaxation of "
                      "anisotropic packings was compared with (2.2 and 0.25)",
                      ratio, s.fabric_anisotropy));
}

} // namespace

double mechanical_coordination_number(double coordination_number, double rattler_fraction) {
  require_non_negative("coordination_number", coordination_number);
  require_closed("rattler_fraction", rattler_fraction, 0, 1);
  require_positive("1 - rattler_fraction", 1 - rattler_fraction);
  return coordination_number / (1 - rattler_fraction);
}

Relaxation relaxation(double mechanical_coordination_number, double tangential_ratio,
                      double stiffness_exponent) {
  const double z = require_non_negative("mechanical_coordination_number", mechanical_coordination_number);
  const double r = require_non_negative("tangential_ratio", tangential_ratio);
  const double b = require_closed("stiffness_exponent", stiffness_exponent, 0, 0.5);
  Relaxation relaxation;
  if (z > isostatic(r)) {
    const double near_z = std::min(z, infinite), near_r = std::min(r, infinite);
    relaxation.shear = shear_factor(near_z, near_r, b);
    relaxation.bulk = bulk_factor(near_z, near_r, b);
  } else {
    relaxation.validity.add(
        text("z* = %.4g is not above the isostatic point %.4g: such a network of contacts is not rigid", z,
             isostatic(r)));
  }
  note_range(z, r, relaxation.validity);
  return relaxation;
}

RelaxedEstimate relaxed(const State& state, double mechanical_coordination_number) {
  const Estimate uniform = uniform_strain(state);
  const Relaxation factors =
      relaxation(mechanical_coordination_number, state.tangential_ratio, state.law.stiffness_exponent());
  RelaxedEstimate estimate{.stiffness = {}, .relative_error = {}, .validity = uniform.validity};
  estimate.validity.merge(factors.validity);
  note_state(state, mechanical_coordination_number, estimate.validity);
  if (!(factors.shear.value > 0))
    return estimate;
  const elastic::TransverselyIsotropic& u = uniform.stiffness;
  const Stretch stretch = stretch_of(state, factors.shear.value);
  const kernel::RelaxedConstants<double> c = kernel::relax<double>(
      {u.C11, u.C33, u.C12, u.C13, u.C44}, factors.bulk.value, factors.shear.value, stretch.logarithm);
  estimate.stiffness = {.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
  const double stresses = std::abs(log_stress_ratio(state));
  const double shear_error = std::hypot(factors.shear.relative_error, kernel::shear_by_stress * stresses);
  const double bulk_error = std::hypot(factors.bulk.relative_error, kernel::bulk_by_stress * stresses);
  estimate.relative_error = {.bulk_modulus = bulk_error,
                             .G_hh = std::hypot(shear_error, stretch.error / 3),
                             .G_vh = std::hypot(shear_error, stretch.error / 6)};
  return estimate;
}

} // namespace granum::effective
