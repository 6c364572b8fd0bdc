// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas of the relaxation factors, templates on the number type, so that one formula serves
// values (double) and values with their derivatives (e.g. Eigen's AutoDiffScalar). Private to src/effective
// and to validation/relaxation, which fits the coefficients of relaxation_coefficients.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <granum/sizes/contact_means.hpp>

#include "relaxation_coefficients.hpp"
#include "rolling_coefficients.hpp"
#include "stiffening_kernel.hpp"

namespace granum::effective::kernel {

/// z* at which a network of frictional contacts loses its rigidity: 4, less the effect of grains with two
/// contacts, which spin freely about the line through them.
template <class T>
const T& frictional_isostatic(const ShearCoefficients<T>& c) {
  return c[7];
}
/// The same for contacts without tangential stiffness.
inline constexpr double frictionless_isostatic = 6;

/// Relative variance of the lengths of branches, <l^2>/<l>^2 - 1: exactly 0 where all grains are equal.
inline double branch_variance(const sizes::ContactMeans& means) {
  const double variance = means.branch_square / (means.branch * means.branch) - 1;
  return variance > 0 ? variance : 0;
}

/// Looseness of a z*: 1 at the isostatic point, a quarter at 0.5 above it.
template <class T>
T looseness(const T& z) {
  const T root = 1.0 / (1.0 + 2.0 * (z - frictional_isostatic(shear_coefficients)));
  return root * root;
}

/// z* at which equal grains have the G/G(uniform strain) of unequal ones. Networks of unequal grains are
/// stiffer than those of equal grains at the same mean number of contacts: more of their grains have two
/// contacts and spin freely, so that fewer contacts are needed for the others. K is not shifted: see
/// size_bulk_share.
template <class T>
T coordination_of_equal(const T& z, double variance) {
  return z + size_shift * variance * looseness(z);
}

/// Coefficients as numbers of another type, constants to it.
template <class T, std::size_t n>
std::array<T, n> constants(const std::array<double, n>& values) {
  std::array<T, n> numbers;
  for (std::size_t k = 0; k < n; ++k)
    numbers[k] = T(values[k]);
  return numbers;
}

/// Shear modulus of the network without tangential stiffness over its uniform-strain value, u = z - 6 > 0. It
/// has the slope `slope` at the isostatic point, tends to 1 far above, and is negative below.
template <class T>
T frictionless_branch(const T& u, const T& slope, const T& floor) {
  const T rise = slope * u;
  const T damping = u > 0.0 ? T(1.0 + rise) : T(1.0 - floor * u);
  return rise / damping;
}

/// The coupling of rolled_shear_relaxation where contacts resist rolling. A contact rolls and slides in
/// series, so that k_r/r decides how much of the spins' part in the relaxation is taken back; without any
/// spins the coupling is c_2 (1 + c_3 b) near the isostatic point and c_4 far from it, but never more than
/// uniform strain has.
/// \param    near_share   the share of the first
/// \param    k_r          rolling stiffness over k_n R*^2, > 0
template <class T, class C>
T rolled_coupling(const T& coupling, const T& near_share, const T& g0, const T& r, const T& b, double k_r,
                  const RollingShear<C>& c) {
  using std::exp;
  using std::log;
  const T far = 1.5 + 2.25 * r > c[4] ? T(1.5 + 2.25 * r) : T(0.0 * r + c[4]);
  const T spinless = near_share * T(c[2] * T(1.0 + c[3] * b)) + far * T(1.0 - near_share);
  const T affine = T(1.0 + 1.5 * r) * T(1.0 + 1.5 * r - g0) / r;
  const T most = spinless < affine ? spinless : affine;
  if (!(most > coupling))
    return coupling;
  const T held = c[0] * exp(T(c[1] * T(std::log(k_r) - log(r))));
  return coupling + T(most - coupling) * T(held / (1.0 + held));
}

/// G/G(uniform strain) of a packing of mechanical coordination number z, k_t = r k_n, k_n ~ f^b up to b =
/// 1/2. With g = h (2+3r)/2, the modulus over that of the normal stiffness alone: g^2 - g_0 g = r t, where
/// g_0 is the frictionless branch and t the coupling to the tangential stiffness, which vanishes at the
/// isostatic point. So h is 0 there, ~ sqrt(r) at z = 6 and small r, and 1 for z -> infinity at every r and
/// b.
/// \param    k_r   rolling stiffness over k_n R*^2
template <class T, class C = double>
T rolled_shear_relaxation(const T& z, const T& r, const T& b, const ShearCoefficients<T>& c, double k_r,
                          const RollingShear<C>& resisted = rolling_shear) {
  using std::sqrt;
  const auto& [slope, floor, strength, bend, hold, spread, reach, isostatic] = c;
  if (!(z > isostatic))
    return T(0.0);
  const T x = z - isostatic;
  const T u = z - frictionless_isostatic;
  const T g0 = frictionless_branch(u, slope, floor);
  const T ratio = x / reach;
  const T root_ratio = sqrt(ratio);
  const T power = ratio * ratio * root_ratio;
  const T near_share = 1.0 / (1.0 + power);
  const T growth = x / ((1.0 + bend * x) * (1.0 + hold * r));
  const T near_coupling = strength * (1.0 - spread * b * b) * growth;
  T coupling = near_share * near_coupling + (1.5 + 2.25 * r) / (1.0 + 1.0 / power);
  if (k_r > 0 && r > 0.0)
    coupling = rolled_coupling(coupling, near_share, g0, r, b, k_r, resisted);
  const T product = r * coupling;
  const T square = g0 * g0 + 4.0 * product;
  if (!(square > 0.0))
    return T(0.0);
  const T root = sqrt(square);
  // The positive root of the quadratic, without cancellation.
  const T g = g0 > 0.0 ? T(0.5 * (g0 + root)) : T(2.0 * product / (root - g0));
  return g / (1.0 + 1.5 * r);
}

/// The same without rolling resistance.
template <class T>
T shear_relaxation(const T& z, const T& r, const T& b, const ShearCoefficients<T>& c) {
  return rolled_shear_relaxation(z, r, b, c, 0);
}

/// Remaining share of the factor h of G beyond the packings of the fit.
template <class T>
T left_of_shear(const T& h, const ByExponent<T>& b) {
  using std::exp;
  const T logarithm = -b.lost * (1.0 - h);
  return exp(logarithm);
}

/// Divisor of the reduction of K by the scatter of forces.
template <class T>
T scatter_distance(const T& z, const T& b, const BulkCoefficients<T>& c) {
  const auto& [scatter, pole, tangential, tangential_pole, own, stiffening] = c;
  return z - pole + stiffening * b;
}

/// Share of the loss of K that is left where contacts resist rolling; nothing is known below the least r of
/// the fit, and without tangential stiffness spins do not matter.
template <class T, class C>
T left_of_bulk_loss(const T& z, const T& r, double k_r, const RollingBulk<C>& c) {
  using std::exp;
  using std::log;
  constexpr double least_ratio = 0.1;
  const T known = r < least_ratio ? T(r / least_ratio) : T(0.0 * r + 1.0);
  const T above = T(1.0 + 0.5 * (z - frictional_isostatic(shear_coefficients)));
  const T held = known * T(c[0] * exp(T(c[1] * std::log(k_r) - c[2] * log(above))));
  return 1.0 / (1.0 + held);
}

/// K/K(uniform strain, k_n of the mean force): the network is nearly as stiff as its forces, scaled with the
/// pressure, allow (the lower bound of bulk_modulus_bounds). The first term is the reduction by the scatter
/// of forces: smaller where contacts stiffen with force, and 0 at b = 1. The second is the reduction by
/// tangential forces: larger for smaller r. Both vanish for z -> infinity; at the isostatic point K has a
/// jump.
template <class T, class C = double>
T stiffened_bulk(const T& z, const T& r, const ByExponent<T>& b, const BulkCoefficients<T>& c, double k_r = 0,
                 const RollingBulk<C>& resisted = rolling_bulk) {
  const auto& [scatter, scatter_pole, tangential, tangential_pole, own, stiffening] = c;
  const T d1 = scatter_distance(z, b.own, c);
  const T d2 = z - tangential_pole;
  const T square = d2 * d2;
  const T uneven = scatter * b.scatter_left;
  T lost = uneven / d1 + tangential / (square * (r + own * square));
  if (k_r > 0)
    lost = T(lost * left_of_bulk_loss(z, r, k_r, resisted));
  return 1.0 / (1.0 + lost);
}

/// The same for a b that occurs in the packings of the fit.
template <class T>
T bulk_relaxation(const T& z, const T& r, const T& b, const BulkCoefficients<T>& c) {
  return stiffened_bulk(z, r, own_exponent(b), c);
}

/// Factor of K for unequal grains: their forces scatter more, which reduces K in the same way as the first
/// term of stiffened_bulk.
/// \param    loss   size_loss, or a trial value of a fit
template <class T>
T size_bulk_share(const T& z, const ByExponent<T>& b, const T& loss, double variance,
                  const BulkCoefficients<T>& c) {
  const T uneven = loss * variance * b.scatter_left;
  return 1.0 / (1.0 + uneven / scatter_distance(z, b.own, c));
}

/// The scatter of K between packings of unequal grains is proportional to this. Among the powers 1/2, 3/4 and
/// 1 of the variance, 3/4 gives the largest likelihood of the errors of all packings of the fit.
inline double bulk_size_measure(double variance) { return std::pow(variance, 0.75); }

} // namespace granum::effective::kernel
