// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include "cli/frame/frame.hpp"

/// The program but for main().
namespace granum::cli {

/// The program with every command, of which it takes one. Commands keep references to it.
[[nodiscard]] std::unique_ptr<Command> make_program();

/// Does what the command line asks for.
/// \throws   granum's errors, which main() turns into a message and an exit code
[[nodiscard]] ExitCode parse_and_run(int argc, char** argv);

/// Writes the error message and gives the code back.
ExitCode fail(ExitCode code, std::string_view message);

} // namespace granum::cli
