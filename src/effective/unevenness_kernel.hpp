// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas of how unevenly contacts share the forces, and of what this changes in the relaxation
// factors, templates on the number type. Private as those of relaxation_kernel.hpp.
#pragma once

#include <cmath>

#include "relaxation_coefficients.hpp"

namespace granum::effective::kernel {

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

} // namespace granum::effective::kernel
