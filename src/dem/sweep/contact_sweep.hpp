// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/core/vec3.hpp>

#include "grain_rows.hpp"
#include "partition.hpp"

namespace granum::dem {

struct alignas(64) Block : std::array<double, block_size> {};

/// Tangential force (on j) and tangential stiffness of each pair of a block at the last sweep.
struct MemoryBlock {
  Block x, y, z, stiffness;
};

/// Sums over the contacts of one sweep.
struct SweepSums {
  Mat3 stress;             ///< sum of force (x) branch [J]
  double normal_force = 0; ///< sum of f [N]
  double stiffness = 0;    ///< sum of k_n l^2 [J]
  double stiffest = 0;     ///< largest k_n [N/m]
  std::size_t contacts = 0;
  std::size_t sliding = 0;

  SweepSums& operator+=(const SweepSums& other);
};

/// The same of a minimiser.
struct DescentSums {
  double virial = 0;       ///< sum of f l: the trace of stress [J]
  double normal_force = 0; ///< [N]
  double stiffest = 0;     ///< [N/m]
  std::size_t contacts = 0;

  DescentSums& operator+=(const DescentSums& other);
};

struct SweepInput {
  const std::vector<ListedPair>& pairs;
  const Grains& grains;
  Mat3 cell;
  Mat3 gradient;           ///< velocity gradient of the cell [1/s]
  double diameter;         ///< of the largest grain [m]
  double unit_radius;      ///< of a grain of size 1 [m]
  double elapsed;          ///< time that the grains have moved since the last sweep [s]
  double tangential_ratio; ///< k_t/k_n
  double friction;         ///< finite
};

/// The same of a minimiser.
struct DescentInput {
  const std::vector<ListedPair>& pairs;
  const TranslatingGrains& grains;
  Mat3 cell;
  double diameter;
  double unit_radius;
};

/// Sums the forces of all pairs of a chunk per row of load, in the order of the list, from zero. If memory
/// (of all blocks) is null, contacts are frictionless: torques are zero and no history is kept.
SweepSums contact_sweep(const contact::NormalKernel& law, const SweepInput& input, const Chunk& chunk,
                        MemoryBlock* memory, std::vector<LoadRow>& load);

/// The same without friction, for grains that do not turn; adds to load, whose rows are to be empty.
DescentSums descent_sweep(const contact::NormalKernel& law, const DescentInput& input, const Chunk& chunk,
                          std::vector<PushRow>& load);

} // namespace granum::dem
