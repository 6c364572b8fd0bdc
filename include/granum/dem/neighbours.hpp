// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <granum/core/vec3.hpp>

namespace granum::dem {

/// Periodic images that a neighbour may be in: the cell itself and those around it.
inline constexpr std::uint32_t image_count = 27;

/// Two grains near each other; the image of j is at position[j] + shift_vectors(cell)[image].
struct Pair {
  std::uint32_t i = 0;
  std::uint32_t j = 0;
  std::uint32_t image = 13; ///< 0..26, 13 = no shift

  bool operator==(const Pair&) const = default;
};

/// The translations k1 a1 + k2 a2 + k3 a3, k in {-1, 0, 1}, of the cell whose columns are a1 a2 a3 [m].
[[nodiscard]] std::array<Vec3, image_count> shift_vectors(const Mat3& cell);

/// Moves every centre into the cell by multiples of the edge vectors.
void wrap(const Mat3& cell, std::span<Vec3> position);

enum class Images {
  periodic, ///< includes pairs across the faces of the cell
  none      ///< the cell is a box: pairs inside it only
};

/// All pairs i < j whose centres are nearer than cutoff, sorted by (i, j), each with its nearest image.
/// Assumes   centres lie in the cell (call wrap first if it is periodic).
/// \param    cutoff  [m]; if periodic, at most half of the smallest cell width, so that no pair occurs twice
/// \throws   InvalidArgument if the cell is too narrow for the cutoff
/// Cost      O(N) by cells of the cutoff's size.  Checked against all pairs by tests/dem/test_neighbours.cpp
[[nodiscard]] std::vector<Pair> neighbour_pairs(const Mat3& cell, std::span<const Vec3> position,
                                                double cutoff, Images images = Images::periodic);

/// The same for grains of different radii: all pairs whose centres are nearer than the sum of both radii and
/// the gap.
/// Assumes   as above.
/// \param    radius  of each grain [m]
/// \param    gap     >= 0 [m]; if periodic, twice the largest radius plus the gap is at most half of the
///           smallest cell width
/// \throws   InvalidArgument unless there is one radius for each grain, or if the cell is too narrow
/// Cost      O(N): each grain searches for smaller ones only, within a distance of its own size. Checked
///           against all pairs by tests/dem/test_neighbours.cpp
[[nodiscard]] std::vector<Pair> neighbour_pairs(const Mat3& cell, std::span<const Vec3> position,
                                                std::span<const double> radius, double gap,
                                                Images images = Images::periodic);

} // namespace granum::dem
