// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Notation: b branch from i to j, u relative velocity of the centres j - i, w sum of both
// angular velocities. A block has one number per pair in each array; pairs without contact, and the padding
// of the last block, are zeros in every formula.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <granum/contact/rough_sphere.hpp>

#include "contact_sweep.hpp"
#include "core/vector/level.hpp"
#include "core/vector/power.hpp"
#include "core/vector/rows.hpp"

namespace granum::dem {

/// Sizes of the grains of a block of pairs: constants of pairs of equal grains.
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

struct PairBlock {
  Block bx, by, bz;
  Block ux, uy, uz;
  Block wx, wy, wz;
  Block squared, inverse_length, overlap, force, stiffness, shear_squared;
  Block fx, fy, fz; ///< whole force on j
  Block tx, ty, tz; ///< torque on either grain
};

/// Scalar product of (ax, ay, az) and (bx, by, bz).
template <VectorLevel level>
GRANUM_INLINE double product(double ax, double ay, double az, double bx, double by, double bz) {
  return fused<level>(az, bz, fused<level>(ay, by, ax * bx));
}

/// The first part of a law, if it is most of its work.
template <VectorLevel, class Law>
GRANUM_INLINE double first_guess(const Law& /*law*/, double /*curved*/) {
  return 0;
}
template <VectorLevel level>
GRANUM_INLINE double first_guess(const contact::SphereKernel& /*law*/, double curved) {
  return near_inverse_root<level>(curved);
}

/// \param    curved   the overlap over contact::pair_radius, in units of a grain of size 1
/// \param    guess    the result of first_guess for it
template <VectorLevel, class Law>
GRANUM_INLINE contact::NormalResponse normal_response(const Law& law, double overlap,
                                                      [[maybe_unused]] double curved, double /*guess*/) {
  if constexpr (requires { law.of_pair_radius(curved); })
    return law.of_pair_radius(curved > 0 ? overlap / curved : 1.0)(overlap);
  else
    return law(overlap);
}
template <VectorLevel level>
GRANUM_INLINE contact::NormalResponse normal_response(const contact::SphereKernel& law, double overlap,
                                                      double curved, double guess) {
  const double root = law.coefficient * (overlap * nearer_inverse_root<level>(curved, guess));
  return {root * overlap, 1.5 * root};
}
template <VectorLevel level>
GRANUM_INLINE contact::NormalResponse normal_response(const contact::GeneralKernel& law, double overlap,
                                                      double /*curved*/, double /*guess*/) {
  const double root =
      law.coefficient * power_from<level>(log2_of<level>(overlap), SplitExponent(law.inverse_alpha));
  return {root * overlap, (1 + law.inverse_alpha) * root};
}

/// Whether the law gives zero stiffness at zero overlap without a mask.
template <class Law>
inline constexpr bool starts_soft =
    std::is_same_v<Law, contact::SphereKernel> || std::is_same_v<Law, contact::ConeKernel>;

/// Force and stiffness of a block of rough spheres: find the cells of their table, load these as columns,
/// evaluate the polynomials.
template <VectorLevel level, class Sizes>
GRANUM_INLINE void rough_responses(const contact::RoughSphereKernel& law, const Sizes& sizes,
                                   PairBlock& __restrict p) {
  using Kernel = contact::RoughSphereKernel;
  using Level = Rows<level>;
  alignas(64) std::array<std::int64_t, block_size> cell;
  Block beyond;
  std::array<Block, 8> c; // the last two are not used
  for (std::size_t k = 0; k < block_size; ++k) {
    const Kernel::Place place = Kernel::place_of(p.overlap[k] * law.per_roughness);
    cell[k] = place.cell;
    beyond[k] = place.beyond;
  }
  for (std::size_t k = 0; k < block_size; k += Level::lanes) {
    typename Level::Row row[Level::lanes];
    typename Level::Column column[8];
    for (std::size_t n = 0; n < Level::lanes; ++n)
      row[n] = Level::get(&law.cells[cell[k + n]]);
    to_columns(row, column);
    for (std::size_t n = 0; n < 6; ++n)
      Level::put_column(&c[n][k], column[n]);
  }
  for (std::size_t k = 0; k < block_size; ++k) {
    const double overlap = p.overlap[k], x = beyond[k];
    double scale = law.transition_force;
    if constexpr (!Sizes::equal)
      scale *= std::sqrt(overlap > 0 ? overlap / sizes.curved(overlap, k) : 1.0);
    p.force[k] = scale * Kernel::force_in(c[0][k], c[1][k], c[2][k], c[3][k], c[4][k], c[5][k], x);
    const double slope = Kernel::slope_in(c[1][k], c[2][k], c[3][k], c[4][k], c[5][k], x);
    p.stiffness[k] = overlap > 0 ? scale * law.per_roughness * slope : 0.0;
  }
}

/// From branches to forces on j, in loops with short chains of products. A processor keeps some dozens of
/// instructions waiting for their operands; longer chains fill this queue with two or three vectors. In a
/// single loop the compiler would also branch for pairs without contact.
template <VectorLevel level, class Law, class Sizes>
GRANUM_INLINE void normal_forces(const Law& law, const Sizes& sizes, PairBlock& __restrict p) {
  Block guess;
  for (std::size_t k = 0; k < block_size; ++k) {
    const double squared = product<level>(p.bx[k], p.by[k], p.bz[k], p.bx[k], p.by[k], p.bz[k]);
    p.squared[k] = squared;
    guess[k] = near_inverse_root<level>(squared);
  }
  for (std::size_t k = 0; k < block_size; ++k) {
    const double inverse_length = nearer_inverse_root<level>(p.squared[k], guess[k]);
    const double overlap = fused<level>(-p.squared[k], inverse_length, sizes.reach(k));
    p.inverse_length[k] = inverse_length;
    p.overlap[k] = overlap > 0 ? overlap : 0.0;
  }
  constexpr bool rough = std::is_same_v<Law, contact::RoughSphereKernel>;
  if constexpr (rough)
    rough_responses<level>(law, sizes, p);
  else
    for (std::size_t k = 0; k < block_size; ++k)
      guess[k] = first_guess<level>(law, sizes.curved(p.overlap[k], k));
  for (std::size_t k = 0; k < block_size; ++k) {
    contact::NormalResponse response{p.force[k], p.stiffness[k]};
    if constexpr (!rough) {
      const double overlap = p.overlap[k];
      response = normal_response<level>(law, overlap, sizes.curved(overlap, k), guess[k]);
      p.force[k] = response.force;
      p.stiffness[k] = starts_soft<Law> || overlap > 0 ? response.stiffness : 0.0;
    }
    const double per_length = response.force * p.inverse_length[k];
    p.fx[k] = per_length * p.bx[k];
    p.fy[k] = per_length * p.by[k];
    p.fz[k] = per_length * p.bz[k];
  }
}

} // namespace granum::dem
