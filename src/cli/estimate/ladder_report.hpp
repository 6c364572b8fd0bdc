// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/effective/ladder.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/packing_options.hpp"

/// `granum estimate --tolerance`: the cheapest rung that is good enough, in words.
namespace granum::cli {

/// The ladder for a packing that the options describe. Where they leave C_n out, the tolerance is not met:
/// nobody knows the error of an assumed C_n.
/// \throws   InvalidArgument as effective::estimate
[[nodiscard]] effective::LadderEstimate choose_rung(const PackingOptions& options,
                                                    const effective::State& state, double tolerance);

[[nodiscard]] nlohmann::ordered_json ladder_json(const effective::LadderEstimate& ladder);
[[nodiscard]] std::string ladder_table(const effective::LadderEstimate& ladder);

} // namespace granum::cli
