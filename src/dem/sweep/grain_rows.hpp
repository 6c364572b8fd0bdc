// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. What the sweep reads and writes of a grain, each in one cache line: a pair takes whole
// rows of its two grains, and four rows at a time are turned into columns. Angular velocity and torque stand
// at the same places of their rows, in the gaps that three numbers leave in rows of four.
#pragma once

#include <cstddef>
#include <vector>

#include <granum/core/vec3.hpp>

#include "core/vector/types.hpp"

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

/// The grains of an engine; y of the angular velocity has no room in the rows.
struct Grains {
  std::vector<MotionRow> row;
  std::vector<double> spin_y;

  void resize(std::size_t count) {
    row.assign(count, MotionRow{});
    spin_y.assign(count, 0.0);
  }
  [[nodiscard]] std::size_t size() const { return row.size(); }
  [[nodiscard]] Vec3 centre(std::size_t g) const {
    return {row[g].place[0], row[g].place[1], row[g].place[2]};
  }
  [[nodiscard]] Vec3 velocity(std::size_t g) const {
    return {row[g].rate[0], row[g].rate[1], row[g].rate[2]};
  }
  [[nodiscard]] Vec3 spin(std::size_t g) const { return {row[g].rate[3], spin_y[g], row[g].place[3]}; }

  void set_centre(std::size_t g, const Vec3& x) { row[g].place = Four{x.x, x.y, x.z, row[g].place[3]}; }
  void set_velocity(std::size_t g, const Vec3& v) { row[g].rate = Four{v.x, v.y, v.z, row[g].rate[3]}; }
  void set_spin(std::size_t g, const Vec3& w) {
    row[g].rate[3] = w.x;
    spin_y[g] = w.y;
    row[g].place[3] = w.z;
  }
};

inline Vec3 force(const LoadRow& load) { return {load.push[0], load.push[1], load.push[2]}; }
inline Vec3 torque(const LoadRow& load) { return {load.push[3], load.turn[0], load.turn[3]}; }
inline void add_force(LoadRow& load, const Vec3& f) { load.push += Four{f.x, f.y, f.z, 0}; }
inline void add_torque(LoadRow& load, const Vec3& t) {
  load.push[3] += t.x;
  load.turn += Four{t.y, 0, 0, t.z};
}

} // namespace granum::dem
