// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <granum/estimate/input_values.hpp>

#include "cli/frame/option_row.hpp"

/// The options of the inputs of a question, from their rows.
namespace granum::cli {

using estimate::contacts_group;
using estimate::grains_group;
using estimate::Input;
using estimate::InputValues;
using estimate::law_group;
using estimate::sizes_group;
using estimate::state_group;

/// The option of an input; help shows a default. `values` must stay in its place.
[[nodiscard]] OptionRow input_option(InputValues& values, Input input);
void add_input(Command& command, InputValues& values, Input input);

/// The options for a packing and its stress.
void add_packing_options(Command& command, InputValues& values);
/// The options for the contact law: shape and material of the grains.
/// \param    name   of the option for the shape
void add_law_options(Command& command, InputValues& values, const std::string& name = "--contact");
/// The options besides the packing: preparation, grains and pores, the sand.
void add_answer_options(Command& command, InputValues& values);
/// --uncertainty, key=sd.
[[nodiscard]] OptionRow uncertainty_row(std::vector<std::string>& settings);

} // namespace granum::cli
