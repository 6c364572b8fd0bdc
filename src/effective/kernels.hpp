// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas that the public functions of this module share. They are templates on the number type,
// so that one formula serves values (double) and values with their derivatives (LogDual).
#pragma once

#include <numbers>

#include <granum/effective/state.hpp>
#include <granum/fabric/orientation.hpp>

namespace granum::effective::kernel {

/// A number with its derivatives by ln stress_v and ln stress_h.
struct LogDual {
  double value = 0;
  double v = 0;
  double h = 0;
};

inline LogDual operator+(LogDual a, LogDual b) { return {a.value + b.value, a.v + b.v, a.h + b.h}; }
inline LogDual operator-(LogDual a, LogDual b) { return {a.value - b.value, a.v - b.v, a.h - b.h}; }
inline LogDual operator*(double s, LogDual a) { return {s * a.value, s * a.v, s * a.h}; }
inline LogDual operator*(LogDual a, LogDual b) {
  return {a.value * b.value, a.v * b.value + a.value * b.v, a.h * b.value + a.value * b.h};
}
inline LogDual operator/(LogDual a, LogDual b) {
  const double q = a.value / b.value;
  return {q, (a.v - q * b.v) / b.value, (a.h - q * b.h) / b.value};
}
inline LogDual operator/(double s, LogDual a) { return LogDual{s, 0, 0} / a; }

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

/// <w n1^2 n2^2> = <w sin^4>/8; <w n1^4> is three times as much.
template <class T>
T horizontal_pair(const AxialMoments<T>& m) {
  return 0.125 * ((m.m0 - m.m2) - (m.m2 - m.m4));
}

/// Uniform strain, w = k_n/k_ref, scale = P k_ref, r = k_t/k_n.
template <class T>
Constants<T> uniform_strain(double scale, double r, const AxialMoments<T>& w) {
  const T n1122 = horizontal_pair(w);
  const T n1133 = 0.5 * (w.m2 - w.m4);
  const T n11 = 0.5 * (w.m0 - w.m2);
  return {.C11 = scale * (3 * (1 - r) * n1122 + r * n11),
          .C33 = scale * ((1 - r) * w.m4 + r * w.m2),
          .C12 = scale * ((1 - r) * n1122),
          .C13 = scale * ((1 - r) * n1133),
          .C44 = scale * ((1 - r) * n1133 + r / 4 * (n11 + w.m2))};
}

/// Uniform stress, w = k_ref/k_n. The axisymmetric stresses are spanned by F, whose forces are purely normal,
/// and by a vertical stress: their compliances stay finite multiples of 1/k_n and 1/k_t, and the inverse
/// holds for r = 0.
template <class T>
Constants<T> uniform_stress(double scale, double r, const fabric::SecondMoments& F,
                            const AxialMoments<T>& w) {
  const T vertical = r * w.m4 + (w.m2 - w.m4);
  const T inverse = scale / (w.m0 * vertical - r * (w.m2 * w.m2));
  const T biaxial = F.F11 * F.F11 * (inverse * vertical); // (C11 + C12)/2
  const T n11 = 0.5 * (w.m0 - w.m2);
  const T n1133 = 0.5 * (w.m2 - w.m4);
  const double pair = 1 / F.F11 + 1 / F.F33;
  const T horizontal_shear = r * scale * F.F11 * F.F11 / (4 * (r - 1) * horizontal_pair(w) + 2 * n11);
  const T vertical_shear =
      r * scale / ((r - 1) * pair * pair * n1133 + 1 / (F.F33 * F.F33) * w.m2 + 1 / (F.F11 * F.F11) * n11);
  return {.C11 = biaxial + horizontal_shear,
          .C33 = F.F33 * F.F33 * (inverse * (vertical + r * (w.m0 - 2 * w.m2))),
          .C12 = biaxial - horizontal_shear,
          .C13 = F.F11 * F.F33 * (inverse * (vertical - r * w.m2)),
          .C44 = vertical_shear};
}

/// P of the packing [1/m].
inline double prefactor(const State& s) {
  return 3 * s.coordination_number / (2 * std::numbers::pi * s.radius * (1 + s.void_ratio));
}

/// l/P stress F^-1 of the packing.
inline StaticForceField static_force_field(const State& s, const fabric::SecondMoments& F) {
  const double area = 2 * s.radius / kernel::prefactor(s);
  return {.horizontal = area * s.stress_h / F.F11, .vertical = area * s.stress_v / F.F33};
}

/// Means over E(gamma; a) of (k_n/k_ref)^sign n3^k in a static force field that varies with direction;
/// k_ref = k_n(sqrt(horizontal vertical)), b the exponent of k_n ~ f^b.
AxialMoments<double> stiffness_moments(double anisotropy, const StaticForceField& field, double b,
                                       double sign);
/// The same with derivatives; k_ref counts as a constant.
AxialMoments<LogDual> stiffness_moment_slopes(double anisotropy, const StaticForceField& field, double b,
                                              double sign);

} // namespace granum::effective::kernel
