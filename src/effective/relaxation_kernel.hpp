// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas of the relaxation factors, templates on the number type, so that one formula serves
// values (double) and values with their derivatives (e.g. Eigen's AutoDiffScalar). Private to src/effective
// and to validation/relaxation, which fits the coefficients of relaxation_coefficients.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <granum/effective/relaxation.hpp>
#include <granum/sizes/contact_means.hpp>

#include "relaxation_coefficients.hpp"
#include "rolling_coefficients.hpp"

namespace granum::effective::kernel {

/// z* at which a network of frictional contacts loses its rigidity: 4, less the effect of grains with two
/// contacts, each of which spins freely about the line through them.
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

/// The largest b of the laws with which the packings of the fit were made. Beyond it, the factors were fitted
/// to networks of k_n ~ f^b on those packings.
inline constexpr double largest_own_exponent = 0.5;

template <class T>
T up_to_half(const T& b) {
  return b > largest_own_exponent ? T(largest_own_exponent) : b;
}

/// How the factors of one kind of contact continue beyond the packings of the fit: from which b on, the loss
/// of G, and the power of the loss of K by the scatter of forces.
struct GoingOn {
  double from;
  double shear_loss;
  double scatter_power;
  std::array<double, 2> errors = {0, 0}; ///< additional ones of G and K at b = 1, over 1 - h
};
/// Contacts of one b at every force.
inline constexpr GoingOn power_laws{largest_own_exponent, power_law_losses[0], power_law_losses[1],
                                    power_law_errors};
/// Rough spheres in their own packings: smooth ones under large forces.
inline constexpr GoingOn rough_spheres{1.0 / 3, rough_losses[0], rough_losses[1], rough_errors};
[[nodiscard]] inline const GoingOn& going_on(contact::Stiffening stiffening) {
  return stiffening == contact::Stiffening::rough ? rough_spheres : power_laws;
}

/// How far b lies beyond `from`: 0 up to there, 1 at b = 1, where stiffness is proportional to force.
template <class T>
T share_beyond(const T& b, double from) {
  if (!(b > from))
    return T(0.0);
  return b < 1.0 ? T((b - from) / (1.0 - from)) : T(1.0);
}

/// The effect of b on both factors.
template <class T>
struct ByExponent {
  T own;  ///< b in the packings of the fit, from which the factors continue
  T lost; ///< -ln of the remaining factor of G, over 1 - h: larger the more grains leave the mean strain
  T scatter_left; ///< remaining part of the loss of K by the scatter of forces
};
/// For a b that occurs in the packings of the fit.
template <class T>
ByExponent<T> own_exponent(const T& b) {
  return {b, T(0.0), T(1.0)};
}
template <class T>
ByExponent<T> by_exponent(const T& b, const GoingOn& contacts) {
  using std::pow;
  const T beyond = share_beyond(b, contacts.from);
  if (!(beyond > 0.0))
    return own_exponent(b);
  const T left = 1.0 - beyond;
  return {T(contacts.from), T(contacts.shear_loss * beyond),
          left > 0.0 ? T(pow(left, contacts.scatter_power)) : T(0.0)};
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

/// Q: ln of K under uniform strain of the contacts as they are over that of contacts with the forces of the
/// closed form, between which forces of one direction are equal. Contacts that stiffen with force (b) lose
/// stiffness where forces are uneven; the factors are those of packings as uneven as the ones of the fit.
/// This is ln of a modulus of rung 3 with Q known over that without: its coefficients are those of Q, of Q
/// sqrt(v), of what grains leave the mean strain, of b(1-b), of b(1-b)(z* - 5), and of v, v the variance of
/// branches, alone and with the third.
/// \param  h   factor of G before; z and v as they are counted
template <class T>
T gain_by_unevenness(const T& Q, const T& h, const T& b, const T& z, double v,
                     const UnevennessCoefficients<T>& c) {
  constexpr double most_contacts = 8.7; // of the packings of the fit: beyond, nothing is drawn out
  const T left = 1.0 - h, stiffening = b * (1.0 - b),
          above = z < most_contacts ? T(z - 5.0) : T(most_contacts - 5.0);
  const T uneven = (c[0] + c[1] * std::sqrt(v)) * Q;
  const T usual = c[2] * left + stiffening * T(c[3] + c[4] * above);
  return uneven + usual + v * T(c[5] + c[6] * left);
}

/// Q of a dense packing; its coefficients are those of b(1-b), of b^2 (1-b), of b(1-b) times the square of
/// the overlap when friction came on over the present one, of v, and of b(1-b) (q/p)^2.
template <class T>
T unevenness_of_dense(const T& b, const T& faded, double v, double stress_ratio,
                      const DenseUnevenness<T>& c) {
  const T stiffening = b * (1.0 - b);
  return stiffening * T(c[0] + c[1] * b + c[2] * faded + c[4] * (stress_ratio * stress_ratio)) + c[3] * v;
}

/// 0 up to 0, 1 from 1 on, without a corner.
template <class T>
T smooth_step(const T& x) {
  return x >= 1.0 ? T(1.0) : x <= 0.0 ? T(0.0) : T(x * x * (3.0 - 2.0 * x));
}

/// Share of that gain which is applied: all above the lower of these z*, none below the other, where packings
/// are so soft that other things decide.
inline constexpr double lowest_uneven_coordination = 4.2, lowest_even_coordination = 4.4;
template <class T>
T share_of_unevenness(const T& z) {
  return smooth_step(
      T((z - lowest_uneven_coordination) / (lowest_even_coordination - lowest_uneven_coordination)));
}

/// The Q for which gain_by_unevenness is 0: that of packings as uneven as the ones of the fit.
inline double usual_unevenness(double h, double b, double z, double v,
                               const UnevennessCoefficients<double>& c) {
  return -gain_by_unevenness(0.0, h, b, z, v, c) / (c[0] + c[1] * std::sqrt(v));
}
/// Scatter of Q about it, and the z* of packings that were compressed without friction: from the first on,
/// none below the other.
inline constexpr double usual_unevenness_scatter = 0.016;
inline constexpr double least_dense_coordination = 5.5, dense_coordination = 5.8;

/// Overlap over the diameter up to which branches are shortened: beyond, grains are no longer grains.
inline constexpr double longest_shortening = 0.1;

/// Factor of all moduli for branches l = D (1 - w) that overlaps shorten, where uniform strain takes l = D:
/// the moduli go as k_n l^2, k_n as f^b, and the force as 1/l at a given stress. K of uniform strain of
/// recorded packings agrees within 6 % of the change [validation/relaxation].
/// \param  w   mean overlap over the diameter, up to longest_shortening
template <class T>
T shortened_branches(const T& w, const T& b) {
  using std::exp;
  using std::log;
  const T left = 1.0 - w, power = 2.0 - b;
  return exp(T(power * log(left)));
}

/// The relaxed stiffness from that of uniform strain. The amplitudes of volumetric and deviatoric strain are
/// multiplied by sqrt(bulk) and sqrt(shear); then the axis is stretched against the plane at constant volume,
/// so that C33/C11 grows by the factor stretch. Both steps are congruences: they preserve symmetry, positive
/// definiteness and transverse isotropy, and turn an isotropic stiffness at stretch 1 into (bulk K, shear G)
/// exactly.
template <class T>
struct RelaxedConstants {
  T C11, C33, C12, C13, C44;
};
template <class T>
T bulk_modulus(const RelaxedConstants<T>& c) {
  return (2.0 * c.C11 + c.C33 + 2.0 * c.C12 + 4.0 * c.C13) / 9.0;
}
/// Before its upper bound is applied.
template <class T>
RelaxedConstants<T> unbounded_relax(const RelaxedConstants<T>& c, const T& bulk, const T& shear,
                                    const T& log_stretch) {
  using std::exp;
  using std::sqrt;
  // M = sqrt(bulk) J + sqrt(shear) (1 - J), J the volumetric projector: s 1 + t J. On the normal block,
  // (M C M)_ij = s^2 C_ij + s t (p_i + p_j)/3 + t^2 p/9 with p_i the row sums and p their sum.
  const T s = sqrt(shear);
  const T t = sqrt(bulk) - s;
  const T row_h = c.C11 + c.C12 + c.C13;
  const T row_v = c.C33 + 2.0 * c.C13;
  const T mean = (2.0 * row_h + row_v) / 9.0;
  const T common = t * t * mean;
  const T hh = 2.0 / 3.0 * s * t * row_h + common;
  const T vv = 2.0 / 3.0 * s * t * row_v + common;
  const T hv = s * t * (row_h + row_v) / 3.0 + common;
  const T sixth = exp(log_stretch / 6.0);
  const T plane = 1.0 / (sixth * sixth);
  const T axis = sixth * sixth * sixth * sixth;
  return {T(plane * (shear * c.C11 + hh)), T(axis * (shear * c.C33 + vv)), T(plane * (shear * c.C12 + hh)),
          T(sixth * (shear * c.C13 + hv)), T(sixth * shear * c.C44)};
}

/// Fabric and stresses far beyond the calibration, both along the axis, give a stretch that raises K above
/// that of uniform strain, its upper bound: then all constants are scaled down to it.
template <class T>
RelaxedConstants<T> relax(const RelaxedConstants<T>& c, const T& bulk, const T& shear, const T& log_stretch) {
  const RelaxedConstants<T> r = unbounded_relax(c, bulk, shear, log_stretch);
  const T bound = bulk_modulus(c), K = bulk_modulus(r);
  if (!(K > bound && bound > 0.0))
    return r;
  const T share = bound / K;
  return {T(share * r.C11), T(share * r.C33), T(share * r.C12), T(share * r.C13), T(share * r.C44)};
}

/// ln of that stretch: directions with more or stiffer contacts relax less than the average.
/// \param  log_fabric  ln(F33/F11);  \param  log_stress  ln(stress_v/stress_h)
template <class T>
T log_stretch(const T& shear, const T& b, const T& log_fabric, const T& log_stress,
              const StretchCoefficients<T>& c) {
  const T anisotropy = c[0] * log_fabric + c[1] * b * log_stress;
  return (1.0 - shear) * anisotropy;
}

} // namespace granum::effective::kernel
