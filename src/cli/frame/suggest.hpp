// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "option_row.hpp"

/// Suggestions for unknown words. Checked by tests/cli/rows/people.txt
namespace granum::cli {

/// The message for an unknown option of a command.
/// \param    program  with all commands, to find the command of the option
[[nodiscard]] std::string unknown_option(const Command& program, const Command& command,
                                         const std::string& typed);

/// The message for a word without an option.
[[nodiscard]] std::string stray_word(const Command& program, const Command& command, const std::string& word);

/// The message for a first word that is not a subcommand.
[[nodiscard]] std::string unknown_command(const Command& program, const std::vector<std::string>& words);

} // namespace granum::cli
