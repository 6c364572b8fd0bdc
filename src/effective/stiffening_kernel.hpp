// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas of how the relaxation factors continue with b of k_n ~ f^b, templates on the number
// type. Private as those of relaxation_kernel.hpp.
#pragma once

#include <array>
#include <cmath>

#include <granum/contact/solid.hpp>

#include "relaxation_coefficients.hpp"

namespace granum::effective::kernel {

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

} // namespace granum::effective::kernel
