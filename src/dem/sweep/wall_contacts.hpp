// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/contact/normal_law.hpp>
#include <granum/core/bytes.hpp>
#include <granum/dem/specimen.hpp>

#include "contact_sweep.hpp"

namespace granum::dem {

/// Normal force and stiffness of a grain on a rigid plane, from the law of two equal grains.
template <class Law>
contact::NormalResponse wall_response(const Law& law, double overlap) {
  const contact::NormalResponse pair = law(2 * overlap);
  return {pair.force, 2 * pair.stiffness};
}

/// The same for one of unequal grains.
template <class Law>
contact::NormalResponse wall_response(const Law& law, const GrainSizes& grains, std::size_t grain,
                                      double overlap) {
  if (grains.own.empty())
    return wall_response(law, overlap);
  const double size = grains.own[grain].size;
  return wall_response(contact::of_sizes(law, size, size), overlap);
}

/// Distance of a centre from a wall [m].
inline double wall_distance(const WallPlane& plane, const Vec3& x) {
  return dot(x - plane.centre, plane.normal);
}

/// The contacts of grains with walls: candidates near a wall, with their memories.
class WallContacts {
 public:
  explicit WallContacts(double friction) : friction_(friction) {}

  /// Lists the grains nearer to a wall than their radius plus the gap; contact memories move to their new
  /// positions.
  /// \param    radius   of all grains, if they are equal [m]
  template <class AnyGrains>
  void list(const Mat3& cell, const AnyGrains& grains, double radius, double gap,
            const std::vector<WallHistory>& history);
  /// Adds forces and torques on some grains to load and to the sums, and returns those on the walls.
  /// Tangential forces only if `tangential`, and if the walls are rough.
  WallForces sweep(const contact::NormalKernel& law, const SweepInput& input, Range of_grains,
                   bool tangential, std::vector<LoadRow>& load, SweepSums& sums);
  /// Forces only, on grains without rotation.
  WallForces descent_sweep(const contact::NormalKernel& law, const DescentInput& input, Range of_grains,
                           std::vector<PushRow>& load, DescentSums& sums);
  void set_forces(const WallForces& forces) { forces_ = forces; }

  void save(ByteWriter& to) const {
    to.put_all(contacts_);
    to.put(forces_);
  }
  void load(ByteReader& from, std::size_t grains) {
    contacts_ = from.get_all<WallHistory>();
    for (const WallHistory& contact : contacts_)
      if (contact.grain >= grains || contact.wall >= wall_count)
        from.fail("contains a wall contact of a grain that does not exist");
    forces_ = from.get<WallForces>();
  }

  [[nodiscard]] double friction() const { return friction_; }
  [[nodiscard]] const WallForces& forces() const { return forces_; }
  [[nodiscard]] std::vector<WallHistory> history() const;
  /// Number of listed pairs of grain and wall, with or without contact.
  [[nodiscard]] const std::vector<WallHistory>& candidates() const { return contacts_; }

 private:
  template <class Input, class Load, class Sums>
  WallForces sweep_all(const contact::NormalKernel& law, const Input& in, Range of_grains, bool rough,
                       std::vector<Load>& load, Sums& sums);

  double friction_;
  std::vector<WallHistory> contacts_; ///< sorted by (grain, wall)
  WallForces forces_;
};

} // namespace granum::dem
