// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Data of a grain that the sweep reads, and that it writes, in one cache line each. A
// pair reads whole rows of its two grains; four rows at a time are transposed into columns. Angular velocity
// and torque are in the same positions of their rows, which vectors of three leave free in rows of four.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/dem/specimen.hpp>

#include "core/vector/level.hpp"

namespace granum::dem {

/// Centre x, own velocity v and part of the angular velocity w of a grain.
struct alignas(64) MotionRow {
  Four place; ///< x, y, z of x; z of w
  Four rate;  ///< x, y, z of v; x of w
};

/// Force f and torque t on a grain.
struct alignas(64) LoadRow {
  Four turn; ///< y of t; 0; 0; z of t
  Four push; ///< x, y, z of f; x of t
};

inline Vec3 three_of(const Four& row) { return {row[0], row[1], row[2]}; }

/// Data of a grain among unequal ones.
struct OwnSize {
  double size;     ///< radius over that of a grain of size 1 [1]
  double radius;   ///< [m]
  double mass;     ///< [kg]
  double per_mass; ///< [1/kg]
};

/// Data of each grain of a specimen; empty if all are equal.
/// \param    density   of the grains [kg/m^3]; the total mass is density times volume, divided as described
///           in engine.hpp
[[nodiscard]] std::vector<OwnSize> own_sizes(const Specimen& state, double density);

/// The same for a minimiser, whose masses are free. The number of contacts of a grain, and so the stiffness
/// that acts on it, grows with its surface; its mass is therefore the square of its size over the mean size,
/// and at least 1. With unit masses 2,000 grains of C_u = 3 were not at rest after 200,000 steps; with these
/// masses they need some 60,000.
/// Checked by tests/dem/test_grain_motion.cpp and tests/triaxial/test_specimen.cpp
[[nodiscard]] std::vector<OwnSize> sizes_for_descent(const Specimen& state);

/// Data of unequal grains; empty if all are equal.
struct GrainSizes {
  std::vector<OwnSize> own;
  std::vector<Two> round; ///< radius and curvature of `own`, for the loops over pairs [m, 1/m]

  void set_sizes(std::vector<OwnSize> sizes) {
    own = std::move(sizes);
    round.clear();
    for (const OwnSize& grain : own)
      round.push_back(Two{grain.radius, 1 / grain.radius});
  }
  /// Radius of a grain; `equal` if all have the same [m].
  [[nodiscard]] double radius_or(double equal, std::size_t g) const {
    return own.empty() ? equal : own[g].radius;
  }
};

/// The grains of an engine; y of the angular velocity is outside of the rows. For unequal grains the rows
/// contain R w instead of w, and t/R instead of t. The contact point divides the branch in the ratio of the
/// radii, so both grains of a pair get the same t/R, the surface velocity is the sum of both R w, and with an
/// inertia of m R^2 rotation follows the same equation as translation. The loops over pairs are then almost
/// the same for equal and unequal grains.
struct Grains : GrainSizes {
  std::vector<MotionRow> row;
  std::vector<double> spin_y;

  void resize(std::size_t count) {
    row.assign(count, MotionRow{});
    spin_y.assign(count, 0.0);
  }
  [[nodiscard]] std::size_t size() const { return row.size(); }
  [[nodiscard]] Vec3 centre(std::size_t g) const { return three_of(row[g].place); }
  [[nodiscard]] Vec3 velocity(std::size_t g) const { return three_of(row[g].rate); }
  /// Angular velocity.
  [[nodiscard]] Vec3 spin(std::size_t g) const {
    const Vec3 stored{row[g].rate[3], spin_y[g], row[g].place[3]};
    return own.empty() ? stored : (1 / own[g].radius) * stored;
  }

  /// A torque in the units of the rows.
  [[nodiscard]] Vec3 stored_torque(std::size_t g, const Vec3& t) const {
    return own.empty() ? t : (1 / own[g].radius) * t;
  }

  void set_centre(std::size_t g, const Vec3& x) { row[g].place = Four{x.x, x.y, x.z, row[g].place[3]}; }
  void set_velocity(std::size_t g, const Vec3& v) { row[g].rate = Four{v.x, v.y, v.z, row[g].rate[3]}; }
  void set_spin(std::size_t g, const Vec3& spin) {
    const Vec3 w = own.empty() ? spin : own[g].radius * spin;
    row[g].rate[3] = w.x;
    spin_y[g] = w.y;
    row[g].place[3] = w.z;
  }
};

/// Half of a row, for grains without rotation; the last number is 0. Structs, because the compiler may align
/// its own vectors of four as vectors of two.
struct alignas(32) PlaceRow {
  Four place; ///< x [m]
};
struct alignas(32) RateRow {
  Four rate; ///< v
};
struct alignas(32) PushRow {
  Four push; ///< f [N]
};

/// The grains of a minimiser, without rotation: a sweep reads half of the memory.
struct TranslatingGrains : GrainSizes {
  std::vector<PlaceRow> place;
  std::vector<RateRow> rate;

  void resize(std::size_t count) {
    place.assign(count, PlaceRow{});
    rate.assign(count, RateRow{});
  }
  [[nodiscard]] std::size_t size() const { return place.size(); }
  [[nodiscard]] Vec3 centre(std::size_t g) const { return three_of(place[g].place); }
  [[nodiscard]] Vec3 velocity(std::size_t g) const { return three_of(rate[g].rate); }
  void set_centre(std::size_t g, const Vec3& x) { place[g].place = Four{x.x, x.y, x.z, 0}; }
  void set_velocity(std::size_t g, const Vec3& v) { rate[g].rate = Four{v.x, v.y, v.z, 0}; }
};

inline Vec3 force(const LoadRow& load) { return three_of(load.push); }
inline Vec3 force(const PushRow& load) { return three_of(load.push); }
/// In the units of the rows.
inline Vec3 torque(const LoadRow& load) { return {load.push[3], load.turn[0], load.turn[3]}; }
inline void add_force(LoadRow& load, const Vec3& f) { load.push += Four{f.x, f.y, f.z, 0}; }
inline void add_force(PushRow& load, const Vec3& f) { load.push += Four{f.x, f.y, f.z, 0}; }
/// In the units of the rows: t, or t/R for unequal grains.
inline void add_torque(LoadRow& load, const Vec3& t) {
  load.push[3] += t.x;
  load.turn += Four{t.y, 0, 0, t.z};
}

// Order of the grains in an engine: neighbours are near in memory, for the caches. An order gives the new
// index of each grain.

/// Along a space-filling curve through the cell.
[[nodiscard]] std::vector<std::uint32_t> near_order(const Specimen& state);
[[nodiscard]] std::vector<std::uint32_t> inverse_order(const std::vector<std::uint32_t>& order);
/// Whether this is a permutation of `count` grains.
[[nodiscard]] bool is_order(const std::vector<std::uint32_t>& order, std::size_t count);

/// The same state with its grains in another order; contact memories are reversed where i and j are
/// exchanged.
[[nodiscard]] Specimen reordered(const Specimen& state, const std::vector<std::uint32_t>& order);

} // namespace granum::dem
