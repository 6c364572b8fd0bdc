// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas of the relaxation factors, templates on the number type, so that one formula serves
// values (double) and values with their derivatives (e.g. Eigen's AutoDiffScalar). Private to src/effective
// and to validation/relaxation, which fits the coefficients of relaxation_coefficients.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <granum/effective/state.hpp>
#include <granum/sizes/contact_means.hpp>

#include "relaxation_coefficients.hpp"

namespace granum::effective::kernel {

/// z* at which a network of frictional contacts loses its rigidity: 4, less what grains with two contacts
/// take off, since each spins freely about the line through them.
template <class T>
const T& frictional_isostatic(const ShearCoefficients<T>& c) {
  return c[6];
}
/// The same for contacts without tangential stiffness.
inline constexpr double frictionless_isostatic = 6;

/// Relative variance of the lengths of branches, <l^2>/<l>^2 - 1: exactly 0 where all grains are equal.
inline double branch_variance(const sizes::ContactMeans& means) {
  const double variance = means.branch_square / (means.branch * means.branch) - 1;
  return variance > 0 ? variance : 0;
}

/// How much a z* above the isostatic point is of a loose packing: 1 there, a quarter 0.5 above.
template <class T>
T looseness(const T& z) {
  const T root = 1.0 / (1.0 + 2.0 * (z - frictional_isostatic(shear_coefficients)));
  return root * root;
}

/// z* at which equal grains have the G/G(uniform strain) of unequal ones, whose networks are stiffer than
/// their mean number of contacts tells: more of their grains have two contacts and spin freely, so that fewer
/// contacts hold the others. K is not shifted: see size_bulk_share.
template <class T>
T coordination_of_equal(const T& z, double variance) {
  return z + size_shift * variance * looseness(z);
}

/// What the relaxation of a network goes by.
template <class T>
struct NetworkInputs {
  T z;       ///< z*; of G that of equal grains
  T r;       ///< k_t/k_n
  T b;       ///< of k_n ~ f^b
  T scatter; ///< relative variance of the contact forces, <f^2>/<f>^2 - 1, of equal grains
};

/// Coefficients as numbers of another type, constants to it.
template <class T, std::size_t n>
std::array<T, n> constants(const std::array<double, n>& values) {
  std::array<T, n> numbers;
  for (std::size_t k = 0; k < n; ++k)
    numbers[k] = T(values[k]);
  return numbers;
}

/// Relative variance of the forces of a packing that tells nothing of them: it fades for z -> infinity, and
/// forces of unequal grains scatter more.
template <class T>
T expected_scatter(const T& z, double variance, const std::array<T, 3>& c) {
  using std::exp;
  const T power = -c[1] * (z - frictional_isostatic(shear_coefficients));
  return c[0] * (1.0 + c[2] * variance) * T(exp(power));
}
/// As equal grains have it, of unequal ones.
template <class T>
T scatter_of_equal(const T& scatter, double variance) {
  return scatter / (1.0 + force_coefficients[2] * variance);
}

/// K of uniform strain summed over contacts over that of the closed form, which takes k_n at the mean force:
/// where forces scatter, the mean of f^b is less than that of f to the power b.
/// \param    scatter   of equal grains
template <class T>
T expected_share(const T& b, const T& scatter, double variance, const std::array<T, 2>& c) {
  using std::exp;
  const T lost = -c[0] * (1.0 + c[1] * variance) * scatter * b * (1.0 - b);
  return exp(lost);
}
template <class T>
T expected_share(const T& b, const T& scatter, double variance) {
  return expected_share(b, scatter, variance, constants<T>(share_coefficients));
}

/// Shear modulus of the network without tangential stiffness over its uniform-strain value, u = z - 6 > 0: of
/// slope `slope` at the isostatic point and 1 far above. Below, continued to negative values.
template <class T>
T frictionless_branch(const T& u, const T& slope, const T& floor) {
  const T rise = slope * u;
  const T damping = u > 0.0 ? T(1.0 + rise) : T(1.0 - floor * u);
  return rise / damping;
}

/// G/G(uniform strain, summed over contacts) of a packing whose contacts are equally stiff.
/// With g = h (2+3r)/2, the modulus over that of the normal stiffness alone: g^2 - g_0 g = r t, where g_0 is
/// the frictionless branch and t the coupling to the tangential stiffness, which vanishes at the isostatic
/// point. So h is 0 there, ~ sqrt(r) at z = 6 and small r, and 1 for z -> infinity at every r.
template <class T>
T equal_stiffness_relaxation(const T& z, const T& r, const ShearCoefficients<T>& c) {
  using std::sqrt;
  const auto& [slope, floor, strength, bend, hold, reach, isostatic, roughness] = c;
  if (!(z > isostatic))
    return T(0.0);
  const T x = z - isostatic;
  const T u = z - frictionless_isostatic;
  const T g0 = frictionless_branch(u, slope, floor);
  const T ratio = x / reach;
  const T root_ratio = sqrt(ratio);
  const T power = ratio * ratio * root_ratio;
  const T near_share = 1.0 / (1.0 + power);
  const T near_coupling = strength * x / ((1.0 + bend * x) * (1.0 + hold * r));
  const T coupling = near_share * near_coupling + (1.5 + 2.25 * r) / (1.0 + 1.0 / power);
  const T product = r * coupling;
  const T square = g0 * g0 + 4.0 * product;
  if (!(square > 0.0))
    return T(0.0);
  const T root = sqrt(square);
  // The positive root of the quadratic, without cancellation.
  const T g = g0 > 0.0 ? T(0.5 * (g0 + root)) : T(2.0 * product / (root - g0));
  return g / (1.0 + 1.5 * r);
}

/// The same where stiffnesses scatter as f^b does, which lets the softest contacts yield.
template <class T>
T shear_relaxation(const NetworkInputs<T>& in, const ShearCoefficients<T>& c) {
  using std::exp;
  const auto& [slope, floor, strength, bend, hold, reach, isostatic, roughness] = c;
  const T h = equal_stiffness_relaxation(in.z, in.r, c);
  const T power = -roughness * (1.0 - h) * in.scatter * in.b * in.b;
  return h * T(exp(power));
}

/// K/K(uniform strain, summed over contacts): the network is nearly as stiff as its forces, scaled with the
/// pressure, allow (the lower bound of bulk_modulus_bounds). Their normal part costs the first term, nothing
/// where contacts stiffen as their forces (b = 1); their tangential part, the softer r is the more, the
/// second. Both fade for z -> infinity; at the isostatic point K has a jump.
template <class T>
T bulk_relaxation(const NetworkInputs<T>& in, const BulkCoefficients<T>& c) {
  const auto& [normal, pole, tangential, tangential_pole, own, even, uneven] = c;
  const T d2 = in.z - tangential_pole;
  const T square = d2 * d2;
  const T by_exponent = (1.0 - in.b) * (1.0 - (even + uneven * in.scatter) * in.b);
  const T lost = normal * by_exponent / (in.z - pole) + tangential / (square * (in.r + own * square));
  return 1.0 / (1.0 + lost);
}

/// What unequal grains keep of that K: their forces scatter more, which costs K as the scatter of equal ones
/// does in the first term of bulk_relaxation.
/// \param    loss   size_loss, or what a fit tries in its place
template <class T>
T size_bulk_share(const T& z, const T& loss, double variance, const BulkCoefficients<T>& c) {
  return 1.0 / (1.0 + loss * variance / (z - c[1]));
}

/// What rung 3 multiplies the closed form of uniform strain with.
template <class T>
struct RelaxedFactors {
  T share; ///< uniform strain summed over contacts over the closed form
  T shear; ///< G over that
  T bulk;  ///< K over that
};

/// Of a valid state of z* above the isostatic point; forces as they were counted, or as expected.
template <class T>
RelaxedFactors<T> relaxed_factors(const State& s, const T& z, const T& b) {
  const double variance = branch_variance(s.contacts);
  const T none = z * 0.0;
  const T scatter = s.forces ? T(none + scatter_of_equal(s.forces->scatter, variance))
                             : expected_scatter(z, 0, constants<T>(force_coefficients));
  const T share = s.forces ? T(none + s.forces->strain_share) : expected_share(b, scatter, variance);
  const NetworkInputs<T> in{.z = z, .r = T(none + s.tangential_ratio), .b = b, .scatter = scatter};
  NetworkInputs<T> of_equal = in;
  of_equal.z = coordination_of_equal(z, variance);
  const auto of_bulk = constants<T>(bulk_coefficients);
  return {.share = share,
          .shear = shear_relaxation(of_equal, constants<T>(shear_coefficients)),
          .bulk = bulk_relaxation(in, of_bulk) * size_bulk_share(z, T(none + size_loss), variance, of_bulk)};
}

/// What the scatter of K between unequal grains grows with: of the powers 1/2, 3/4 and 1 of the variance 3/4
/// makes the errors of all packings of the fit most likely.
inline double bulk_size_measure(double variance) { return std::pow(variance, 0.75); }

/// The stiffness that relaxation leaves of a uniform-strain one: volumetric and deviatoric strain keep
/// sqrt(bulk) and sqrt(shear) of their amplitudes, then the axis is stretched against the plane so that
/// C33/C11 grows by the factor stretch at constant volume. Both steps are congruences: symmetric, positive
/// definite and transversely isotropic they leave what was so, and an isotropic stiffness at stretch 1 turns
/// into (bulk K, shear G) exactly.
template <class T>
struct RelaxedConstants {
  T C11, C33, C12, C13, C44;
};
template <class T>
T bulk_modulus(const RelaxedConstants<T>& c) {
  return (2.0 * c.C11 + c.C33 + 2.0 * c.C12 + 4.0 * c.C13) / 9.0;
}
/// Before it is held to its bound.
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

/// A stretch far beyond those of the calibration, by fabric and stresses that both point along the axis,
/// raises K above that of uniform strain, its upper bound: then all constants are scaled down to it.
template <class T>
RelaxedConstants<T> relax(const RelaxedConstants<T>& c, const T& bulk, const T& shear, const T& log_stretch) {
  const RelaxedConstants<T> r = unbounded_relax(c, bulk, shear, log_stretch);
  const T bound = bulk_modulus(c), K = bulk_modulus(r);
  if (!(K > bound && bound > 0.0))
    return r;
  const T share = bound / K;
  return {T(share * r.C11), T(share * r.C33), T(share * r.C12), T(share * r.C13), T(share * r.C44)};
}

/// ln of that stretch: directions that hold more contacts, or stiffer ones, relax less than the average.
/// \param  log_fabric  ln(F33/F11);  \param  log_stress  ln(stress_v/stress_h)
template <class T>
T log_stretch(const T& shear, const T& b, const T& log_fabric, const T& log_stress,
              const StretchCoefficients<T>& c) {
  const T anisotropy = c[0] * log_fabric + c[1] * b * log_stress;
  return (1.0 - shear) * anisotropy;
}

} // namespace granum::effective::kernel
