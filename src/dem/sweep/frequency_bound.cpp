// SPDX-License-Identifier: GPL-3.0-or-later
// Every sum over the contacts of a grain runs in the order of the list, for any chunks.
#include "frequency_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <granum/contact/grains.hpp>
#include <granum/dem/neighbours.hpp>

namespace granum::dem {

namespace {

double per_mass(const FrequencyInput& in, std::size_t g) {
  return in.grains.own.empty() ? 1 / in.mass : in.grains.own[g].per_mass;
}

} // namespace

void FrequencyBound::find_springs(const contact::NormalKernel& law, const FrequencyInput& in,
                                  const WallContacts* walls, std::size_t chunk) {
  const Chunk& range = in.parts.chunks[chunk];
  OfChunk& of = chunks_[chunk];
  of.springs.clear();
  of.walls.clear();
  of.incoming.clear();
  const std::array<Vec3, image_count> shifts = shift_vectors(in.cell);
  const auto& own = in.grains.own;
  const auto pair_springs = [&](const auto& kernel) {
    for (std::size_t k = range.pairs.begin; k < range.pairs.end; ++k) {
      const ListedPair& pair = in.parts.pairs[k];
      if (pair.image() == far_image)
        continue;
      const std::uint32_t i = pair.i().number(), j = pair.j().number();
      const Vec3 branch = in.grains.centre(j) + shifts[pair.image().number()] - in.grains.centre(i);
      const double squared = dot(branch, branch);
      const double reach = in.grains.radius_or(in.radius, i) + in.grains.radius_or(in.radius, j);
      if (squared >= reach * reach)
        continue;
      const double overlap = reach - std::sqrt(squared);
      const auto of_pair = own.empty() ? kernel : contact::of_sizes(kernel, own[i].size, own[j].size);
      const double stiffness = of_pair(overlap).stiffness;
      const Vec3 b = 1 / reach * branch;
      if (stiffness > 0)
        of.springs.push_back({i, j, stiffness, 1 / dot(b, b), b});
    }
  };
  const auto wall_springs = [&](const auto& kernel) {
    const std::array<WallPlane, wall_count> planes = wall_planes(in.cell);
    for (const WallHistory& contact : walls->candidates()) {
      if (contact.grain < range.grains.begin || contact.grain >= range.grains.end)
        continue;
      const WallPlane& plane = planes[contact.wall];
      const double radius = in.grains.radius_or(in.radius, contact.grain);
      const double distance = wall_distance(plane, in.grains.centre(contact.grain));
      if (distance < radius)
        of.walls.push_back({contact.grain,
                            wall_response(kernel, in.grains, contact.grain, radius - distance).stiffness,
                            -distance / radius * plane.normal});
    }
  };
  std::visit(
      [&](const auto& kernel) {
        pair_springs(kernel);
        if (walls != nullptr)
          wall_springs(kernel);
      },
      law);
}

/// Lists for each chunk the springs of earlier chunks that act on its grains.
void FrequencyBound::hand_over(const Partition& parts) {
  for (std::size_t c = 0; c + 1 < chunks_.size(); ++c)
    for (const Spring& spring : chunks_[c].springs)
      if (spring.j >= parts.chunks[c].grains.end)
        chunks_[parts.chunk_of(spring.j)].incoming.push_back(&spring);
}

/// As the stiffness that acts on a grain.
void FrequencyBound::guess_motion(const FrequencyInput& in, std::size_t chunk) {
  const Range& grains = in.parts.chunks[chunk].grains;
  const OfChunk& of = chunks_[chunk];
  std::fill(moved_.begin() + static_cast<std::ptrdiff_t>(grains.begin),
            moved_.begin() + static_cast<std::ptrdiff_t>(grains.end), 0.0);
  for (const Spring* spring : of.incoming)
    moved_[spring->j] += spring->stiffness * per_mass(in, spring->j);
  for (const Spring& spring : of.springs) {
    moved_[spring.i] += spring.stiffness * per_mass(in, spring.i);
    if (spring.j < grains.end)
      moved_[spring.j] += spring.stiffness * per_mass(in, spring.j);
  }
}

/// Diagonal blocks that bound the stiffness of all contacts: the energy of a contact, k (a - b)^2, is at most
/// k (1 + w_b/w_a) a^2 + k (1 + w_a/w_b) b^2, with w the guessed amplitudes. Walls do not move.
void FrequencyBound::fill_blocks(const FrequencyInput& in, bool smooth_walls, std::size_t chunk) {
  const Range& grains = in.parts.chunks[chunk].grains;
  OfChunk& of = chunks_[chunk];
  of.blocks.assign(grains.end - grains.begin, StiffnessBlock{});
  of.smooth.assign(smooth_walls ? of.blocks.size() : 0, NormalSum{});
  const auto add_to_j = [&](const Spring& spring, double ratio) {
    of.blocks[spring.j - grains.begin].add(spring.stiffness * (1 + 1 / ratio), spring.per_squared,
                                           -spring.branch);
  };
  for (const Spring* spring : of.incoming)
    add_to_j(*spring, moved_[spring->j] / moved_[spring->i]);
  for (const Spring& spring : of.springs) {
    const double ratio = moved_[spring.j] / moved_[spring.i];
    of.blocks[spring.i - grains.begin].add(spring.stiffness * (1 + ratio), spring.per_squared, spring.branch);
    if (spring.j < grains.end)
      add_to_j(spring, ratio);
  }
  for (const WallSpring& spring : of.walls) {
    const double per_squared = 1 / dot(spring.branch, spring.branch);
    const std::size_t k = spring.grain - grains.begin;
    if (smooth_walls)
      of.smooth[k].add(spring.stiffness * per_squared, spring.branch);
    else
      of.blocks[k].add(spring.stiffness, per_squared, spring.branch);
  }
}

/// \param    last   compute only the highest bound of a grain, no better guess
void FrequencyBound::improve_guess(const FrequencyInput& in, bool last, std::size_t chunk) {
  OfChunk& of = chunks_[chunk];
  const std::size_t first = in.parts.chunks[chunk].grains.begin;
  of.highest = 0;
  for (std::size_t k = 0; k < of.blocks.size(); ++k) {
    const std::size_t g = first + k;
    const double floor = last ? of.highest / per_mass(in, g) : 0;
    const NormalSum smooth = of.smooth.empty() ? NormalSum{} : of.smooth[k];
    const double own = of.blocks[k].largest(in.tangential_ratio, smooth, floor) * per_mass(in, g);
    better_[g] = moved_[g] * own;
    of.highest = std::max(of.highest, own);
  }
}

double FrequencyBound::highest_squared(const contact::NormalKernel& law, const FrequencyInput& in,
                                       const WallContacts* walls, const EachChunk& each_chunk) {
  chunks_.resize(in.parts.chunks.size());
  moved_.resize(in.grains.size());
  better_.resize(in.grains.size());
  each_chunk([&](std::size_t c) { find_springs(law, in, walls, c); });
  hand_over(in.parts);
  each_chunk([&](std::size_t c) { guess_motion(in, c); });
  const bool smooth_walls = walls != nullptr && walls->friction() == 0;
  double bound = std::numeric_limits<double>::infinity();
  for (int guess = 0; guess < 2; ++guess) {
    each_chunk([&](std::size_t c) {
      fill_blocks(in, smooth_walls, c);
      improve_guess(in, guess == 1, c);
    });
    moved_.swap(better_);
    double highest = 0;
    for (const OfChunk& of : chunks_)
      highest = std::max(highest, of.highest);
    bound = std::min(bound, highest);
  }
  return bound;
}

} // namespace granum::dem
