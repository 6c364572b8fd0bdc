// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/estimate/input_values.hpp>

#include "cli/frame/option_row.hpp"

/// The densest packing of beads, made for the question: their z* is estimated from the void ratio above it.
namespace granum::cli {

/// --densest made.
[[nodiscard]] OptionRow densest_row(std::string& densest);

/// Gives least_void_ratio: the mean void ratio of eight packings of 1000 of these grains or more, compressed
/// without friction to the pressure of preparation, or to 10 kPa. Takes seconds.
/// \throws   InvalidArgument unless the grains are spheres; as the recipe of a specimen
/// Accuracy  void ratios of the packings differ by 0.003. Checked by tests/cli/rows/answer.txt
void make_densest(estimate::InputValues& completed);

} // namespace granum::cli
