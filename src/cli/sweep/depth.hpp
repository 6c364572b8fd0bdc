// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/plot/chart.hpp>
#include <granum/stress/ground.hpp>
#include <nlohmann/json.hpp>

#include "cli/estimate/answer_report.hpp"
#include "sweep.hpp"

/// What granum sweep --depth works out, and how it is put into words.
namespace granum::cli {

/// The ground that the options describe.
struct GroundCase {
  stress::Ground ground;
  double saturation = 0;      ///< of the pores above the water table
  std::vector<double> depths; ///< [m]
  std::vector<std::string> assumptions;
  Validity validity; ///< where weights and void ratio contradict each other
};

void add_ground_options(CLI::App& command, GroundOptions& options);

/// \throws   InvalidArgument for options that contradict one another or are out of range
[[nodiscard]] GroundCase resolve_ground(const SweepOptions& options);

/// The answer at one depth.
struct DepthAnswer {
  double depth = 0; ///< [m]
  stress::GroundStress stress;
  AnswerCase answer;
};

struct DepthSweep {
  GroundCase ground;
  nlohmann::ordered_json packing; ///< contact, grains and packing, SI
  std::vector<DepthAnswer> answers;
  std::vector<std::string> remarks; ///< what is assumed
};

[[nodiscard]] std::string depth_table(const DepthSweep& sweep);
[[nodiscard]] std::string depth_csv(const DepthSweep& sweep, bool all_columns);
[[nodiscard]] nlohmann::ordered_json depth_json(const DepthSweep& sweep);
/// Stresses, G, V_s and V_p side by side, depth downwards.
[[nodiscard]] std::vector<plot::Chart> depth_charts(const DepthSweep& sweep);

} // namespace granum::cli
