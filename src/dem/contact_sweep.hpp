// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/core/vec3.hpp>
#include <granum/dem/neighbours.hpp>

#include "grain_rows.hpp"

namespace granum::dem {

/// Pairs are worked off in blocks of this many, so that each law is one vectorised loop over a block. Sums
/// run in this order too: every vector width gives the same bits.
inline constexpr std::size_t block_size = 32;
struct alignas(64) Block : std::array<double, block_size> {};

/// Tangential force (on j) and tangential stiffness of each pair at the last sweep, padded to whole blocks.
struct ContactMemory {
  std::vector<double> x, y, z, stiffness;

  void reset(std::size_t pairs);
};

/// Sums over the contacts of one sweep.
struct SweepSums {
  Mat3 stress;             ///< sum of force (x) branch [J]
  double normal_force = 0; ///< sum of f [N]
  double stiffness = 0;    ///< sum of k_n l^2 [J]
  double stiffest = 0;     ///< largest k_n [N/m]
  std::size_t contacts = 0;
  std::size_t sliding = 0;
};

struct SweepInput {
  const std::vector<Pair>& pairs; ///< padded
  const Grains& grains;
  Mat3 cell;
  Mat3 gradient;           ///< velocity gradient of the cell [1/s]
  double diameter;         ///< [m]
  double elapsed;          ///< time that the grains have moved since the last sweep [s]
  double tangential_ratio; ///< k_t/k_n
  double friction;         ///< finite
};

/// The list in whole blocks, as the sweep wants it: filled up with pairs that never touch.
[[nodiscard]] std::vector<Pair> padded(std::vector<Pair> pairs);

/// Forces of all pairs, gathered per grain in the order of the list. With memory a null pointer contacts are
/// frictionless: torques stay zero and nothing is remembered.
SweepSums contact_sweep(const contact::NormalKernel& law, const SweepInput& input, ContactMemory* memory,
                        std::vector<LoadRow>& load);

} // namespace granum::dem
