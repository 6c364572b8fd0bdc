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
