// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Sizes of the grains of a block of pairs.
#pragma once

#include <cstddef>

#include "contact_sweep.hpp"
#include "core/vector/level.hpp"
#include "core/vector/types.hpp"

namespace granum::dem {

/// Constants of pairs of equal grains.
struct EqualGrains {
  static constexpr bool equal = true;
  double diameter;

  template <class Input>
  explicit EqualGrains(const Input& in) : diameter(in.diameter) {}
  template <class Input>
  GRANUM_INLINE void load(const Input& /*in*/, const ListedPair* /*pairs*/) {}
  GRANUM_INLINE double reach(std::size_t /*pair*/) const { return diameter; }
  /// Factor of the stored spins in the relative displacement, and of the force in the stored torque.
  GRANUM_INLINE static double share(std::size_t /*pair*/) { return 0.5; }
  /// The overlap times the mean curvature of both grains, over the curvature of a grain of size 1.
  GRANUM_INLINE static double curved(double overlap, std::size_t /*pair*/) { return overlap; }
};

/// The same for one block of pairs of different grains.
class UnequalGrains {
 public:
  static constexpr bool equal = false;
  template <class Input>
  explicit UnequalGrains(const Input& in) : unit_radius_(in.unit_radius) {}

  template <class Input>
  GRANUM_INLINE void load(const Input& in, const ListedPair* pairs) {
    const Two* const round = in.grains.round.data();
    for (std::size_t k = 0; k < block_size; k += 2) {
      const Two a = row_at(round, pairs[k].i()) + row_at(round, pairs[k].j());
      const Two b = row_at(round, pairs[k + 1].i()) + row_at(round, pairs[k + 1].j());
      *reinterpret_cast<TwoInMemory*>(&reach_[k]) = __builtin_shufflevector(a, b, 0, 2);
      *reinterpret_cast<TwoInMemory*>(&curvature_[k]) = __builtin_shufflevector(a, b, 1, 3);
    }
    const double half_unit = 0.5 * unit_radius_;
    for (std::size_t k = 0; k < block_size; ++k) {
      per_reach_[k] = 1 / reach_[k];
      curvature_[k] *= half_unit;
    }
  }
  GRANUM_INLINE double reach(std::size_t pair) const { return reach_[pair]; }
  GRANUM_INLINE double share(std::size_t pair) const { return per_reach_[pair]; }
  GRANUM_INLINE double curved(double overlap, std::size_t pair) const { return overlap * curvature_[pair]; }

 private:
  double unit_radius_;
  Block reach_, per_reach_, curvature_;
};

} // namespace granum::dem
