// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/core/vec3.hpp>

#include "grain_rows.hpp"
#include "partition.hpp"
#include "stiffness_block.hpp"
#include "wall_contacts.hpp"

namespace granum::dem {

struct FrequencyInput {
  const Partition& parts; ///< of the grains and of all pairs that may touch
  const Grains& grains;
  Mat3 cell;
  double radius;           ///< where all grains are equal [m]
  double tangential_ratio; ///< k_t/k_n; 0 without friction
  double mass;             ///< likewise [kg]
};

/// Strict bound on omega^2 of the highest frequency. A contact couples two grains, so the stiffness matrix is
/// at most a block diagonal in which each contact counts 1 + w_j/w_i times for grain i, with any w > 0, and
/// the bound is closest if w equals the amplitudes of the fastest mode. Two guesses of w are tried: the
/// stiffness of each grain's contacts, and this times the bound that it gives. Result: 1.1 to 1.3 times the
/// highest frequency squared of packings at rest.
/// Assumes   a rotational inertia of m R^2.
/// Checked by tests/dem/test_frequency_bound.cpp
class FrequencyBound {
 public:
  /// Calls a job with the number of every chunk, in any order or at the same time.
  using EachChunk = std::function<void(const std::function<void(std::size_t)>&)>;

  /// omega^2 [1/s^2]; 0 without contacts. The same bits for any order of the chunks. Working memory is kept
  /// for the next call.
  /// \param    walls   null: none
  [[nodiscard]] double highest_squared(const contact::NormalKernel& law, const FrequencyInput& input,
                                       const WallContacts* walls, const EachChunk& each_chunk);

 private:
  /// A contact of two grains.
  struct Spring {
    std::uint32_t i, j;
    double stiffness;
    double per_squared; ///< 1/branch^2
    Vec3 branch;        ///< from i to j, over both radii
  };
  /// A contact with a wall.
  struct WallSpring {
    std::uint32_t grain;
    double stiffness;
    Vec3 branch; ///< from the grain, over its radius
  };
  /// Data of the grains of one chunk.
  struct OfChunk {
    std::vector<Spring> springs; ///< of its pairs
    std::vector<WallSpring> walls;
    std::vector<const Spring*> incoming; ///< of earlier chunks' pairs with one of its grains, in their order
    std::vector<StiffnessBlock> blocks;
    std::vector<NormalSum> smooth; ///< of contacts with smooth walls; empty where there are none
    double highest = 0;
  };

  void find_springs(const contact::NormalKernel& law, const FrequencyInput& in, const WallContacts* walls,
                    std::size_t chunk);
  void hand_over(const Partition& parts);
  void guess_motion(const FrequencyInput& in, std::size_t chunk);
  void fill_blocks(const FrequencyInput& in, bool smooth_walls, std::size_t chunk);
  void improve_guess(const FrequencyInput& in, bool last, std::size_t chunk);

  std::vector<OfChunk> chunks_;
  std::vector<double> moved_;  ///< guessed amplitude > 0 of each grain in the fastest mode
  std::vector<double> better_; ///< the next guess
};

} // namespace granum::dem
