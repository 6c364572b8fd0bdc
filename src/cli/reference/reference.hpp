// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/frame/option_row.hpp"

/// Manual pages and completion, derived from the option rows. Checked by tests/cli/test_screens.py
namespace granum::cli {

/// The manual page of the program or of a command, for section 1, in the macros of man(7).
[[nodiscard]] std::string man_page(const Command& command, const std::string& version);

/// Completion for bash: commands, options, and the values of options with choices or files.
[[nodiscard]] std::string bash_completion(const Command& program);

/// The same for zsh, with meanings.
[[nodiscard]] std::string zsh_completion(const Command& program);

} // namespace granum::cli
