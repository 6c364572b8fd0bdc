// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Shared by the search for pairs and the list made from another list, so that both find
// exactly the same pairs: images, wrapping into the cell, and the test of distance.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include <granum/core/vec3.hpp>
#include <granum/dem/neighbours.hpp>

namespace granum::dem {

/// Index in shift_vectors() of the translation by k cell vectors, each -1, 0 or 1.
constexpr int image_index(int kx, int ky, int kz) { return (kx + 1) * 9 + (ky + 1) * 3 + (kz + 1); }
/// Index of the opposite translation.
constexpr std::uint32_t opposite(std::uint32_t image) { return 26 - image; }

/// Moves every centre into the cell, and calls moved(grain, whole) for those outside by `whole` cell vectors.
template <class Moved>
void wrap_each(const Mat3& cell, std::span<Vec3> position, const Moved& moved) {
  const Mat3 to_fraction = inverse_of(cell);
  for (std::size_t g = 0; g < position.size(); ++g) {
    const Vec3 s = to_fraction * position[g];
    const Vec3 whole{std::floor(s.x), std::floor(s.y), std::floor(s.z)};
    if (whole == Vec3{})
      continue;
    position[g] -= cell * whole;
    moved(g, whole);
  }
}

/// Pairs whose centres are nearer than a cutoff.
class EqualReach {
 public:
  EqualReach(const std::array<Vec3, image_count>& shifts, std::span<const Vec3> position, double cutoff)
      : shifts_(shifts), position_(position), squared_(cutoff * cutoff) {}
  bool operator()(const Pair& pair) const {
    const Vec3 branch = position_[pair.j] + shifts_[pair.image] - position_[pair.i];
    return dot(branch, branch) < squared_;
  }

 private:
  const std::array<Vec3, image_count>& shifts_;
  std::span<const Vec3> position_;
  double squared_;
};

/// Pairs whose centres are nearer than the sum of both radii and a gap. The branch leads to the smaller
/// grain, of two equal ones to j.
class UnequalReach {
 public:
  UnequalReach(const std::array<Vec3, image_count>& shifts, std::span<const Vec3> position,
               std::span<const double> radius, double gap)
      : shifts_(shifts), position_(position), radius_(radius), gap_(gap) {}
  bool operator()(const Pair& pair) const {
    return radius_[pair.j] > radius_[pair.i] ? to_smaller(pair.j, pair.i, opposite(pair.image))
                                             : to_smaller(pair.i, pair.j, pair.image);
  }
  bool to_smaller(std::uint32_t larger, std::uint32_t smaller, std::uint32_t image) const {
    const Vec3 branch = position_[smaller] + shifts_[image] - position_[larger];
    const double near = radius_[larger] + radius_[smaller] + gap_;
    return dot(branch, branch) < near * near;
  }

 private:
  const std::array<Vec3, image_count>& shifts_;
  std::span<const Vec3> position_;
  std::span<const double> radius_;
  double gap_;
};

} // namespace granum::dem
