// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: n normal of a contact, b branch; r = k_t/k_n.
#include "frequency_bound.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <granum/contact/pair.hpp>

namespace granum::dem {

namespace {

/// Sum of k nn over contacts; its trace is the sum of k.
struct NormalSum {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  /// \param    weight   k/|along|^2
  void add(double weight, const Vec3& along) {
    const double x = weight * along.x, y = weight * along.y, z = weight * along.z;
    xx += x * along.x;
    yy += y * along.y;
    zz += z * along.z;
    xy += x * along.y;
    xz += x * along.z;
    yz += y * along.z;
  }
  [[nodiscard]] double trace() const { return xx + yy + zz; }
};

/// Largest row sum of the magnitudes of a m + c 1.
double row_sum(const NormalSum& m, double a, double c) {
  const double xy = std::abs(a * m.xy), xz = std::abs(a * m.xz), yz = std::abs(a * m.yz);
  return std::max(
      {std::abs(a * m.xx + c) + xy + xz, std::abs(a * m.yy + c) + xy + yz, std::abs(a * m.zz + c) + xz + yz});
}

NormalSum combined(double a, const NormalSum& m, const NormalSum& other) {
  return {a * m.xx + other.xx, a * m.yy + other.yy, a * m.zz + other.zz,
          a * m.xy + other.xy, a * m.xz + other.xz, a * m.yz + other.yz};
}

template <class Law>
void add_pairs(const Law& law, const FrequencyInput& in, std::vector<NormalSum>& sums) {
  const std::array<Vec3, 27> shifts = shift_vectors(in.cell);
  for (const Pair& pair : in.pairs) {
    const Vec3 branch = in.grains.centre(pair.j) + shifts[pair.image] - in.grains.centre(pair.i);
    const double squared = dot(branch, branch);
    const double reach = in.grains.radius_or(in.radius, pair.i) + in.grains.radius_or(in.radius, pair.j);
    if (squared >= reach * reach)
      continue;
    const double overlap = reach - std::sqrt(squared);
    const auto& own = in.grains.own;
    const Law of_pair = own.empty() ? law : contact::of_sizes(law, own[pair.i].size, own[pair.j].size);
    const double weight = of_pair(overlap).stiffness / squared;
    sums[pair.i].add(weight, branch);
    sums[pair.j].add(weight, branch);
  }
}

template <class Law>
void add_walls(const Law& law, const FrequencyInput& in, const WallContacts& walls,
               std::vector<NormalSum>& sums) {
  const std::array<WallPlane, wall_count> planes = wall_planes(in.cell);
  for (const WallHistory& contact : walls.candidates()) {
    const WallPlane& plane = planes[contact.wall];
    const double overlap =
        in.grains.radius_or(in.radius, contact.grain) - wall_distance(plane, in.grains.centre(contact.grain));
    if (overlap > 0)
      sums[contact.grain].add(0.5 * wall_response(law, in.grains, contact.grain, overlap).stiffness,
                              plane.normal);
  }
}

} // namespace

double highest_frequency_squared(const contact::NormalKernel& law, const FrequencyInput& in,
                                 const WallContacts* walls) {
  const bool smooth_walls = walls != nullptr && walls->friction() == 0;
  std::vector<NormalSum> sums(in.grains.size()), smooth(smooth_walls ? in.grains.size() : 0);
  std::visit(
      [&](const auto& kernel) {
        add_pairs(kernel, in, sums);
        if (walls != nullptr)
          add_walls(kernel, in, *walls, smooth_walls ? smooth : sums);
      },
      law);
  const double r = in.tangential_ratio;
  double highest = 0;
  for (std::size_t g = 0; g < sums.size(); ++g) {
    const NormalSum& m = sums[g];
    const double across = r * m.trace();
    const double translation =
        smooth_walls ? row_sum(combined(1 - r, m, smooth[g]), 1, across) : row_sum(m, 1 - r, across);
    const double radius = in.grains.radius_or(in.radius, g);
    const bool equal = in.grains.own.empty();
    const double mass = equal ? in.mass : in.grains.own[g].mass;
    const double inertia = equal ? in.inertia : mass * radius * radius;
    const double rotation = r * radius * radius * row_sum(m, -1, m.trace());
    highest = std::max(highest, 2 * (translation / mass + rotation / inertia));
  }
  return highest;
}

} // namespace granum::dem
