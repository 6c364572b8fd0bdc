// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/estimate/input_values.hpp>
#include <nlohmann/json.hpp>

/// What a packing is, as every command writes it.
namespace granum::cli {

/// Contact, grains and packing in SI, without the stress; contacts if known; of unequal grains their
/// distribution, its gradation and its contact means.
[[nodiscard]] nlohmann::ordered_json packing_json(const estimate::InputValues& values,
                                                  const effective::State& state);
[[nodiscard]] nlohmann::ordered_json json_of(const sizes::Gradation& gradation);
[[nodiscard]] nlohmann::ordered_json json_of(const sizes::ContactMeans& means);
/// "<l> = 1.0432 2R, ...": for the screen.
[[nodiscard]] std::string means_text(const sizes::ContactMeans& means);
/// "d10 0.3 mm, d50 0.5 mm, d60 0.6 mm".
[[nodiscard]] std::string gradation_text(const sizes::Gradation& gradation);

} // namespace granum::cli
