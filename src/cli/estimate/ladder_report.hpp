// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/estimate/ladder.hpp>
#include <nlohmann/json.hpp>

/// `granum estimate --tolerance`: the cheapest rung within the tolerance, as text.
namespace granum::cli {

[[nodiscard]] nlohmann::ordered_json ladder_json(const estimate::Ladder& ladder);
[[nodiscard]] std::string ladder_table(const estimate::Ladder& ladder);

} // namespace granum::cli
