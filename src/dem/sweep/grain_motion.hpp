// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <cstdint>
#include <vector>

#include <granum/core/vec3.hpp>

#include "grain_rows.hpp"
#include "partition.hpp"

namespace granum::dem {

/// Sums over grains, always in the same order.
struct MotionSums {
  double kinetic = 0;       ///< sum of m v^2 + I w^2 [J]
  double power = 0;         ///< sum of f v + t w [W]
  double speed_squared = 0; ///< largest v^2 [m^2/s^2]

  MotionSums& operator+=(const MotionSums& other);
};

/// Change of velocities in a step with drag: v becomes keep v + push f, w becomes keep w + turn t. For
/// unequal grains R w and v gain push/m times t/R and f, with push in s.
struct Kick {
  double keep; ///< [1]
  double push; ///< [s/kg]
  double turn; ///< [s/(kg m^2)]
};

/// Sums over the forces on grains, before anything moves. Masses m are 1 where all grains are equal.
struct PushSums {
  double power = 0;      ///< sum of f v [W]
  double squares = 0;    ///< sum of f^2/m [N^2]
  double components = 0; ///< sum of |f_x| + |f_y| + |f_z|: 1 to sqrt(3) times that of |f| [N]

  PushSums& operator+=(const PushSums& other);
};

/// A step of a minimiser: v becomes keep v + push f/m, no longer than largest; x becomes growth (x + dt v).
struct Glide {
  double keep; ///< [1]
  double push; ///< [s]
  double dt;
  double growth;  ///< of the cell [1]
  double largest; ///< [m/s]
};

/// Velocities after a step of a minimiser.
struct GlideSums {
  double squares = 0; ///< sum of m v^2
  double fastest = 0; ///< the largest |v| before the limit
};

/// Moves the centres with the cell, x becomes stretch x, and with their own velocity.
void move_grains(Grains& grains, Range range, const Mat3& stretch, double dt);
/// Adds the spare rows with loads of a chunk, then sums f v + t w over it, with the velocities before their
/// kick [W].
double settle_loads(const Grains& grains, const Chunk& chunk, const std::vector<Addition>& additions,
                    std::vector<LoadRow>& load);
/// Adds the spare rows with loads of a chunk, empties them, and sums over its forces.
PushSums settle_pushes(const TranslatingGrains& grains, const Chunk& chunk,
                       const std::vector<Addition>& additions, std::vector<PushRow>& load);
/// Sum of |f| over the grains of a chunk in their order, after settling [N].
double lengths_of_forces(const Chunk& chunk, const std::vector<PushRow>& load);
/// Velocities and centres of all grains after the step; empties their rows of load for the next sweep.
GlideSums glide_grains(TranslatingGrains& grains, std::vector<PushRow>& load, const Glide& glide);
/// Sum of f^2/m + t^2/I [N^2/kg]. Mass and inertia as below.
double pull_of(const Grains& grains, Range range, const std::vector<LoadRow>& load, double mass,
               double inertia);
/// Stops grains without force.
void hold_free_grains(Grains& grains, Range range, const std::vector<LoadRow>& load);
/// New velocities, and the sums over them. Mass and inertia of equal grains; unused for unequal ones.
MotionSums kick_grains(Grains& grains, Range range, const std::vector<LoadRow>& load, const Kick& kick,
                       double mass, double inertia);

/// FIRE's rule for the turn of velocities towards the forces in a step, as published.    [Bitzek2006]
struct FireMixing {
  double share = first_share;
  std::uint64_t downhill_steps = 0; ///< counted up to the patience of the rule

  static constexpr double first_share = 0.1;
  static constexpr std::uint64_t patience = 5;

  /// A step with positive work of the forces. True after many of them.
  bool downhill() {
    if (downhill_steps < patience) {
      ++downhill_steps;
      return false;
    }
    share *= 0.99;
    return true;
  }
  /// A step without: restarts the rule.
  void uphill() { *this = {}; }
};

} // namespace granum::dem
