// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: b branch from i to j, u relative velocity of the centres j - i, w sum of both angular velocities,
// s tangential force on j. A block holds one number of each of its pairs per array; pairs that do not touch,
// and the padding of the last block, carry zeros through every formula.
//
// This file is compiled without math errno and trapping (CMakeLists.txt), which lets the loops below become
// vector code; neither changes a result.
#include "contact_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

// Same source for each vector level, chosen when the program starts. No level contracts or reorders, so that
// all give the same bits. Sanitized builds take the plain one: their runtime starts after the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define GRANUM_VECTOR_LEVELS __attribute__((target_clones("avx2", "default")))
#else
#define GRANUM_VECTOR_LEVELS
#endif

namespace granum::dem {

namespace {

struct PairBlock {
  Block bx, by, bz;
  Block ux, uy, uz;
  Block wx, wy, wz;
  Block squared, force, stiffness;
  Block fx, fy, fz; ///< whole force on j
  Block tx, ty, tz; ///< torque on either grain
};

/// Running sums, one for each place in a block.
struct SumBlock {
  std::array<Block, 9> stress{};
  Block normal_force{}, stiffness{}, stiffest{}, contacts{}, sliding{};
};

template <class Law>
[[gnu::always_inline]] inline void normal_forces(const Law& law, double diameter, PairBlock& p) {
  for (std::size_t k = 0; k < block_size; ++k) {
    const double squared = p.bx[k] * p.bx[k] + p.by[k] * p.by[k] + p.bz[k] * p.bz[k];
    const double overlap = diameter - std::sqrt(squared);
    const bool touches = overlap > 0;
    const contact::NormalResponse response = law(touches ? overlap : 0.0);
    p.squared[k] = squared;
    p.force[k] = touches ? response.force : 0.0;
    p.stiffness[k] = touches ? response.stiffness : 0.0;
  }
}

GRANUM_VECTOR_LEVELS void normal_forces_of(const contact::ConeKernel& law, double diameter, PairBlock& p) {
  normal_forces(law, diameter, p);
}
GRANUM_VECTOR_LEVELS void normal_forces_of(const contact::SphereKernel& law, double diameter, PairBlock& p) {
  normal_forces(law, diameter, p);
}
GRANUM_VECTOR_LEVELS void normal_forces_of(const contact::FlatKernel& law, double diameter, PairBlock& p) {
  normal_forces(law, diameter, p);
}
void normal_forces_of(const contact::GeneralKernel& law, double diameter, PairBlock& p) {
  normal_forces(law, diameter, p);
}

GRANUM_VECTOR_LEVELS void frictionless_forces(PairBlock& p) {
  for (std::size_t k = 0; k < block_size; ++k) {
    const double per_length = p.force[k] / std::sqrt(p.squared[k]);
    p.fx[k] = per_length * p.bx[k];
    p.fy[k] = per_length * p.by[k];
    p.fz[k] = per_length * p.bz[k];
  }
}

/// Tangential increment against the relative displacement of the two surfaces, Coulomb's limit, torque. mx
/// .. mk: this block's memory.
GRANUM_VECTOR_LEVELS void frictional_forces(const SweepInput& in, PairBlock& __restrict p,
                                            Block& __restrict sliding, double* __restrict mx,
                                            double* __restrict my, double* __restrict mz,
                                            double* __restrict mk) {
  const double ratio = in.tangential_ratio, friction = in.friction, elapsed = in.elapsed;
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
    const double along = (sx * bx + sy * by + sz * bz) / p.squared[k];
    sx -= along * bx;
    sy -= along * by;
    sz -= along * bz;
    const double limit = friction * p.force[k];
    const double shear_squared = sx * sx + sy * sy + sz * sz;
    const bool slides = shear_squared > limit * limit;
    const double scale = slides ? limit / std::sqrt(shear_squared) : 1.0;
    sx *= scale;
    sy *= scale;
    sz *= scale;
    mx[k] = sx;
    my[k] = sy;
    mz[k] = sz;
    mk[k] = stiffness;
    p.fx[k] += sx;
    p.fy[k] += sy;
    p.fz[k] += sz;
    p.tx[k] = -0.5 * (by * sz - bz * sy);
    p.ty[k] = -0.5 * (bz * sx - bx * sz);
    p.tz[k] = -0.5 * (bx * sy - by * sx);
    sliding[k] += slides ? 1.0 : 0.0;
  }
}

GRANUM_VECTOR_LEVELS void add_up(const PairBlock& __restrict p, SumBlock& __restrict sums) {
  for (std::size_t k = 0; k < block_size; ++k) {
    sums.stress[0][k] += p.fx[k] * p.bx[k];
    sums.stress[1][k] += p.fx[k] * p.by[k];
    sums.stress[2][k] += p.fx[k] * p.bz[k];
    sums.stress[3][k] += p.fy[k] * p.bx[k];
    sums.stress[4][k] += p.fy[k] * p.by[k];
    sums.stress[5][k] += p.fy[k] * p.bz[k];
    sums.stress[6][k] += p.fz[k] * p.bx[k];
    sums.stress[7][k] += p.fz[k] * p.by[k];
    sums.stress[8][k] += p.fz[k] * p.bz[k];
    sums.normal_force[k] += p.force[k];
    sums.stiffness[k] += p.stiffness[k] * p.squared[k];
    sums.stiffest[k] = std::max(sums.stiffest[k], p.stiffness[k]);
    sums.contacts[k] += p.force[k] > 0 ? 1.0 : 0.0;
  }
}

/// Branches and relative velocities of the pairs from first on; the padding stands two diameters apart.
template <bool tangential>
void load_block(const SweepInput& in, const std::array<Vec3, 27>& shifts, std::size_t first,
                std::size_t count, PairBlock& p) {
  for (std::size_t k = 0; k < count; ++k) {
    const Pair pair = in.pairs[first + k];
    const Motion& a = in.motion[pair.i];
    const Motion& b = in.motion[pair.j];
    const Vec3& shift = shifts[pair.image];
    p.bx[k] = b.x.x - a.x.x + shift.x;
    p.by[k] = b.x.y - a.x.y + shift.y;
    p.bz[k] = b.x.z - a.x.z + shift.z;
    if constexpr (tangential) {
      p.ux[k] = b.v.x - a.v.x;
      p.uy[k] = b.v.y - a.v.y;
      p.uz[k] = b.v.z - a.v.z;
      p.wx[k] = b.w.x + a.w.x;
      p.wy[k] = b.w.y + a.w.y;
      p.wz[k] = b.w.z + a.w.z;
    }
  }
  for (std::size_t k = count; k < block_size; ++k) {
    p.bx[k] = 2 * in.diameter;
    p.by[k] = p.bz[k] = 0;
    p.ux[k] = p.uy[k] = p.uz[k] = p.wx[k] = p.wy[k] = p.wz[k] = 0;
  }
}

/// Adds the forces of a block to its grains; the sorted list keeps grain i for several pairs in turn.
template <bool tangential>
void unload_block(const SweepInput& in, std::size_t first, std::size_t count, const PairBlock& p,
                  std::vector<Load>& load) {
  std::uint32_t i = in.pairs[first].i;
  Load on_i = load[i];
  for (std::size_t k = 0; k < count; ++k) {
    const Pair pair = in.pairs[first + k];
    if (pair.i != i) {
      load[i] = on_i;
      i = pair.i;
      on_i = load[i];
    }
    if (!(p.force[k] > 0))
      continue;
    const Vec3 force{p.fx[k], p.fy[k], p.fz[k]};
    on_i.f -= force;
    load[pair.j].f += force;
    if constexpr (tangential) {
      const Vec3 torque{p.tx[k], p.ty[k], p.tz[k]};
      on_i.t += torque;
      load[pair.j].t += torque;
    }
  }
  load[i] = on_i;
}

double total(const Block& block) {
  double sum = 0;
  for (const double value : block)
    sum += value;
  return sum;
}

SweepSums totals(const SumBlock& sums) {
  SweepSums out;
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col)
      out.stress(row, col) = total(sums.stress[static_cast<std::size_t>(3 * row + col)]);
  out.normal_force = total(sums.normal_force);
  out.stiffness = total(sums.stiffness);
  out.stiffest = *std::max_element(sums.stiffest.begin(), sums.stiffest.end());
  out.contacts = static_cast<std::size_t>(total(sums.contacts));
  out.sliding = static_cast<std::size_t>(total(sums.sliding));
  return out;
}

template <bool tangential, class Law>
SweepSums sweep(const Law& law, const SweepInput& in, ContactMemory* memory, std::vector<Load>& load) {
  const std::array<Vec3, 27> shifts = shift_vectors(in.cell);
  SumBlock sums;
  PairBlock p;
  std::fill(load.begin(), load.end(), Load{});
  for (std::size_t first = 0; first < in.pairs.size(); first += block_size) {
    const std::size_t count = std::min(block_size, in.pairs.size() - first);
    load_block<tangential>(in, shifts, first, count, p);
    normal_forces_of(law, in.diameter, p);
    frictionless_forces(p);
    if constexpr (tangential)
      frictional_forces(in, p, sums.sliding, memory->x.data() + first, memory->y.data() + first,
                        memory->z.data() + first, memory->stiffness.data() + first);
    add_up(p, sums);
    unload_block<tangential>(in, first, count, p, load);
  }
  return totals(sums);
}

} // namespace

void ContactMemory::reset(std::size_t pairs) {
  const std::size_t padded = (pairs + block_size - 1) / block_size * block_size;
  for (std::vector<double>* array : {&x, &y, &z, &stiffness})
    array->assign(padded, 0.0);
}

SweepSums contact_sweep(const contact::NormalKernel& law, const SweepInput& input, ContactMemory* memory,
                        std::vector<Load>& load) {
  return std::visit(
      [&](const auto& kernel) {
        return memory != nullptr ? sweep<true>(kernel, input, memory, load)
                                 : sweep<false>(kernel, input, memory, load);
      },
      law);
}

} // namespace granum::dem
