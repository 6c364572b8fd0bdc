// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/hardin/equation.hpp>

/// Eq. (1) fitted to measured moduli.
/// Checked by tests/hardin/test_fit.cpp
namespace granum::hardin {

/// One measured modulus G_ij > 0 [Pa] and the state it was measured at.
struct MeasuredModulus {
  double shear_modulus = 0;
  SoilState state;
};

enum class Weights {
  relative, ///< residuals of ln G: every modulus counts alike
  absolute, ///< residuals of G: large moduli count more; as in a plain non-linear regression, and the
            ///< paper's
};

struct FitOptions {
  double atmospheric_pressure = 0; ///< p_a > 0 [Pa], no default
  VoidRatioFunction void_ratio_function = VoidRatioFunction::hardin_richart_round;
  Weights weights = Weights::relative;
  std::size_t iteration_limit = 100;
};

struct Fit {
  Equation equation;                  ///< with the fitted constants; m = n = s/2 where only s was fitted
  Measured coefficient;               ///< C [1]
  std::optional<Measured> exponent_i; ///< m [1]; empty if only s was fitted
  std::optional<Measured> exponent_j; ///< n [1]; the same
  Measured exponent_sum;              ///< s = m + n [1], its error with the covariance of m and n

  std::vector<std::string> parameters;         ///< C, m, n or C, s: the order of the covariance
  std::vector<std::vector<double>> covariance; ///< from the scatter of the residuals
  std::optional<double> r_squared;    ///< of ln G or G, as weighted; empty if all measured values are equal
  std::vector<double> residuals;      ///< measured minus fitted G, one a row [Pa]
  double rms_relative_residual = 0;   ///< of G measured over G fitted, minus 1 [1]
  std::size_t degrees_of_freedom = 0; ///< rows minus parameters
  Validity validity;

  /// Correlation of m and n [1], where both were fitted.
  [[nodiscard]] double correlation() const {
    return covariance[1][2] / std::sqrt(covariance[1][1]) / std::sqrt(covariance[2][2]);
  }
};

enum class FitStatus { converged, iteration_limit, no_progress };

/// The outcome of a fit. Its results are accessible only if the iteration converged.
class [[nodiscard]] FitReport {
 public:
  FitReport(FitStatus status, std::size_t iterations, Fit last);

  [[nodiscard]] FitStatus status() const { return status_; }
  /// Steps of the non-linear iteration; 0 if the log-linear start was already the solution.
  [[nodiscard]] std::size_t iterations() const { return iterations_; }
  /// \throws   NotConverged unless the status is converged
  [[nodiscard]] const Fit& fit() const;
  /// Where the iteration stopped, converged or not.
  [[nodiscard]] const Fit& last() const { return last_; }

 private:
  FitStatus status_;
  std::size_t iterations_;
  Fit last_;
};

/// Whether a row can be fitted: G and stresses positive and finite, void ratio within the range of the
/// function.
/// \throws   InvalidArgument naming the invalid value
void require_valid(const MeasuredModulus& row, VoidRatioFunction function);

/// C, m and n by least squares: log-linear start, then trust-region Levenberg-Marquardt. [More1978]
/// Assumes   independent errors of equal size in what is weighted (ln G or G), exact stresses.
/// \param    rows  at least 4
/// \throws   InvalidArgument if a row is not valid, if there are too few, or if the stresses do not separate
///           m from n: on a path of constant sigma_i/sigma_j only s = m + n has a meaning, see
///           fit_exponent_sum. The limit is a scatter across the path of 1e-3 of that along it, in ln sigma:
///           finer than stresses are measured.
/// Accuracy  data that obey Eq. (1) give C, m, n back to 1e-10; standard errors to first order in the scatter
FitReport fit(std::span<const MeasuredModulus> rows, const FitOptions& options);

/// C and s alone, with m = n = s/2: for paths of constant sigma_i/sigma_j, such as isotropic compression.
/// The value of s does not depend on the split on such a path; C does unless sigma_i = sigma_j, which a note
/// then says.
/// \param    rows  at least 3
/// \throws   InvalidArgument if a row is not valid, if there are too few, or if all have the same stress
FitReport fit_exponent_sum(std::span<const MeasuredModulus> rows, const FitOptions& options);

} // namespace granum::hardin
