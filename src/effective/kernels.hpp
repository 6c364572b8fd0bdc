// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas that the public functions of this module share. They are templates on the number type,
// so that one formula serves values (double) and values with their derivatives (dual.hpp).
#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include <granum/core/quadrature.hpp>
#include <granum/effective/state.hpp>

namespace granum::effective::kernel {

/// Means over contacts of w, w n3^2 and w n3^4 for a weight w(gamma); by symmetry about axis 3 they hold all
/// means of w n_i n_j and w n_i n_j n_k n_l.
template <class T>
struct AxialMoments {
  T m0{};
  T m2{};
  T m4{};
};

/// The five constants of a transversely isotropic stiffness.
template <class T>
struct Constants {
  T C11{};
  T C33{};
  T C12{};
  T C13{};
  T C44{};
};

/// What the mean strain leaves to the grains.
enum class Spin {
  none, ///< no grain spins
  free  ///< all grains spin alike, as the energy likes best
};

/// <w n1^2>.
template <class T>
T horizontal_square(const AxialMoments<T>& m) {
  return 0.5 * (m.m0 - m.m2);
}
/// <w n1^2 n2^2> = <w sin^4>/8; <w n1^4> is three times as much.
template <class T>
T horizontal_pair(const AxialMoments<T>& m) {
  return 0.125 * ((m.m0 - m.m2) - (m.m2 - m.m4));
}
/// <w n1^2 n3^2>.
template <class T>
T mixed_pair(const AxialMoments<T>& m) {
  return 0.5 * (m.m2 - m.m4);
}

/// Moments of the weight 1 over E(gamma; a): 1, F33 and <n3^4>, as in fabric/orientation.hpp.
template <class T>
AxialMoments<T> fabric_moments(const T& a) {
  const T scale = 1 / (35 * (3 - a));
  return {.m0 = T(1), .m2 = 7 * (5 + a) * scale, .m4 = 3 * (7 + 3 * a) * scale};
}

/// Uniform strain, w = k_n/k_ref, scale = P k_ref, r = k_t/k_n. A free spin takes the harmonic mean of
/// A_1 = <k_t n1^2> and A_3 = <k_t n3^2> where no spin takes the arithmetic one; in the horizontal plane both
/// are A_1.
template <class T>
Constants<T> uniform_strain(const T& scale, const T& r, const AxialMoments<T>& w, Spin spin) {
  const T n1122 = horizontal_pair(w);
  const T n1133 = mixed_pair(w);
  const T n11 = horizontal_square(w);
  const T sum = n11 + w.m2;
  const T quarter_sum = spin == Spin::free ? T(n11 * w.m2 / sum) : T(0.25 * sum);
  const T slope = scale * (1 - r);
  const T shear = scale * r;
  return {.C11 = 3 * slope * n1122 + shear * n11,
          .C33 = slope * w.m4 + shear * w.m2,
          .C12 = slope * n1122,
          .C13 = slope * n1133,
          .C44 = slope * n1133 + shear * quarter_sum};
}

/// Uniform stress, w = k_ref/k_n, F the moments of the fabric. The axisymmetric stresses are spanned by F,
/// whose forces are purely normal, and by a vertical stress: their compliances stay finite multiples of 1/k_n
/// and 1/k_t, and the inverse holds for r = 0.
template <class T>
Constants<T> uniform_stress(const T& scale, const T& r, const AxialMoments<T>& F, const AxialMoments<T>& w) {
  const T F11 = horizontal_square(F);
  const T F33 = F.m2;
  const T vertical = r * w.m4 + (w.m2 - w.m4);
  const T inverse = scale / (w.m0 * vertical - r * (w.m2 * w.m2));
  const T biaxial = F11 * F11 * (inverse * vertical); // (C11 + C12)/2
  const T n11 = horizontal_square(w);
  const T horizontal_shear = r * scale * F11 * F11 / (4 * (r - 1) * horizontal_pair(w) + 2 * n11);
  const T ratio = F11 / F33;
  const T pair = 1 + ratio;
  const T vertical_shear =
      r * scale * F11 * F11 / ((r - 1) * pair * pair * mixed_pair(w) + ratio * ratio * w.m2 + n11);
  return {.C11 = biaxial + horizontal_shear,
          .C33 = F33 * F33 * (inverse * (vertical + r * (w.m0 - 2 * w.m2))),
          .C12 = biaxial - horizontal_shear,
          .C13 = F11 * F33 * (inverse * (vertical - r * w.m2)),
          .C44 = vertical_shear};
}

/// Numbers of a packing that forces and moduli are made of.
template <class T>
struct Geometry {
  T prefactor{};  ///< P = N_c l^2/V [1/m]
  T force_area{}; ///< l/P: a contact force is force_area stress F^-1 n [m^2]
};

template <class T>
Geometry<T> geometry(const T& coordination_number, const T& radius, const T& void_ratio) {
  const T cell = 2 * std::numbers::pi * radius * (1 + void_ratio); // 3 C_n l/(2 R P)
  return {.prefactor = 3 * coordination_number / cell,
          .force_area = 2 * radius * cell / (3 * coordination_number)};
}

inline Geometry<double> geometry(const State& s) {
  return geometry(s.coordination_number, s.radius, s.void_ratio);
}

/// Stresses F^-1 sigma of the static field; its contact forces are force_area times as much.
template <class T>
struct NormalLoads {
  T horizontal{};
  T vertical{};
};

template <class T>
NormalLoads<T> static_loads(const T& a, const T& stress_v, const T& stress_h) {
  const T scale = 5 * (3 - a);
  return {.horizontal = stress_h * (scale / (5 - 3 * a)), .vertical = stress_v * (scale / (5 + a))};
}

/// k_n of the force area x load; forces too small to be held are lifted into the range of numbers first.
double contact_stiffness(const contact::PowerLaw& law, double area, double load);

/// x^exponent for x within some decades of 1, where this spends 2 ulp and is faster than pow.
inline double power(double x, double exponent) { return std::exp(exponent * std::log(x)); }

/// Upper half of the Gauss-Legendre rule that is exact to rounding for a ratio of the larger to the smaller
/// end of the weight's base (see direction_moments), at most 1e4.
std::span<const QuadratureNode> rule_for(double ratio);

/// Means over E(gamma; a) of power(f) n3^k, f = horizontal sin^2 gamma + vertical cos^2 gamma, where
/// horizontal vertical = 1. They are integrals over x = n3 from 0 to 1 whose branch points approach the
/// interval as A/B = horizontal/vertical leaves 1. The substitution tan(gamma) -> c tan(gamma),
/// c^2 = sqrt(A/B), halves that ratio on a logarithmic scale and makes both sides of 1 alike:
///   x^2 = c^2 y^2/g,  1 - x^2 = (1 - y^2)/g,  dx = c g^(-3/2) dy,  g = 1 + (c^2-1) y^2.
/// A Gauss-Legendre rule of n points in y then errs by about exp(-2 n artanh((A/B)^(-1/4))), A > B, times a
/// power of n that is not small: rule_for holds what was measured. Nodes are plain numbers, c2 = sqrt(A/B)
/// among them: derivatives are taken at a fixed x.
template <class T, class Power>
AxialMoments<T> direction_moments(const T& a, const T& horizontal, const T& vertical, double c2, Power power,
                                  std::span<const QuadratureNode> rule) {
  const double c = std::sqrt(c2);
  AxialMoments<T> sum{.m0 = T(0), .m2 = T(0), .m4 = T(0)};
  for (const auto& [y, weight] : rule) {
    const double y2 = y * y;
    const double per_g = 1 / (1 + (c2 - 1) * y2);
    const double x2 = c2 * y2 * per_g;
    const T f = ((1 - y2) * per_g) * horizontal + x2 * vertical;
    const T term = (1 + (2 * x2 - 1) * a) * power(f) * (weight * c * per_g * std::sqrt(per_g));
    sum.m0 += term;
    sum.m2 += x2 * term;
    sum.m4 += (x2 * x2) * term;
  }
  const T scale = 3 / (3 - a);
  return {.m0 = scale * sum.m0, .m2 = scale * sum.m2, .m4 = scale * sum.m4};
}

} // namespace granum::effective::kernel
