// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command_line.hpp"

/// What was meant by words that the program does not know, and what is wrong with values, in the order in
/// which they were typed. Checked by tests/cli/people.cmake
namespace granum::cli {

/// One sentence for each option that the command does not know, each word that belongs to no option where the
/// command takes none, each option without its value, each number or choice that cannot be taken, and each
/// option that contradicts one before it or lacks one that it needs.
/// \param    program  with all commands, of which another may know the option
[[nodiscard]] std::vector<std::string> faults_of(const CLI::App& program, const CLI::App& command,
                                                 const std::vector<TypedArgument>& arguments);

/// The sentence for a first word that is no command.
[[nodiscard]] std::string unknown_command(const CLI::App& program, const std::vector<std::string>& words);

} // namespace granum::cli
