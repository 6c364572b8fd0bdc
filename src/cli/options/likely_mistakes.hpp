// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/error.hpp>
#include <granum/estimate/input_values.hpp>

#include "cli/frame/option_row.hpp"
#include "studies/scene/scene.hpp"

/// Warnings for inputs that are possible, but more likely a mistake in unit or symbol.
/// Checked by tests/cli/rows/people.txt
namespace granum::cli {

/// Checks given values only, in the order of the options: void ratio, z*, stress, size, modulus and density
/// of the grains.
/// \throws   InvalidArgument as effective::contact_prior
[[nodiscard]] Validity likely_mistakes(const estimate::InputValues& values, const effective::State& state);

/// The same for a stress.
[[nodiscard]] Validity likely_mistakes(const Number& stress);

/// The same for the grains and pressures of a scene, with the names of its keys.
[[nodiscard]] Validity likely_mistakes(const studies::Scene& scene);

} // namespace granum::cli
