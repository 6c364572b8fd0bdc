// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "option_row.hpp"

/// Suggestions for unknown words. Checked by tests/cli/people.cmake
namespace granum::cli {

/// The sentence for an option that a command does not know.
/// \param    program  with all commands, of which another may know the option
[[nodiscard]] std::string unknown_option(const Command& program, const Command& command,
                                         const std::string& typed);

/// The sentence for a word that belongs to no option.
[[nodiscard]] std::string stray_word(const Command& program, const Command& command, const std::string& word);

/// The sentence for a first word that is no command within this one.
[[nodiscard]] std::string unknown_command(const Command& program, const std::vector<std::string>& words);

} // namespace granum::cli
