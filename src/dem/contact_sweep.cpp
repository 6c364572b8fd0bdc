// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: b branch from i to j, u relative velocity of the centres j - i, w sum of both angular velocities,
// s tangential force on j. A block holds one number of each of its pairs per array; pairs that do
// not touch, and the padding of the last block, carry zeros through every formula.
//
// This file is compiled without math errno and trapping (CMakeLists.txt), which lets the loops below become
// vector code; neither changes a result.
#include "contact_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "inverse_root.hpp"

namespace granum::dem {

namespace {

struct PairBlock {
  Block bx, by, bz;
  Block ux, uy, uz;
  Block wx, wy, wz;
  Block squared, inverse_length, overlap, force, stiffness, shear_squared;
  Block fx, fy, fz; ///< whole force on j
  Block tx, ty, tz; ///< torque on either grain
};

/// Running sums, one for each place in a vector of eight.
using Eight = double __attribute__((vector_size(8 * sizeof(double))));
struct SumRows {
  std::array<Eight, 9> stress{};
  Eight normal_force{}, stiffness{}, stiffest{}, contacts{}, sliding{};
};

/// What a block adds to the centre of its grains j, by the number of the pair's image; the last one takes the
/// padding far out of reach.
constexpr std::uint32_t far_image = 27;
using Shifts = std::array<Four, far_image + 1>;

Shifts shift_rows(const Mat3& cell, double diameter) {
  const std::array<Vec3, far_image> vectors = shift_vectors(cell);
  Shifts rows;
  for (std::size_t k = 0; k < far_image; ++k)
    rows[k] = Four{vectors[k].x, vectors[k].y, vectors[k].z, 0};
  rows[far_image] = Four{2 * diameter, 0, 0, 0};
  return rows;
}

/// Four rows become four columns, and back.
GRANUM_INLINE void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

using FourDoubles __attribute__((may_alias)) = Four;
using EightDoubles __attribute__((may_alias)) = Eight;
GRANUM_INLINE const EightDoubles& eight(const Block& block, std::size_t k) {
  return *reinterpret_cast<const EightDoubles*>(&block[k]);
}
GRANUM_INLINE FourDoubles& four(Block& block, std::size_t k) {
  return *reinterpret_cast<FourDoubles*>(&block[k]);
}
GRANUM_INLINE const FourDoubles& four(const Block& block, std::size_t k) {
  return *reinterpret_cast<const FourDoubles*>(&block[k]);
}

/// Brings the rows of a block's grains near, while the block before it is worked off.
GRANUM_INLINE void prefetch(const Pair* pairs, const MotionRow* rows, const LoadRow* load) {
  for (std::size_t k = 0; k < block_size; ++k) {
    __builtin_prefetch(&rows[pairs[k].j]);
    __builtin_prefetch(&load[pairs[k].j], 1);
  }
}

/// Branches, relative velocities and sums of angular velocities.
template <bool tangential>
GRANUM_INLINE void load_block(const SweepInput& in, const Shifts& shifts, const Pair* pairs, PairBlock& p) {
  const MotionRow* const rows = in.grains.row.data();
  const double* const spin_y = in.grains.spin_y.data();
  const Four sign{-1, -1, -1, 1}; // centres and velocities subtract, angular velocities add
  for (std::size_t k = 0; k < block_size; k += 4) {
    Four place[4], rate[4];
    for (std::size_t n = 0; n < 4; ++n) {
      const Pair& pair = pairs[k + n];
      place[n] = rows[pair.j].place + sign * rows[pair.i].place + shifts[pair.image];
      if constexpr (tangential) {
        rate[n] = rows[pair.j].rate + sign * rows[pair.i].rate;
        p.wy[k + n] = spin_y[pair.j] + spin_y[pair.i];
      }
    }
    transpose(place[0], place[1], place[2], place[3]);
    four(p.bx, k) = place[0];
    four(p.by, k) = place[1];
    four(p.bz, k) = place[2];
    if constexpr (tangential) {
      four(p.wz, k) = place[3];
      transpose(rate[0], rate[1], rate[2], rate[3]);
      four(p.ux, k) = rate[0];
      four(p.uy, k) = rate[1];
      four(p.uz, k) = rate[2];
      four(p.wx, k) = rate[3];
    }
  }
}

template <class Law>
GRANUM_INLINE contact::NormalResponse normal_response(const Law& law, double overlap) {
  return law(overlap);
}
GRANUM_INLINE contact::NormalResponse normal_response(const contact::SphereKernel& law, double overlap) {
  const double root = law.coefficient * (overlap * inverse_root(overlap));
  return {root * overlap, 1.5 * root};
}

/// In two loops: in one, the compiler would branch where a pair does not touch.
template <class Law>
GRANUM_INLINE void normal_forces(const Law& law, double diameter, PairBlock& __restrict p) {
  for (std::size_t k = 0; k < block_size; ++k) {
    const double squared = p.bx[k] * p.bx[k] + p.by[k] * p.by[k] + p.bz[k] * p.bz[k];
    const double inverse_length = inverse_root(squared);
    const double overlap = diameter - squared * inverse_length;
    p.squared[k] = squared;
    p.inverse_length[k] = inverse_length;
    p.overlap[k] = overlap > 0 ? overlap : 0.0;
  }
  for (std::size_t k = 0; k < block_size; ++k) {
    const contact::NormalResponse response = normal_response(law, p.overlap[k]);
    p.force[k] = response.force;
    p.stiffness[k] = p.overlap[k] > 0 ? response.stiffness : 0.0;
    const double per_length = response.force * p.inverse_length[k];
    p.fx[k] = per_length * p.bx[k];
    p.fy[k] = per_length * p.by[k];
    p.fz[k] = per_length * p.bz[k];
  }
}

/// Brings tangential forces down to Coulomb's limit; few blocks need it.
GRANUM_INLINE void limit_block(double friction, const PairBlock& __restrict p, Eight& __restrict sliding,
                               double* __restrict mx, double* __restrict my, double* __restrict mz) {
  for (std::size_t k = 0; k < block_size; ++k) {
    const double limit = friction * p.force[k];
    const bool slides = p.shear_squared[k] > limit * limit;
    const double scale = slides ? limit / std::sqrt(p.shear_squared[k]) : 1.0;
    mx[k] *= scale;
    my[k] *= scale;
    mz[k] *= scale;
    sliding[k % 8] += slides ? 1.0 : 0.0;
  }
}

/// Tangential increment against the relative displacement of the two surfaces, Coulomb's limit, torque. mx
/// .. mk: this block's memory.
GRANUM_INLINE void frictional_forces(const SweepInput& in, PairBlock& __restrict p, Eight& __restrict sliding,
                                     double* __restrict mx, double* __restrict my, double* __restrict mz,
                                     double* __restrict mk) {
  const double ratio = in.tangential_ratio, friction = in.friction, elapsed = in.elapsed;
  std::int64_t any_slides = 0;
  const Mat3 gradient = in.gradient;
  for (std::size_t k = 0; k < block_size; ++k) {
    const double bx = p.bx[k], by = p.by[k], bz = p.bz[k];
    const double vx = p.ux[k] + gradient(0, 0) * bx + gradient(0, 1) * by + gradient(0, 2) * bz -
                      0.5 * (p.wy[k] * bz - p.wz[k] * by);
    const double vy = p.uy[k] + gradient(1, 0) * bx + gradient(1, 1) * by + gradient(1, 2) * bz -
                      0.5 * (p.wz[k] * bx - p.wx[k] * bz);
    const double vz = p.uz[k] + gradient(2, 0) * bx + gradient(2, 1) * by + gradient(2, 2) * bz -
                      0.5 * (p.wx[k] * by - p.wy[k] * bx);
    const double stiffness = ratio * p.stiffness[k];
    const double keep = stiffness < mk[k] ? stiffness / mk[k] : 1.0;
    const double increment = stiffness * elapsed;
    double sx = keep * mx[k] - increment * vx;
    double sy = keep * my[k] - increment * vy;
    double sz = keep * mz[k] - increment * vz;
    const double along = (sx * bx + sy * by + sz * bz) * (p.inverse_length[k] * p.inverse_length[k]);
    sx -= along * bx;
    sy -= along * by;
    sz -= along * bz;
    const double limit = friction * p.force[k];
    const double shear_squared = sx * sx + sy * sy + sz * sz;
    any_slides |= static_cast<std::int64_t>(shear_squared > limit * limit);
    p.shear_squared[k] = shear_squared;
    mx[k] = sx;
    my[k] = sy;
    mz[k] = sz;
    mk[k] = stiffness;
  }
  if (any_slides != 0)
    limit_block(friction, p, sliding, mx, my, mz);
  for (std::size_t k = 0; k < block_size; ++k) {
    const double bx = p.bx[k], by = p.by[k], bz = p.bz[k];
    const double sx = mx[k], sy = my[k], sz = mz[k];
    p.fx[k] += sx;
    p.fy[k] += sy;
    p.fz[k] += sz;
    p.tx[k] = -0.5 * (by * sz - bz * sy);
    p.ty[k] = -0.5 * (bz * sx - bx * sz);
    p.tz[k] = -0.5 * (bx * sy - by * sx);
  }
}

GRANUM_INLINE void add_up(const PairBlock& p, SumRows& sums) {
  SumRows s = sums;
  for (std::size_t k = 0; k < block_size; k += 8) {
    const Eight bx = eight(p.bx, k), by = eight(p.by, k), bz = eight(p.bz, k);
    const Eight fx = eight(p.fx, k), fy = eight(p.fy, k), fz = eight(p.fz, k);
    const Eight force = eight(p.force, k), stiffness = eight(p.stiffness, k);
    s.stress[0] += fx * bx;
    s.stress[1] += fx * by;
    s.stress[2] += fx * bz;
    s.stress[3] += fy * bx;
    s.stress[4] += fy * by;
    s.stress[5] += fy * bz;
    s.stress[6] += fz * bx;
    s.stress[7] += fz * by;
    s.stress[8] += fz * bz;
    s.normal_force += force;
    s.stiffness += stiffness * eight(p.squared, k);
    s.stiffest = s.stiffest > stiffness ? s.stiffest : stiffness;
    s.contacts += force > 0 ? Eight{1, 1, 1, 1, 1, 1, 1, 1} : Eight{};
  }
  sums = s;
}

/// Adds the forces of a block to its grains, pair by pair in the order of the list.
template <bool tangential>
GRANUM_INLINE void unload_block(const Pair* pairs, const PairBlock& p, LoadRow* load) {
  const Four sign{-1, -1, -1, 1}; // forces are opposite, torques equal
  for (std::size_t k = 0; k < block_size; k += 4) {
    Four push[4] = {four(p.fx, k), four(p.fy, k), four(p.fz, k), Four{}};
    Four turn[4] = {};
    if constexpr (tangential) {
      push[3] = four(p.tx, k);
      turn[0] = four(p.ty, k);
      turn[3] = four(p.tz, k);
      transpose(turn[0], turn[1], turn[2], turn[3]);
    }
    transpose(push[0], push[1], push[2], push[3]);
    for (std::size_t n = 0; n < 4; ++n) {
      LoadRow& on_i = load[pairs[k + n].i];
      LoadRow& on_j = load[pairs[k + n].j];
      on_i.push += sign * push[n];
      on_j.push += push[n];
      if constexpr (tangential) {
        on_i.turn += turn[n];
        on_j.turn += turn[n];
      }
    }
  }
}

double total(const Eight& row) {
  double sum = 0;
  for (std::size_t k = 0; k < 8; ++k)
    sum += row[k];
  return sum;
}

SweepSums totals(const SumRows& sums) {
  SweepSums out;
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col)
      out.stress(row, col) = total(sums.stress[static_cast<std::size_t>(3 * row + col)]);
  out.normal_force = total(sums.normal_force);
  out.stiffness = total(sums.stiffness);
  for (std::size_t k = 0; k < 8; ++k)
    out.stiffest = std::max(out.stiffest, sums.stiffest[k]);
  out.contacts = static_cast<std::size_t>(total(sums.contacts));
  out.sliding = static_cast<std::size_t>(total(sums.sliding));
  return out;
}

struct Work {
  const SweepInput& in;
  const Shifts& shifts;
  ContactMemory* memory; ///< null: frictionless
  LoadRow* load;
  SumRows& sums;
};

template <bool tangential, class Law>
GRANUM_INLINE void sweep_block(const Law& law, const Work& work, const Pair* pairs, std::size_t first,
                               const Pair* next, PairBlock& p) {
  prefetch(next, work.in.grains.row.data(), work.load);
  load_block<tangential>(work.in, work.shifts, pairs, p);
  normal_forces(law, work.in.diameter, p);
  if constexpr (tangential)
    frictional_forces(work.in, p, work.sums.sliding, work.memory->x.data() + first,
                      work.memory->y.data() + first, work.memory->z.data() + first,
                      work.memory->stiffness.data() + first);
  add_up(p, work.sums);
  unload_block<tangential>(pairs, p, work.load);
}

template <bool tangential, class Law>
GRANUM_INLINE void sweep_all(const Law& law, const Work& work) {
  PairBlock p;
  const std::vector<Pair>& pairs = work.in.pairs;
  for (std::size_t first = 0; first < pairs.size(); first += block_size) {
    const std::size_t next = std::min(first + block_size, pairs.size() - block_size);
    sweep_block<tangential>(law, work, pairs.data() + first, first, pairs.data() + next, p);
  }
}

template <class Law>
GRANUM_INLINE void sweep_with(const Law& law, const Work& work) {
  if (work.memory != nullptr)
    sweep_all<true>(law, work);
  else
    sweep_all<false>(law, work);
}

} // namespace

void ContactMemory::reset(std::size_t pairs) {
  for (std::vector<double>* array : {&x, &y, &z, &stiffness})
    array->assign(pairs, 0.0);
}

std::vector<Pair> padded(std::vector<Pair> pairs) {
  pairs.resize((pairs.size() + block_size - 1) / block_size * block_size, Pair{0, 0, far_image});
  return pairs;
}

SweepSums contact_sweep(const contact::NormalKernel& law, const SweepInput& input, ContactMemory* memory,
                        std::vector<LoadRow>& load) {
  const Shifts shifts = shift_rows(input.cell, input.diameter);
  SumRows sums;
  std::fill(load.begin(), load.end(), LoadRow{});
  const Work work{input, shifts, memory, load.data(), sums};
  std::visit(
      [&](const auto& kernel) {
        at_vector_level([&]() __attribute__((always_inline)) { sweep_with(kernel, work); });
      },
      law);
  return totals(sums);
}

} // namespace granum::dem
