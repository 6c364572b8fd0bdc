// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: b branch from a grain over the radii that it spans, n its direction; k stiffness of a contact,
// r = k_t/k_n.
#include "frequency_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

#include <granum/contact/pair.hpp>

namespace granum::dem {

namespace {

/// A contact of two grains, b from i to j.
struct Spring {
  std::uint32_t i, j;
  double stiffness;
  Vec3 branch;
};

/// A contact with a wall, b from the grain.
struct WallSpring {
  std::uint32_t grain;
  double stiffness;
  Vec3 branch;
};

struct Springs {
  std::vector<Spring> pairs;
  std::vector<WallSpring> walls;
};

/// Sum of k nn.
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
  /// No eigenvalue is farther from a third of the trace than this.
  [[nodiscard]] double spread() const {
    const double mean = trace() / 3, x = xx - mean, y = yy - mean, z = zz - mean;
    return std::sqrt(2.0 / 3 * (x * x + y * y + z * z + 2 * (xy * xy + xz * xz + yz * yz)));
  }
};

/// Sums over the contacts of a grain.
struct StiffnessBlock {
  NormalSum sticking, smooth; ///< contacts with tangential stiffness, and without
  Vec3 couple;                ///< sum of k b, which ties turning to moving

  void add(double stiffness, double per_squared, const Vec3& b) {
    sticking.add(stiffness * per_squared, b);
    couple += stiffness * b;
  }

  /// At least the largest eigenvalue: sum of k_n nn + k_t (1 - nn) where the grain moves, of k_t (1 - nn) at
  /// most where it turns (lengths in radii), of k_t b x between both [N/m].
  [[nodiscard]] double largest(double r) const {
    const double trace = sticking.trace(), spread = sticking.spread();
    NormalSum beyond = smooth;
    const double s = 1 - r;
    beyond.xx += s * sticking.xx, beyond.yy += s * sticking.yy, beyond.zz += s * sticking.zz;
    beyond.xy += s * sticking.xy, beyond.xz += s * sticking.xz, beyond.yz += s * sticking.yz;
    const double moving = r * trace + beyond.trace() / 3 + beyond.spread();
    const double turning = r * (2.0 / 3 * trace + spread);
    return (moving + turning) / 2 + std::hypot((moving - turning) / 2, r * norm(couple));
  }
};

template <class Law>
std::vector<Spring> pair_springs(const Law& law, const FrequencyInput& in) {
  const std::array<Vec3, 27> shifts = shift_vectors(in.cell);
  std::vector<Spring> springs;
  springs.reserve(in.contacts);
  for (const Pair& pair : in.pairs) {
    const Vec3 branch = in.grains.centre(pair.j) + shifts[pair.image] - in.grains.centre(pair.i);
    const double squared = dot(branch, branch);
    const double reach = in.grains.radius_or(in.radius, pair.i) + in.grains.radius_or(in.radius, pair.j);
    if (squared >= reach * reach)
      continue;
    const double overlap = reach - std::sqrt(squared);
    const auto& own = in.grains.own;
    const Law of_pair = own.empty() ? law : contact::of_sizes(law, own[pair.i].size, own[pair.j].size);
    const double stiffness = of_pair(overlap).stiffness;
    if (stiffness > 0)
      springs.push_back({pair.i, pair.j, stiffness, 1 / reach * branch});
  }
  return springs;
}

template <class Law>
std::vector<WallSpring> wall_springs(const Law& law, const FrequencyInput& in, const WallContacts& walls) {
  const std::array<WallPlane, wall_count> planes = wall_planes(in.cell);
  std::vector<WallSpring> springs;
  for (const WallHistory& contact : walls.candidates()) {
    const WallPlane& plane = planes[contact.wall];
    const double radius = in.grains.radius_or(in.radius, contact.grain);
    const double distance = wall_distance(plane, in.grains.centre(contact.grain));
    if (distance < radius)
      springs.push_back({contact.grain,
                         wall_response(law, in.grains, contact.grain, radius - distance).stiffness,
                         -distance / radius * plane.normal});
  }
  return springs;
}

/// Blocks that, each on its own grain, outweigh the stiffness of all contacts: a contact pulls with
/// k (a - b)^2, at most k (1 + w_b/w_a) a^2 + k (1 + w_a/w_b) b^2. Walls do not move.
/// \param    moved   w of each grain > 0
std::vector<StiffnessBlock> outweighing_blocks(const Springs& springs, const std::vector<double>& moved,
                                               bool smooth_walls) {
  std::vector<StiffnessBlock> blocks(moved.size());
  for (const Spring& spring : springs.pairs) {
    const double per_squared = 1 / dot(spring.branch, spring.branch);
    const double ratio = moved[spring.j] / moved[spring.i];
    blocks[spring.i].add(spring.stiffness * (1 + ratio), per_squared, spring.branch);
    blocks[spring.j].add(spring.stiffness * (1 + 1 / ratio), per_squared, -spring.branch);
  }
  for (const WallSpring& spring : springs.walls) {
    const double per_squared = 1 / dot(spring.branch, spring.branch);
    StiffnessBlock& block = blocks[spring.grain];
    if (smooth_walls)
      block.smooth.add(spring.stiffness * per_squared, spring.branch);
    else
      block.add(spring.stiffness, per_squared, spring.branch);
  }
  return blocks;
}

} // namespace

double highest_frequency_squared(const contact::NormalKernel& law, const FrequencyInput& in,
                                 const WallContacts* walls) {
  const Springs springs = std::visit(
      [&](const auto& kernel) {
        return Springs{pair_springs(kernel, in),
                       walls != nullptr ? wall_springs(kernel, in, *walls) : std::vector<WallSpring>{}};
      },
      law);
  const auto per_mass = [&](std::size_t g) {
    return in.grains.own.empty() ? 1 / in.mass : in.grains.own[g].per_mass;
  };
  // How far the grains move in the fastest mode, guessed by what holds them, and better from the first bound.
  std::vector<double> moved(in.grains.size());
  for (const Spring& spring : springs.pairs) {
    moved[spring.i] += spring.stiffness * per_mass(spring.i);
    moved[spring.j] += spring.stiffness * per_mass(spring.j);
  }
  const bool smooth_walls = walls != nullptr && walls->friction() == 0;
  double bound = std::numeric_limits<double>::infinity();
  for (int guess = 0; guess < 2; ++guess) {
    const std::vector<StiffnessBlock> blocks = outweighing_blocks(springs, moved, smooth_walls);
    double highest = 0;
    for (std::size_t g = 0; g < blocks.size(); ++g) {
      const double own = blocks[g].largest(in.tangential_ratio) * per_mass(g);
      moved[g] *= own;
      highest = std::max(highest, own);
    }
    bound = std::min(bound, highest);
  }
  return bound;
}

} // namespace granum::dem
