// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/dem/neighbours.hpp>
#include <granum/dem/specimen.hpp>

namespace granum::dem {

// Shared by the search for pairs and the list made from another list, so that both find exactly the same
// pairs: images, wrapping into the cell, and the test of distance.

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

/// Whether pairs across the faces of the cell are included, from the state's boundary.
inline Images images(const Specimen& state) { return state.walls ? Images::none : Images::periodic; }

/// Displacements of grains since some time.
struct Drift {
  double farthest = 0; ///< largest displacement beside the cell's strain [m]
  double strain = 0;   ///< of the cell, the sum of magnitudes
};

/// Sum of the magnitudes of a strain's components.
[[nodiscard]] double size_of_strain(const Mat3& gradient);

/// Positions of grains and cell at some time.
struct Reference {
  Mat3 cell, cell_inverse;
  std::vector<Vec3> position;

  explicit Reference(const Specimen& state);
  Reference() = default;
  /// \param    centre_now   of a grain by its number
  template <class CentreOf>
  [[nodiscard]] Drift drift(const Mat3& now, const CentreOf& centre_now) const {
    const Mat3 gradient = now * cell_inverse;
    double farthest = 0;
    for (std::size_t g = 0; g < position.size(); ++g) {
      const Vec3 moved = centre_now(g) - gradient * position[g];
      farthest = std::max(farthest, dot(moved, moved));
    }
    return {.farthest = std::sqrt(farthest), .strain = size_of_strain(gradient)};
  }
};

/// Pair list with a skin: contains every pair within contact distance as long as valid() is true. From the
/// second build on it is made from a list with a wider skin, as long as that one is complete: the same pairs
/// as by a search, in a fraction of the time. Checked against searches by tests/dem/test_verlet_list.cpp
class VerletList {
 public:
  /// \param    skin, wide_skin over the radius of a grain of size 1; no wider list unless the latter is
  ///           larger and the cell is wide enough
  VerletList(const Specimen& state, double skin, double wide_skin = 0);

  /// Wraps the centres of a periodic cell and renews the list. Grains and their order must be as in the first
  /// build.
  void build(Specimen& state);

  /// Since build.
  template <class CentreOf>
  [[nodiscard]] Drift drift(const Mat3& cell_now, const CentreOf& centre_now) const {
    return reference_.drift(cell_now, centre_now);
  }

  /// False if two unlisted grains could have come into contact since build.
  [[nodiscard]] bool valid(const Drift& drift) const { return nearing(drift) < skin_; }
  /// Largest possible approach of the centres of an unlisted pair since build [m].
  [[nodiscard]] double nearing(const Drift& drift) const { return nearing(drift, skin_); }

  /// Sets the skin of the next list, which must be built before other calls [m].
  void set_skin(double skin) { skin_ = skin; }

  /// Whether valid() may soon be false, from upper bounds of the drift.
  [[nodiscard]] bool may_be_outdated(double travelled, double strained) const {
    return nearing({travelled, strained}, skin_) > 0.9 * skin_;
  }
  /// The same for the present moment, before a call of valid(). Bounds that sum strains are too low by half
  /// of the square of the sum, less than a twentieth of the skin.
  [[nodiscard]] bool may_be_invalid(double travelled, double strained) const {
    return nearing({travelled, strained}, skin_) > 0.95 * skin_;
  }

  /// Uses a list from elsewhere; valid() must not be called before the next build.
  void restore(std::vector<Pair> pairs) { pairs_ = std::move(pairs); }

  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
  [[nodiscard]] double skin() const { return skin_; }
  /// Number of searches through all grains so far.
  [[nodiscard]] std::size_t searches() const { return searches_; }

 private:
  /// Largest possible approach of the centres of an unlisted pair: twice the largest displacement plus the
  /// reduction of the cutoff by the strain of the cell [m].
  [[nodiscard]] double nearing(const Drift& drift, double skin) const {
    return 2 * drift.farthest + drift.strain * (contact_distance_ + skin);
  }
  [[nodiscard]] std::vector<Pair> search(const Specimen& state, double skin);
  [[nodiscard]] bool fits_wide(const Specimen& state) const;
  bool wrap_all(Specimen& state);
  void take_near_pairs(const Specimen& state);

  double contact_distance_; ///< of the two largest grains
  double skin_, wide_skin_;
  std::vector<double> radius_; ///< [m]; empty if all are equal
  std::vector<Pair> pairs_, wide_pairs_;
  Reference reference_, wide_reference_; ///< the latter is empty without a wider list
  std::size_t searches_ = 0;
};

} // namespace granum::dem
