// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/dem/neighbours.hpp>
#include <granum/dem/specimen.hpp>

namespace granum::dem {

/// Whether pairs across the faces of the cell count, by the state's boundary.
inline Images images(const Specimen& state) { return state.walls ? Images::none : Images::periodic; }

/// How far grains have come since some moment.
struct Drift {
  double farthest = 0; ///< largest displacement beside the cell's strain [m]
  double strain = 0;   ///< of the cell, the sum of magnitudes
};

/// Sum of the magnitudes of a strain's components.
[[nodiscard]] double size_of_strain(const Mat3& gradient);

/// Where grains and cell were at some moment.
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

/// Pair list with a skin: holds every pair nearer than contact distance until `valid` says no. From the
/// second time on it is taken from a list with a wider skin, as long as that one cannot lack a pair: the
/// same pairs as a search finds, in a fraction of the time.
/// Checked against searches by tests/dem/test_verlet_list.cpp
class VerletList {
 public:
  /// \param    skin, wide_skin   over the radius of a grain of size 1; no wider list where the latter is not
  ///           larger, or where the cell is too narrow for it
  VerletList(const Specimen& state, double skin, double wide_skin = 0);

  /// Wraps the centres of a periodic cell and lists the pairs anew. The grains and their order are those of
  /// the first build.
  void build(Specimen& state);

  /// Since build.
  template <class CentreOf>
  [[nodiscard]] Drift drift(const Mat3& cell_now, const CentreOf& centre_now) const {
    return reference_.drift(cell_now, centre_now);
  }

  /// False when two grains that are not listed could have come into contact since build.
  [[nodiscard]] bool valid(const Drift& drift) const { return nearing(drift) < skin_; }
  /// What the centres of a pair that the list lacks have neared each other at most since build [m].
  [[nodiscard]] double nearing(const Drift& drift) const { return nearing(drift, skin_); }

  /// Of the next list, which is to be built before anything else is asked [m].
  void set_skin(double skin) { skin_ = skin; }

  /// Whether valid() could say no before long, from upper bounds of the drift.
  [[nodiscard]] bool may_be_outdated(double travelled, double strained) const {
    return nearing({travelled, strained}, skin_) > 0.9 * skin_;
  }
  /// The same of this very moment, for those who ask valid() then: bounds that add up strains are too low by
  /// half of their square, which is below a twentieth of the skin.
  [[nodiscard]] bool may_be_invalid(double travelled, double strained) const {
    return nearing({travelled, strained}, skin_) > 0.95 * skin_;
  }

  /// Takes a list as it was built elsewhere; valid() is not asked before the next build.
  void restore(std::vector<Pair> pairs) { pairs_ = std::move(pairs); }

  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
  [[nodiscard]] double skin() const { return skin_; }
  /// Searches through all grains that its lists took so far.
  [[nodiscard]] std::size_t searches() const { return searches_; }

 private:
  /// What the centres of a pair that a list with a skin lacks have neared each other at most: twice the
  /// largest displacement plus what the cell's strain takes from the list's cutoff [m].
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
  Reference reference_, wide_reference_; ///< the latter without grains: there is no wider list
  std::size_t searches_ = 0;
};

} // namespace granum::dem
