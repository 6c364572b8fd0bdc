// SPDX-License-Identifier: GPL-3.0-or-later
// The coefficients of the source as polynomials in k, with its own letters: the pair's response to the mean
// strain (omega, alpha), the contribution of its neighbours (gamma, rho), and their products (kappa, eta) in
// the second and third order of 3/k.
#include <granum/rock_physics/jenkins.hpp>

#include <numbers>

#include <granum/core/error.hpp>
#include <granum/rock_physics/hertz_mindlin.hpp>

namespace granum::rock_physics {

namespace {

/// [c0 (k-2)(k-4) + c1 k(k-2) + c2 k(k-4) + c3 k^2]/(16 pi): neighbours of two or of one of a pair's spheres.
double neighbours(double k, double c0, double c1, double c2, double c3) {
  return (c0 * (k - 2) * (k - 4) + c1 * k * (k - 2) + c2 * k * (k - 4) + c3 * k * k) /
         (16 * std::numbers::pi);
}

} // namespace

double jenkins_shear_factor(double coordination_number) {
  const double k = require_closed("coordination_number", coordination_number, 5.1, 11);

  const double alpha_1 = (19 * k - 22) / 48;
  const double alpha_2 = (18 - 9 * k) / 48;
  const double omega_1 = (166 - 11 * k) / 128;
  const double omega_2 = -(k + 14) / 128;
  const double omega_mean = (38 - 11 * k) / 128;

  const double gamma_1 = omega_mean - neighbours(k, 0.52, 0.10, -0.13, -0.01);
  const double gamma_2 = omega_2 + neighbours(k, 0.44, -0.24, -0.11, -0.14);
  const double kappa_1 = gamma_1 - (alpha_1 + alpha_2) * omega_mean - 2 * omega_2 * alpha_2;
  const double kappa_2 = gamma_2 - omega_2 * alpha_1;

  const double eta_1 = alpha_1 + neighbours(k, 1.96, 3.30, 0.49, 0.32) - alpha_1 * alpha_1;
  const double eta_2 = alpha_2 - neighbours(k, 2.16, 2.30, 0.54, -0.06) - (2 * alpha_1 + alpha_2) * alpha_2;
  const double xi_1 = (eta_1 + eta_2) * omega_1 + 2 * eta_2 * omega_2;
  const double xi_2 = eta_1 * omega_2;

  const double order = 3 / k;
  const double first = omega_1 + 2 * omega_2, second = kappa_1 + 2 * kappa_2, third = xi_1 + 2 * xi_2;
  return 1 - 2 * order * (first - order * (second - order * third));
}

double jenkins_shear_modulus(const SpherePacking& packing) {
  if (packing.no_slip_fraction != 0)
    throw InvalidArgument("no_slip_fraction", packing.no_slip_fraction, "",
                          "{0}: the theory is made for frictionless spheres");
  return jenkins_shear_factor(packing.coordination_number) * hertz_mindlin(packing).shear_modulus;
}

} // namespace granum::rock_physics
