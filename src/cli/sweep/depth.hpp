// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/stress/ground.hpp>

#include "sweep.hpp"

/// The ground of granum sweep --depth.
namespace granum::cli {

/// The ground that the options describe.
struct GroundCase {
  stress::Ground ground;
  double saturation = 0;      ///< of the pores above the water table
  std::vector<double> depths; ///< [m]
  std::vector<std::string> assumptions;
  Validity validity; ///< where weights and void ratio contradict each other
};

void add_ground_options(Command& command, GroundOptions& options);

/// \throws   InvalidArgument for options that contradict one another or are out of range
[[nodiscard]] GroundCase resolve_ground(const SweepOptions& options);

} // namespace granum::cli
