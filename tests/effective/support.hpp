// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <granum/effective/uniform_field.hpp>

/// What the tests of closed forms share: states, and the same stiffness by brute summation over directions.
namespace granum::test {

using effective::State;

constexpr double infinity = std::numeric_limits<double>::infinity();

inline bool close(double a, double b, double relative) { return std::abs(a - b) <= relative * std::abs(b); }

/// Law of shape alpha for grains of some half millimetre.
inline contact::PowerLaw law_of(double alpha, double poisson_ratio, double radius = 5e-4,
                                double modulus = 30e9) {
  const contact::GrainMaterial grain{modulus, poisson_ratio};
  if (std::isinf(alpha))
    return contact::PowerLaw::flat(grain, 0.0114 * radius);
  if (alpha == 1)
    return contact::PowerLaw::cone(grain, 0.4);
  if (alpha == 2)
    return contact::PowerLaw::sphere(grain, radius);
  return contact::PowerLaw::general(grain, alpha, 0.4 * std::pow(radius, 1 - std::min(alpha, 40.0)));
}

/// Slope of a function at 0 by differences of fourth order: truncation ~ h^4 = 2e-11, rounding 1e-14/h.
template <class Function>
double slope_of(const Function& f) {
  constexpr double h = 2e-3;
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

/// A packing like the ones of the paper's Table 1.
inline State state_of(double alpha, double anisotropy, double poisson_ratio, double stress_v,
                      double stress_h) {
  return {.law = law_of(alpha, poisson_ratio),
          .tangential_ratio = contact::mindlin_stiffness_ratio(poisson_ratio),
          .radius = 5e-4,
          .void_ratio = 0.558,
          .coordination_number = 5.73,
          .fabric_anisotropy = anisotropy,
          .stress_v = stress_v,
          .stress_h = stress_h};
}

/// What is left of the moduli at branches D (1 - w) in place of D, w the overlap at the mean force:
/// (1 - w)^(2-b).
inline double shortened(const State& s) {
  const double force = effective::mean_contact_force(s);
  const double w = force > 0 ? s.law.overlap(force) / (2 * s.radius) : 0;
  return std::pow(1 - w, 2 - effective::contact_exponent(s));
}

/// What that takes from the sum of the exponents of stress at constant contacts, at one b:
/// (2-b)(1-b) w/(1-w).
inline double lost_exponent(const State& s) {
  const double b = s.law.constant_exponent().value(), force = effective::mean_contact_force(s);
  const double w = force > 0 ? s.law.overlap(force) / (2 * s.radius) : 0;
  return (2 - b) * (1 - b) * w / (1 - w);
}

/// One direction of contacts: its share of all contacts and its stiffnesses.
struct Direction {
  Eigen::Vector3d normal;
  double share = 0;
  double k_n = 0;
  double k_t = 0;
};

/// Mandel basis of the symmetric tensors.
std::array<Eigen::Matrix3d, 6> symmetric_basis();

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Energy of contacts that follow the mean strain: P sum share (k_n u_n^2 + k_t u_t^2), u = strain n.
Matrix6 stiffness_by_strain(double P, const std::vector<Direction>& directions);

/// Complementary energy of contact forces (l/P) stress F^-1 n, inverted.
Matrix6 stiffness_by_stress(double P, const std::vector<Direction>& directions);

/// Directions of E(gamma; a) on a dense grid over the sphere, each with k_n of the force that the static
/// hypothesis gives it: f_n = V/(N_c l) n . stress F^-1 n, from the numbers of grains and contacts in a cubic
/// metre.
std::vector<Direction> directions_of(const State& s, int along = 160);

/// P = N_c l^2/V from the same numbers.
inline double contact_density(const State& s) {
  const double grains = 1 / (4.0 / 3 * M_PI * std::pow(s.radius, 3) * (1 + s.void_ratio));
  return grains * *s.coordination_number / 2 * 4 * s.radius * s.radius;
}

/// Largest difference of the five constants: C11, C33, C44 relative to themselves, C12 and C13, which may
/// vanish, relative to C11.
inline double difference(const elastic::TransverselyIsotropic& c, const Matrix6& mandel) {
  return std::max({std::abs(c.C11 / mandel(0, 0) - 1), std::abs(c.C33 / mandel(2, 2) - 1),
                   std::abs(2 * c.C44 / mandel(3, 3) - 1), std::abs(2 * c.C66() / mandel(5, 5) - 1),
                   std::abs(c.C12 - mandel(0, 1)) / mandel(0, 0),
                   std::abs(c.C13 - mandel(0, 2)) / mandel(0, 0)});
}

inline double difference(const elastic::TransverselyIsotropic& a, const elastic::TransverselyIsotropic& b) {
  return std::max({std::abs(a.C11 / b.C11 - 1), std::abs(a.C33 / b.C33 - 1), std::abs(a.C44 / b.C44 - 1),
                   std::abs(a.C12 - b.C12) / b.C11, std::abs(a.C13 - b.C13) / b.C11});
}

inline bool all_finite(const elastic::TransverselyIsotropic& c) {
  return std::isfinite(c.C11) && std::isfinite(c.C33) && std::isfinite(c.C12) && std::isfinite(c.C13) &&
         std::isfinite(c.C44);
}

} // namespace granum::test
