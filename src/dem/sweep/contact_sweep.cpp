// SPDX-License-Identifier: GPL-3.0-or-later
// Notation as in normal_forces.hpp, and s tangential force on j. Compiled without math errno and trapping
// (CMakeLists.txt), so that the loops become vector code; results do not change.
#include "contact_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <granum/dem/neighbours.hpp>

#include "core/vector/rows.hpp"
#include "fetch_ahead.hpp"
#include "normal_forces.hpp"

namespace granum::dem {

namespace {

/// Running sums, one for each lane of a vector of eight.
struct SumRows {
  std::array<Eight, 9> stress{};
  Eight virial{}, normal_force{}, stiffness{}, stiffest{}, contacts{}, sliding{};
};

/// Shift of the centre of grain j by the image of the pair; the last one moves padding out of reach.
using Shifts = std::array<MotionRow, image_count + 1>;

/// As rows of motion; -0 does not change velocities, to the bit.
Shifts shift_rows(const Mat3& cell, double diameter) {
  const std::array<Vec3, image_count> vectors = shift_vectors(cell);
  Shifts rows;
  rows.fill(MotionRow{.place = Four{0, 0, 0, -0.0}, .rate = Four{-0.0, -0.0, -0.0, -0.0}});
  for (std::size_t k = 0; k < image_count; ++k)
    rows[k].place = Four{vectors[k].x, vectors[k].y, vectors[k].z, -0.0};
  rows[image_count].place[0] = 2 * diameter;
  return rows;
}

GRANUM_INLINE Eight eight(const Block& block, std::size_t k) {
  return *reinterpret_cast<const EightInMemory*>(&block[k]);
}

/// Rows of the grains of a pair, by their numbers.
GRANUM_INLINE const MotionRow* rows_of(const Grains& grains) { return grains.row.data(); }
GRANUM_INLINE const PlaceRow* rows_of(const TranslatingGrains& grains) { return grains.place.data(); }

/// Branches only, for pairs without friction.
template <class Input>
GRANUM_INLINE void load_branches(const Input& in, const Shifts& shifts, const ListedPair* pairs,
                                 PairBlock& p) {
  const auto* const rows = rows_of(in.grains);
  for (std::size_t k = 0; k < block_size; k += 4) {
    Four place[4];
    for (std::size_t n = 0; n < 4; ++n) {
      const ListedPair& pair = pairs[k + n];
      place[n] = row_at(rows, pair.j()).place - row_at(rows, pair.i()).place +
                 row_at(shifts.data(), pair.image()).place;
    }
    transpose(place[0], place[1], place[2], place[3]);
    Rows<VectorLevel::avx2>::put_column(&p.bx[k], place[0]);
    Rows<VectorLevel::avx2>::put_column(&p.by[k], place[1]);
    Rows<VectorLevel::avx2>::put_column(&p.bz[k], place[2]);
  }
}

/// Branches, relative velocities and sums of angular velocities.
template <class Level>
GRANUM_INLINE void load_block(const SweepInput& in, const Shifts& shifts, const ListedPair* pairs,
                              PairBlock& p) {
  const MotionRow* const rows = in.grains.row.data();
  const double* const spin_y = in.grains.spin_y.data();
  // Centres and velocities subtract, angular velocities add.
  const auto sign = Level::row(Four{-1, -1, -1, 1}, Four{-1, -1, -1, 1});
  for (std::size_t k = 0; k < block_size; k += Level::lanes) {
    typename Level::Row row[Level::lanes];
    typename Level::Column column[8];
    for (std::size_t n = 0; n < Level::lanes; ++n) {
      const ListedPair& pair = pairs[k + n];
      row[n] = Level::get(&row_at(rows, pair.j())) + sign * Level::get(&row_at(rows, pair.i())) +
               Level::get(&row_at(shifts.data(), pair.image()));
      p.wy[k + n] = row_at(spin_y, pair.j()) + row_at(spin_y, pair.i());
    }
    to_columns(row, column);
    Block* const blocks[8] = {&p.bx, &p.by, &p.bz, &p.wz, &p.ux, &p.uy, &p.uz, &p.wx};
    for (std::size_t c = 0; c < 8; ++c)
      Level::put_column(&(*blocks[c])[k], column[c]);
  }
}

/// Limits tangential forces by Coulomb's law, in simple loops that become vector code: while a specimen is
/// sheared, most blocks have a sliding contact.
GRANUM_INLINE void limit_block(double friction, const PairBlock& __restrict p, Eight& __restrict sliding,
                               double* __restrict mx, double* __restrict my, double* __restrict mz) {
  Block slides_of, scale; // NaN without contact, and unused there
  for (std::size_t k = 0; k < block_size; ++k)
    scale[k] = friction * p.force[k] / std::sqrt(p.shear_squared[k]);
  for (std::size_t k = 0; k < block_size; ++k) {
    const double limit = friction * p.force[k];
    const bool slides = p.shear_squared[k] > limit * limit;
    scale[k] = slides ? scale[k] : 1.0;
    slides_of[k] = slides ? 1.0 : 0.0;
  }
  for (std::size_t k = 0; k < block_size; ++k) {
    mx[k] *= scale[k];
    my[k] *= scale[k];
    mz[k] *= scale[k];
  }
  for (std::size_t k = 0; k < block_size; k += 8)
    sliding += eight(slides_of, k);
}

/// Tangential increment against the relative displacement of the two surfaces, Coulomb's limit, torque, in
/// loops of short chains (normal_forces.hpp). mx .. mk: this block's memory.
template <VectorLevel level, class Sizes>
GRANUM_INLINE void frictional_forces(const SweepInput& in, const Sizes& sizes, PairBlock& __restrict p,
                                     Eight& __restrict sliding, double* __restrict mx, double* __restrict my,
                                     double* __restrict mz, double* __restrict mk) {
  const double ratio = in.tangential_ratio, friction = in.friction, elapsed = in.elapsed;
  std::int64_t any_slides = 0;
  const Mat3 gradient = in.gradient;
  for (std::size_t k = 0; k < block_size; ++k) {
    const double bx = p.bx[k], by = p.by[k], bz = p.bz[k];
    const double share = sizes.share(k);
    const double wx = share * p.wx[k], wy = share * p.wy[k], wz = share * p.wz[k];
    p.ux[k] += product<level>(gradient(0, 0), gradient(0, 1) + wz, gradient(0, 2) - wy, bx, by, bz);
    p.uy[k] += product<level>(gradient(1, 0) - wz, gradient(1, 1), gradient(1, 2) + wx, bx, by, bz);
    p.uz[k] += product<level>(gradient(2, 0) + wy, gradient(2, 1) - wx, gradient(2, 2), bx, by, bz);
  }
  for (std::size_t k = 0; k < block_size; ++k) {
    const double stiffness = ratio * p.stiffness[k];
    const double keep = stiffness < mk[k] ? stiffness / mk[k] : 1.0;
    const double increment = stiffness * elapsed;
    mx[k] = fused<level>(keep, mx[k], -increment * p.ux[k]);
    my[k] = fused<level>(keep, my[k], -increment * p.uy[k]);
    mz[k] = fused<level>(keep, mz[k], -increment * p.uz[k]);
    mk[k] = stiffness;
  }
  for (std::size_t k = 0; k < block_size; ++k) {
    const double bx = p.bx[k], by = p.by[k], bz = p.bz[k];
    double sx = mx[k], sy = my[k], sz = mz[k];
    const double along = product<level>(sx, sy, sz, bx, by, bz) * (p.inverse_length[k] * p.inverse_length[k]);
    sx = fused<level>(-along, bx, sx);
    sy = fused<level>(-along, by, sy);
    sz = fused<level>(-along, bz, sz);
    const double limit = friction * p.force[k];
    const double shear_squared = product<level>(sx, sy, sz, sx, sy, sz);
    any_slides |= static_cast<std::int64_t>(shear_squared > limit * limit);
    p.shear_squared[k] = shear_squared;
    mx[k] = sx;
    my[k] = sy;
    mz[k] = sz;
  }
  if (any_slides != 0)
    limit_block(friction, p, sliding, mx, my, mz);
  for (std::size_t k = 0; k < block_size; ++k) {
    const double bx = p.bx[k], by = p.by[k], bz = p.bz[k];
    const double sx = mx[k], sy = my[k], sz = mz[k];
    p.fx[k] += sx;
    p.fy[k] += sy;
    p.fz[k] += sz;
    const double share = sizes.share(k);
    p.tx[k] = -share * fused<level>(by, sz, -bz * sy);
    p.ty[k] = -share * fused<level>(bz, sx, -bx * sz);
    p.tz[k] = -share * fused<level>(bx, sy, -by * sx);
  }
}

/// Purpose of a sweep: an engine with friction, without, or a minimiser, which needs fewer sums.
enum class Purpose { friction, smooth, descent };

/// Sums of products of force and branch. Each vector level handles as many lanes of the nine sums at a time
/// as fit into its registers, and reads each force and branch once: reads limit the speed here.
template <class Level>
GRANUM_INLINE void add_stress(const PairBlock& p, SumRows& sums) {
  using Column = typename Level::Column;
  for (std::size_t first = 0; first < 8; first += Level::lanes) {
    const auto part = [&](std::size_t n) { return reinterpret_cast<double*>(&sums.stress[n]) + first; };
    const auto sum = [&](std::size_t n) { return Level::get_column(part(n)); };
    Column xx = sum(0), xy = sum(1), xz = sum(2), yx = sum(3), yy = sum(4), yz = sum(5), zx = sum(6),
           zy = sum(7), zz = sum(8);
    // Not unrolled: the sums of one turn would compete with the next numbers for registers.
#pragma GCC unroll 1
    for (std::size_t k = first; k < block_size; k += 8) {
      const Column bx = read_once<Level>(&p.bx[k]), by = read_once<Level>(&p.by[k]),
                   bz = read_once<Level>(&p.bz[k]), fx = read_once<Level>(&p.fx[k]),
                   fy = read_once<Level>(&p.fy[k]), fz = read_once<Level>(&p.fz[k]);
      xx += fx * bx;
      xy += fx * by;
      xz += fx * bz;
      yx += fy * bx;
      yy += fy * by;
      yz += fy * bz;
      zx += fz * bx;
      zy += fz * by;
      zz += fz * bz;
    }
    const Column made[9] = {xx, xy, xz, yx, yy, yz, zx, zy, zz};
    for (std::size_t n = 0; n < 9; ++n)
      Level::put_column(part(n), made[n]);
  }
}

template <Purpose purpose, class Level>
GRANUM_INLINE void add_up(const PairBlock& p, SumRows& sums) {
  if constexpr (purpose != Purpose::descent)
    add_stress<Level>(p, sums);
  Eight virial = sums.virial, normal_force = sums.normal_force, stiffness_sum = sums.stiffness,
        stiffest = sums.stiffest, contacts = sums.contacts;
  for (std::size_t k = 0; k < block_size; k += 8) {
    const Eight force = eight(p.force, k), stiffness = eight(p.stiffness, k), squared = eight(p.squared, k);
    if constexpr (purpose == Purpose::descent)
      virial += force * (squared * eight(p.inverse_length, k));
    else
      stiffness_sum += stiffness * squared;
    normal_force += force;
    stiffest = stiffest > stiffness ? stiffest : stiffness;
    contacts += force > 0 ? Eight{1, 1, 1, 1, 1, 1, 1, 1} : Eight{};
  }
  sums.virial = virial;
  sums.normal_force = normal_force;
  sums.stiffness = stiffness_sum;
  sums.stiffest = stiffest;
  sums.contacts = contacts;
}

/// The row of a grain i, kept in registers while pairs have the same i; writing and reading it for each pair
/// would wait for the store every time. No other code changes that row meanwhile: forces on j go to rows of
/// later grains or to spare ones; padding, with j = i, adds zeros.
/// \param    Part   get and put of the kept part of a row
template <class Part, class Load>
class KeptRow {
 public:
  GRANUM_INLINE KeptRow(Load* load, RowPlace grain)
      : load_(load), grain_(grain), sum_(Part::get(&row_at(load, grain))) {}
  GRANUM_INLINE typename Part::Row& of(RowPlace grain) {
    if (grain != grain_) {
      put_back();
      grain_ = grain;
      sum_ = Part::get(&row_at(load_, grain));
    }
    return sum_;
  }
  GRANUM_INLINE void put_back() { Part::put(&row_at(load_, grain_), sum_); }

 private:
  Load* load_;
  RowPlace grain_;
  typename Part::Row sum_;
};

/// The force of a row of loads, without its torque.
struct PushOfRow {
  using Row = Four;
  GRANUM_INLINE static Four get(const auto* from) { return from->push; }
  GRANUM_INLINE static void put(auto* to, const Four& push) { to->push = push; }
};

/// Adds the forces of a block to its rows, pair by pair in the order of the list.
template <class Load>
GRANUM_INLINE void unload_forces(const ListedPair* pairs, const PairBlock& p, Load* load) {
  using Level = Rows<VectorLevel::avx2>;
  KeptRow<PushOfRow, Load> kept(load, pairs[0].i());
  for (std::size_t k = 0; k < block_size; k += 4) {
    Four push[4] = {Level::get_column(&p.fx[k]), Level::get_column(&p.fy[k]), Level::get_column(&p.fz[k]),
                    Four{}};
    transpose(push[0], push[1], push[2], push[3]);
    for (std::size_t n = 0; n < 4; ++n) {
      kept.of(pairs[k + n].i()) -= push[n];
      row_at(load, pairs[k + n].row()).push += push[n];
    }
  }
  kept.put_back();
}

template <class Level>
GRANUM_INLINE void unload_block(const ListedPair* pairs, const PairBlock& p, LoadRow* load) {
  const auto sign = Level::row(Four{1, 1, 1, 1}, Four{-1, -1, -1, 1}); // forces are opposite, torques equal
  const typename Level::Column zero{};
  KeptRow<Level, LoadRow> kept(load, pairs[0].i());
  for (std::size_t k = 0; k < block_size; k += Level::lanes) {
    typename Level::Row row[Level::lanes];
    typename Level::Column column[8] = {Level::get_column(&p.ty[k]),
                                        zero,
                                        zero,
                                        Level::get_column(&p.tz[k]),
                                        Level::get_column(&p.fx[k]),
                                        Level::get_column(&p.fy[k]),
                                        Level::get_column(&p.fz[k]),
                                        Level::get_column(&p.tx[k])};
    to_rows(column, row);
    for (std::size_t n = 0; n < Level::lanes; ++n) {
      typename Level::Row& on_i = kept.of(pairs[k + n].i());
      on_i = on_i + sign * row[n];
      LoadRow& on_j = row_at(load, pairs[k + n].row());
      Level::put(&on_j, Level::get(&on_j) + row[n]);
    }
  }
  kept.put_back();
}

double total(const Eight& row) {
  double sum = 0;
  for (std::size_t k = 0; k < 8; ++k)
    sum += row[k];
  return sum;
}

double largest(const Eight& row) {
  double most = 0;
  for (std::size_t k = 0; k < 8; ++k)
    most = std::max(most, row[k]);
  return most;
}

SweepSums whole_totals(const SumRows& sums) {
  SweepSums out;
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col)
      out.stress(row, col) = total(sums.stress[static_cast<std::size_t>(3 * row + col)]);
  out.normal_force = total(sums.normal_force);
  out.stiffness = total(sums.stiffness);
  out.stiffest = largest(sums.stiffest);
  out.contacts = static_cast<std::size_t>(total(sums.contacts));
  out.sliding = static_cast<std::size_t>(total(sums.sliding));
  return out;
}

DescentSums descent_totals(const SumRows& sums) {
  return {.virial = total(sums.virial),
          .normal_force = total(sums.normal_force),
          .stiffest = largest(sums.stiffest),
          .contacts = static_cast<std::size_t>(total(sums.contacts))};
}

template <class Input, class LoadOf>
struct Work {
  using Load = LoadOf;
  const Input& in;
  const Shifts& shifts;
  const Chunk& chunk;
  MemoryBlock* memory; ///< null: frictionless
  Load* load;
  SumRows& sums;
};
using EngineWork = Work<SweepInput, LoadRow>;
using DescentWork = Work<DescentInput, PushRow>;

/// Any law, chosen anew for each block: a step takes 3 % longer than with a sweep of its own for each law.
struct OtherLaw {
  const contact::NormalKernel& kernel;
};

template <class Sizes>
[[gnu::noinline]] void forces_at(VectorLevel level, const OtherLaw& law, const Sizes& sizes, PairBlock& p) {
  const auto forces = [&](const auto& kernel) {
    at_vector_level(
        [&]<VectorLevel used>(AtLevel<used>)
            __attribute__((always_inline)) { normal_forces<used>(kernel, sizes, p); },
        level);
  };
  std::visit(forces, law.kernel);
}

template <VectorLevel level, class Sizes>
GRANUM_INLINE void normal_forces(const OtherLaw& law, const Sizes& sizes, PairBlock& p) {
  forces_at(level, law, sizes, p);
}

template <Purpose purpose, class Level, class Law, class Sizes, class AnyWork>
GRANUM_INLINE void sweep_block(const Law& law, const Sizes& sizes, const AnyWork& work,
                               const ListedPair* pairs, MemoryBlock* memory, PairBlock& p) {
  constexpr bool tangential = purpose == Purpose::friction;
  if constexpr (tangential)
    load_block<Level>(work.in, work.shifts, pairs, p);
  else
    load_branches(work.in, work.shifts, pairs, p);
  normal_forces<Level::level>(law, sizes, p);
  if constexpr (tangential)
    frictional_forces<Level::level>(work.in, sizes, p, work.sums.sliding, memory->x.data(), memory->y.data(),
                                    memory->z.data(), memory->stiffness.data());
  add_up<purpose, Level>(p, work.sums);
  if constexpr (tangential)
    unload_block<Level>(pairs, p, work.load);
  else
    unload_forces(pairs, p, work.load);
}

template <Purpose purpose, class Sizes, class Level, class Law, class AnyWork>
GRANUM_INLINE void sweep_all(const Law& law, const AnyWork& work) {
  PairBlock p;
  Sizes sizes(work.in);
  if constexpr (purpose != Purpose::descent) // a descent's rows are empty (glide_grains)
    for (const Range& rows : {work.chunk.grains, work.chunk.spare_rows})
      std::fill(work.load + rows.begin, work.load + rows.end, typename AnyWork::Load{});
  const ListedPair* const pairs = work.in.pairs.data();
  const bool far = work.in.grains.size() > grains_nearby;
  for (std::size_t first = work.chunk.pairs.begin; first < work.chunk.pairs.end; first += block_size) {
    if (far)
      fetch_ahead(pairs, work.in.grains, work.memory, work.load, first, work.chunk);
    sizes.load(work.in, pairs + first);
    MemoryBlock* const memory = purpose == Purpose::friction ? work.memory + first / block_size : nullptr;
    sweep_block<purpose, Level>(law, sizes, work, pairs + first, memory, p);
  }
}

template <class Sizes, class Level, class Law>
GRANUM_INLINE void sweep_with(const Law& law, const EngineWork& work) {
  if (work.memory != nullptr)
    sweep_all<Purpose::friction, Sizes, Level>(law, work);
  else
    sweep_all<Purpose::smooth, Sizes, Level>(law, work);
}
template <class Sizes, class Level, class Law>
GRANUM_INLINE void sweep_with(const Law& law, const DescentWork& work) {
  sweep_all<Purpose::descent, Sizes, Level>(law, work);
}

/// The vectors are chosen once for all pairs, and so are spheres, the most frequent law.
template <class Sizes, class AnyWork>
void run_sweep(const contact::NormalKernel& law, const AnyWork& work) {
  const auto run = [&](const auto& kernel) {
    at_vector_level([&]<VectorLevel level>(AtLevel<level>)
                        __attribute__((always_inline)) { sweep_with<Sizes, Rows<level>>(kernel, work); });
  };
  if (const auto* const spheres = std::get_if<contact::SphereKernel>(&law))
    run(*spheres);
  else
    run(OtherLaw{law});
}

template <class Load, class Input>
SumRows sums_of_sweep(const contact::NormalKernel& law, const Input& input, const Chunk& chunk,
                      MemoryBlock* memory, std::vector<Load>& load) {
  const Shifts shifts = shift_rows(input.cell, input.diameter);
  SumRows sums;
  const Work<Input, Load> work{input, shifts, chunk, memory, load.data(), sums};
  if (input.grains.own.empty())
    run_sweep<EqualGrains>(law, work);
  else
    run_sweep<UnequalGrains>(law, work);
  return sums;
}

} // namespace

SweepSums& SweepSums::operator+=(const SweepSums& other) {
  stress += other.stress;
  normal_force += other.normal_force;
  stiffness += other.stiffness;
  stiffest = std::max(stiffest, other.stiffest);
  contacts += other.contacts;
  sliding += other.sliding;
  return *this;
}

DescentSums& DescentSums::operator+=(const DescentSums& other) {
  virial += other.virial;
  normal_force += other.normal_force;
  stiffest = std::max(stiffest, other.stiffest);
  contacts += other.contacts;
  return *this;
}

SweepSums contact_sweep(const contact::NormalKernel& law, const SweepInput& input, const Chunk& chunk,
                        MemoryBlock* memory, std::vector<LoadRow>& load) {
  return whole_totals(sums_of_sweep<LoadRow>(law, input, chunk, memory, load));
}

DescentSums descent_sweep(const contact::NormalKernel& law, const DescentInput& input, const Chunk& chunk,
                          std::vector<PushRow>& load) {
  return descent_totals(sums_of_sweep<PushRow>(law, input, chunk, nullptr, load));
}

} // namespace granum::dem
