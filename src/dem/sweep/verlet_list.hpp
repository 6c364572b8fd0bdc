// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/dem/neighbours.hpp>
#include <granum/dem/specimen.hpp>

namespace granum::dem {

/// Whether pairs across the faces of the cell count, by the state's boundary.
inline Images images(const Specimen& state) { return state.walls ? Images::none : Images::periodic; }

/// Pair list with a skin: holds every pair nearer than contact distance until `valid` says no.
class VerletList {
 public:
  /// \param    skin   over the radius of a grain of size 1
  VerletList(const Specimen& state, double skin)
      : contact_distance_(2 * state.radius * largest_size(state)), skin_(skin * state.radius) {}

  /// Wraps the centres of a periodic cell and lists the pairs anew. The grains have the sizes that they had.
  void build(Specimen& state) {
    if (!state.walls)
      wrap(state.cell, state.position);
    pairs_ = listed_pairs(state);
    reference_ = state.position;
    reference_inverse_ = inverse_of(state.cell);
  }

  /// How far the grains have come since build.
  struct Drift {
    double farthest = 0; ///< largest displacement beside the cell's strain [m]
    double strain = 0;   ///< of the cell, the sum of magnitudes
  };
  [[nodiscard]] Drift drift(const Mat3& cell, std::span<const Vec3> position) const {
    const Mat3 gradient = cell * reference_inverse_;
    Drift out;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        out.strain += std::abs(gradient(i, j) - (i == j ? 1 : 0));
    double farthest = 0;
    for (std::size_t g = 0; g < position.size(); ++g) {
      const Vec3 moved = position[g] - gradient * reference_[g];
      farthest = std::max(farthest, dot(moved, moved));
    }
    out.farthest = std::sqrt(farthest);
    return out;
  }

  /// False when two grains that are not listed could have come into contact since build: a pair nears by at
  /// most twice the largest non-affine displacement plus what the cell's strain takes from the cutoff.
  [[nodiscard]] bool valid(const Drift& drift) const {
    return 2 * drift.farthest + drift.strain * (contact_distance_ + skin_) < skin_;
  }

  /// Whether valid() could say no, from upper bounds of the drift.
  [[nodiscard]] bool may_be_outdated(double travelled, double strained) const {
    return 2 * travelled + strained * (contact_distance_ + skin_) > 0.9 * skin_;
  }

  /// Takes a list as it was built elsewhere; valid() is not asked before the next build.
  void restore(std::vector<Pair> pairs) { pairs_ = std::move(pairs); }

  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
  [[nodiscard]] double skin() const { return skin_; }

 private:
  [[nodiscard]] std::vector<Pair> listed_pairs(const Specimen& state) const {
    if (state.size.empty())
      return neighbour_pairs(state.cell, state.position, contact_distance_ + skin_, images(state));
    std::vector<double> radius;
    for (std::size_t g = 0; g < state.grain_count(); ++g)
      radius.push_back(state.radius_of(g));
    return neighbour_pairs(state.cell, state.position, radius, skin_, images(state));
  }

  double contact_distance_; ///< of the two largest grains
  double skin_;
  std::vector<Pair> pairs_;
  std::vector<Vec3> reference_;
  Mat3 reference_inverse_;
};

} // namespace granum::dem
