// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas of packings of several materials. Private to src/effective and to validation/mixtures.
#pragma once

#include <algorithm>
#include <span>

#include <granum/effective/mixture.hpp>

namespace granum::effective::kernel {

/// \throws   InvalidArgument as require_valid(kinds), and unless their mean stiffness is 1 within 1e-6
void require_relative(std::span<const PairShare> kinds);

/// Coefficients of the exchange of G and of K, fitted in validation/mixtures, and the standard errors that a
/// mixture adds, over ln(mean stiffness/effective one), within which packings that were not fitted lie.
struct Mixing {
  double exchange;
  int power; ///< of 4/z*
  double error;
  double size_error; ///< of unequal grains, over the root of the relative variance of branches as well
  bool by_forces;    ///< stiffness_of_forces is a lower bound
};
inline constexpr Mixing shear_mixing{0.757, 1, 0.07, 2.0, false};
inline constexpr Mixing bulk_mixing{0.7078, 2, 0.12, 3.5, true};

/// How far the other contacts follow one that is softened: the fewer contacts, the more. At least 0, at most
/// 1.
inline double exchange_at(double z, const Mixing& mixing) {
  const double ratio = 4 / z;
  return std::clamp(mixing.exchange * (mixing.power == 2 ? ratio * ratio : ratio), 0.0, 1.0);
}

/// The effective medium of the kinds, over their mean, and its derivative by the exchange.
struct Medium {
  double stiffness;
  double by_exchange;
};
[[nodiscard]] Medium medium_of(std::span<const PairShare> kinds, double exchange);

/// Stiffness against pressure, if the given forces grow in proportion: (sum p f)^2/sum(p f^2/k), a lower
/// bound of K where the forces balance. With equal forces the harmonic mean.
[[nodiscard]] double stiffness_of_forces(std::span<const PairShare> kinds);

/// What several materials leave of a modulus, and its derivative by z*.
struct Mixed {
  double left = 1;
  double by_coordination = 0;
};
[[nodiscard]] Mixed left_by_mixing(std::span<const PairShare> kinds, double z, const Mixing& mixing);

} // namespace granum::effective::kernel
