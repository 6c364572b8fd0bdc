// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Notation: b branch from a grain over the radii that it spans, n its direction; k
// stiffness of a contact, r = k_t/k_n.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/core/vec3.hpp>

#include "grain_rows.hpp"
#include "partition.hpp"
#include "wall_contacts.hpp"

namespace granum::dem {

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
  /// Adds a multiple of another sum.
  void add(double factor, const NormalSum& other) {
    xx += factor * other.xx, yy += factor * other.yy, zz += factor * other.zz;
    xy += factor * other.xy, xz += factor * other.xz, yz += factor * other.yz;
  }
  [[nodiscard]] double trace() const { return xx + yy + zz; }
  /// Largest possible distance of an eigenvalue from a third of the trace.
  [[nodiscard]] double spread() const {
    const double mean = trace() / 3, x = xx - mean, y = yy - mean, z = zz - mean;
    return std::sqrt(2.0 / 3 * (x * x + y * y + z * z + 2 * (xy * xy + xz * xz + yz * yz)));
  }
};

/// Sums over the contacts of a grain that have tangential stiffness.
struct StiffnessBlock {
  NormalSum sticking;
  Vec3 couple; ///< sum of k b, which couples rotation to translation

  void add(double stiffness, double per_squared, const Vec3& b) {
    sticking.add(stiffness * per_squared, b);
    couple += stiffness * b;
  }

  /// Upper bound of the largest eigenvalue: the sum of k_n nn + k_t (1 - nn) for translation, at most of k_t
  /// (1 - nn) for rotation (lengths in radii), and of k_t b x for their coupling [N/m]. If it cannot exceed
  /// `floor`, any number up to `floor`.
  /// \param    smooth   contacts without tangential stiffness
  [[nodiscard]] double largest(double r, const NormalSum& smooth, double floor) const {
    const double trace = sticking.trace(), spread = sticking.spread();
    NormalSum beyond = smooth;
    beyond.add(1 - r, sticking);
    const double moving = r * trace + beyond.trace() / 3 + beyond.spread();
    const double turning = r * (2.0 / 3 * trace + spread);
    const double mean = (moving + turning) / 2, half = (moving - turning) / 2, tie = r * norm(couple);
    constexpr double rounding = 1 - 1e-12;
    if (mean + std::abs(half) + tie < rounding * floor) // std::hypot takes as long as all the rest
      return 0;
    return mean + std::hypot(half, tie);
  }
};

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
