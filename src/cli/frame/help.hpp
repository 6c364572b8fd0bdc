// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

/// Options in the words of help, manual pages and completion, which are all made of the options themselves.
/// Checked by tests/cli/help.cmake
namespace granum::cli {

/// The group that every command's help ends with.
inline constexpr const char* output_group = "Output";

/// Puts options of a command under a title. Help shows groups in the order in which their first options were
/// added, and the group for output last.
/// \param    names   long ones, "--out"; the command has them all
void in_group(CLI::App& command, const std::string& title, std::initializer_list<const char*> names);

struct OptionText {
  std::string names;   ///< "--void-ratio", "-h, --help", "FILE"
  std::string value;   ///< "PRESSURE", "cone|sphere|flat|power-law"; empty for a flag
  std::string meaning; ///< with the default and what it needs
  const CLI::Option* option = nullptr;
};

struct OptionGroup {
  std::string title;
  std::vector<OptionText> options;
};

/// What a command takes: its arguments, then its options by group.
[[nodiscard]] std::vector<OptionGroup> option_groups(const CLI::App& command);

struct CommandGroup {
  std::string title;
  std::vector<const CLI::App*> commands;
};

/// The commands of the program, or within a command, by group; without those that are hidden.
[[nodiscard]] std::vector<CommandGroup> command_groups(const CLI::App& app);

/// "-h" and "--help"; none of a positional argument.
[[nodiscard]] std::vector<std::string> names_of(const CLI::Option& option);
/// "a, b, c" of words and ", ".
[[nodiscard]] std::string joined(const std::vector<std::string>& words, const char* separator);

/// "granum export lammps".
[[nodiscard]] std::string full_name(const CLI::App& command);
/// "granum fit FILE [OPTIONS]".
[[nodiscard]] std::string usage_line(const CLI::App& command);
/// The words that an option chooses from, if it does.
[[nodiscard]] std::vector<std::string> choices_of(const CLI::Option& option);

/// The commands with their descriptions, by group; nothing where there are none.
[[nodiscard]] std::string commands_text(const CLI::App& command);
/// All of it, in lines of 80 columns.
[[nodiscard]] std::string help_text(const CLI::App& command);

/// A text for a terminal: lines longer than 80 characters go on in the next one, below their last column.
/// Words that are longer stay whole. Checked by tests/cli/check_width.cmake
[[nodiscard]] std::string within_width(std::string_view text);

} // namespace granum::cli
