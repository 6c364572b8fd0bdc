// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include "cli/frame/frame.hpp"

/// The program without main().
namespace granum::cli {

/// The program with all commands. Commands keep references to it.
[[nodiscard]] std::unique_ptr<Command> make_program();

/// Executes a command line.
/// \throws   granum's errors, which main() converts to a message and an exit code
[[nodiscard]] ExitCode parse_and_run(int argc, char** argv);

/// Writes the error message and returns the code.
ExitCode fail(ExitCode code, std::string_view message);

} // namespace granum::cli
