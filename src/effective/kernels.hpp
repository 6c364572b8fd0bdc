// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas that the public functions of this module share. They are templates on the number type,
// so that one formula serves values (double) and values with their derivatives (stress_derivatives.hpp).
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <type_traits>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/effective/state.hpp>

namespace granum::effective::kernel {

/// Means over contacts of w sin^4, w sin^2 cos^2 and w cos^4 of gamma, for a weight w(gamma) >= 0. By
/// symmetry about axis 3 they determine all means of w n_i n_j and w n_i n_j n_k n_l, as sums without
/// differences.
template <class T>
struct AxialMoments {
  T s4{};
  T s2c2{};
  T c4{};
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

/// Freedom of the grains besides the mean strain.
enum class Spin {
  none, ///< no grain spins
  free  ///< all grains share the spin of least energy
};

/// <w>.
template <class T>
T mean_weight(const AxialMoments<T>& m) {
  return m.s4 + 2 * m.s2c2 + m.c4;
}
/// <w n1^2>.
template <class T>
T horizontal_square(const AxialMoments<T>& m) {
  return 0.5 * (m.s4 + m.s2c2);
}
/// <w n3^2>.
template <class T>
T vertical_square(const AxialMoments<T>& m) {
  return m.s2c2 + m.c4;
}
/// <w n1^2 n2^2>; <w n1^4> is three times as much.
template <class T>
T horizontal_pair(const AxialMoments<T>& m) {
  return 0.125 * m.s4;
}
/// <w n1^2 n3^2>.
template <class T>
T mixed_pair(const AxialMoments<T>& m) {
  return 0.5 * m.s2c2;
}

/// Moments of the weight 1 over E(gamma; a), whose <n3^2> is F33 of fabric/orientation.hpp.
template <class T>
AxialMoments<T> fabric_moments(const T& a) {
  const T norm = 35 * (3 - a);
  return {.s4 = 8 * (7 - 5 * a) / norm, .s2c2 = 2 * (7 - a) / norm, .c4 = 3 * (7 + 3 * a) / norm};
}

/// Uniform strain, w = k_n/k_ref, scale = P k_ref, r = k_t/k_n. A free spin takes the harmonic mean of
/// A_1 = <k_t n1^2> and A_3 = <k_t n3^2> where no spin takes the arithmetic one; in the horizontal plane both
/// are A_1.
template <class T>
Constants<T> uniform_strain(const T& scale, const T& r, const AxialMoments<T>& w, Spin spin) {
  const T n11 = horizontal_square(w);
  const T n33 = vertical_square(w);
  const T quarter_sum = spin == Spin::free ? T(n11 * n33 / (n11 + n33)) : T(0.25 * (n11 + n33));
  const T slope = scale * (1 - r);
  return {.C11 = scale * ((3 + r) * horizontal_pair(w) + r * mixed_pair(w)),
          .C33 = scale * (w.c4 + r * w.s2c2),
          .C12 = slope * horizontal_pair(w),
          .C13 = slope * mixed_pair(w),
          .C44 = slope * mixed_pair(w) + scale * r * quarter_sum};
}

/// Uniform stress, w = k_ref/k_n, F the moments of the fabric. The axisymmetric stresses are spanned by F,
/// whose forces are purely normal, and by a vertical stress: their compliances stay finite multiples of 1/k_n
/// and 1/k_t, and the inverse holds for r = 0.
template <class T>
Constants<T> uniform_stress(const T& scale, const T& r, const AxialMoments<T>& F, const AxialMoments<T>& w) {
  const T F11 = horizontal_square(F);
  const T F33 = vertical_square(F);
  const T vertical = r * w.c4 + w.s2c2;
  const T axial = w.s2c2 * mean_weight(w) + r * (w.s4 * w.c4 - w.s2c2 * w.s2c2);
  const T lateral = 0.5 * (1 + r) * w.s4 + w.s2c2;
  const T horizontal_scale = scale * F11 * F11;
  const T biaxial = horizontal_scale * vertical / axial; // (C11 + C12)/2
  const T horizontal_shear = horizontal_scale * r / lateral;
  const T q = F11 / F33;
  const T pair = 1 + q;
  const T vertical_shear =
      horizontal_scale * r /
      ((r - 1) * pair * pair * mixed_pair(w) + q * q * vertical_square(w) + horizontal_square(w));
  return {.C11 = biaxial + horizontal_shear,
          .C33 = scale * F33 * F33 * (w.s2c2 + r * w.s4) / axial,
          .C12 = biaxial - horizontal_shear,
          .C13 = scale * F11 * F33 * (1 - r) * w.s2c2 / axial,
          .C44 = vertical_shear};
}

/// Numbers of a packing that determine forces and moduli.
template <class T>
struct Geometry {
  T prefactor{};        ///< P = N_c <l^2>/V [1/m]
  T force_area{};       ///< V/(N_c <l>): a contact force is force_area stress F^-1 n [m^2]
  T static_prefactor{}; ///< N_c <l>^2/V, for forces independent of branch length [1/m]
};

template <class T>
Geometry<T> geometry(const T& coordination_number, const T& radius, const T& void_ratio,
                     const sizes::ContactMeans& means) {
  constexpr double pi = std::numbers::pi;
  const T solid = 1 + void_ratio; // inverse of the solid fraction
  const T of_equal = 1.5 / pi * (coordination_number / (radius * solid));
  return {.prefactor = of_equal * (means.branch_square / means.grain_volume),
          .force_area = 4 * pi / 3 * (radius * radius * solid / coordination_number) *
                        (means.grain_volume / means.branch),
          .static_prefactor = of_equal * (means.branch * means.branch / means.grain_volume)};
}

inline Geometry<double> geometry(const State& s) {
  return geometry(*s.coordination_number, s.radius, s.void_ratio, s.contacts);
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

/// k_n at the force area x load. A force too small to have all its digits is multiplied by 2^600 first,
/// and the stiffness scaled back.
double contact_stiffness(const contact::NormalLaw& law, double area, double load);

/// b at the mean contact force of a valid state; without contacts at zero force.
double local_exponent(const State& state);

/// Overlap at the mean contact force over the mean branch; 0 without contacts. Power laws beyond b = 1/2 are
/// given by k_n(f) alone: for them it is the overlap of b = 1/2 at the same stiffness, 2 f/k_n.
double mean_overlap(const State& state);
/// d ln d/d ln f of two grains.
double overlap_exponent(const contact::NormalLaw& law, double force);

/// The law as a member of the power family, for results that only this family has.
/// \throws   InvalidArgument for another law, naming the result
const contact::PowerLaw& power_law_of(const State& state, const char* asked);

/// k_n of a force; of one with derivatives by the chain rule.
template <class T>
T stiffness_at(const contact::NormalLaw& law, const T& force) {
  if constexpr (std::is_same_v<T, double>) {
    return law.stiffness_at_force(force);
  } else {
    const double value = law.stiffness_at_force(force.value());
    return {value, force.derivatives() * (value * law.exponent_at_force(force.value()) / force.value())};
  }
}

/// (k_n(reference x)/k_n(reference))^(+1 or -1), the weight of direction_moments for a law whose b is not the
/// same at every force.
template <class T>
struct StiffnessRatio {
  const contact::NormalLaw& law;
  T reference; ///< force [N]
  T stiffness; ///< k_n there [N/m]
  bool inverse = false;

  T operator()(const T& x) const {
    const T k = stiffness_at(law, T(reference * x));
    return inverse ? T(stiffness / k) : T(k / stiffness);
  }
};

/// x^exponent for x within some decades of 1, where this spends 2 ulp and is faster than pow.
inline double power(double x, double exponent) { return std::exp(exponent * std::log(x)); }

/// Upper half of the Gauss-Legendre rule that is exact to rounding for a ratio of the larger to the smaller
/// end of the weight's base (see direction_moments), at most 1e4.
std::span<const QuadratureNode> rule_for(double ratio);

/// Moments over E(gamma; a) of the weight power(f), f = horizontal sin^2 gamma + vertical cos^2 gamma, where
/// horizontal vertical = 1. They are integrals over x = n3 from 0 to 1 whose branch points approach the
/// interval as A/B = horizontal/vertical leaves 1. The substitution tan(gamma) -> c tan(gamma),
/// c^2 = sqrt(A/B), halves that ratio on a logarithmic scale and makes both sides of 1 alike:
///   x^2 = c^2 y^2/g,  1 - x^2 = (1 - y^2)/g,  dx = c g^(-3/2) dy,  g = 1 + (c^2-1) y^2.
/// A Gauss-Legendre rule of n points in y then errs by about exp(-2 n artanh((A/B)^(-1/4))), A > B, times a
/// power of n that is not small: rule_for contains measured limits. Nodes and c2 = sqrt(A/B) are plain
/// numbers: derivatives are taken at a fixed x.
template <class T, class Power>
AxialMoments<T> direction_moments(const T& a, const T& horizontal, const T& vertical, double c2, Power power,
                                  std::span<const QuadratureNode> rule) {
  const double c = std::sqrt(c2);
  AxialMoments<T> sum{.s4 = T(0), .s2c2 = T(0), .c4 = T(0)};
  for (const auto& [y, weight] : rule) {
    const double y2 = y * y;
    const double per_g = 1 / (1 + (c2 - 1) * y2);
    const double cos2 = c2 * y2 * per_g;
    const double sin2 = (1 - y2) * per_g;
    const T f = sin2 * horizontal + cos2 * vertical;
    const T density = sin2 * (1 - a) + cos2 * (1 + a); // of E, without 3/(3 - a)
    const T term = density * power(f) * (weight * c * per_g * std::sqrt(per_g));
    sum.s4 += (sin2 * sin2) * term;
    sum.s2c2 += (sin2 * cos2) * term;
    sum.c4 += (cos2 * cos2) * term;
  }
  const T scale = 3 / (3 - a);
  return {.s4 = scale * sum.s4, .s2c2 = scale * sum.s2c2, .c4 = scale * sum.c4};
}

/// k_t/k_n beyond which no estimate is given.
inline constexpr double largest_tangential_ratio = 100;

/// A state that has passed require_valid, and the derived numbers that every estimate needs.
struct CheckedState {
  Geometry<double> geometry;
  NormalLoads<double> loads; ///< of the static field
  double stiffness = 0;      ///< k_n at the geometric mean of the loads, 0 without contacts [N/m]
  Validity validity;
};

/// \throws   InvalidArgument as require_valid
CheckedState checked(const State& state);

/// The geometry only, for callers that need neither k_n nor notes.
/// \throws   InvalidArgument as require_valid
Geometry<double> checked_geometry(const State& state);

/// Refuses a state without contacts, which cannot carry a force.
/// \throws   InvalidArgument if C_n = 0
void require_contacts(const State& state);

} // namespace granum::effective::kernel
