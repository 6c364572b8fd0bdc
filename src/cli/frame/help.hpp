// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "option_row.hpp"

/// Texts of options for help, manual pages and completion, all derived from the option rows.
/// Checked by tests/cli/test_screens.py
namespace granum::cli {

struct OptionText {
  std::string names;   ///< "--void-ratio", "-h, --help", "FILE"
  std::string value;   ///< "PRESSURE", "cone|sphere|flat|power-law"; empty for a flag
  std::string meaning; ///< with the default and required options
  const OptionRow* row = nullptr;
};

struct OptionGroup {
  std::string title;
  std::vector<OptionText> options;
};

/// Arguments of a command, then its options by group.
[[nodiscard]] std::vector<OptionGroup> option_groups(const Command& command);

struct CommandGroup {
  std::string title;
  std::vector<const Command*> commands;
};

/// The commands of the program, or within a command, by group; without hidden ones.
[[nodiscard]] std::vector<CommandGroup> command_groups(const Command& app);

/// "a, b, c" of words and ", ".
[[nodiscard]] std::string joined(const std::vector<std::string>& words, const char* separator);

/// "granum fit FILE [OPTIONS]".
[[nodiscard]] std::string usage_line(const Command& command);
/// The commands with their descriptions, by group; empty if there are none.
[[nodiscard]] std::string commands_text(const Command& command);
/// The whole help, in lines of 80 columns.
[[nodiscard]] std::string help_text(const Command& command);

/// A text for a terminal: lines longer than 80 characters continue in the next line, below their last column.
/// Longer words are not broken. Checked by tests/cli/test_screens.py
[[nodiscard]] std::string within_width(std::string_view text);

} // namespace granum::cli
