// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/version.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/messages.hpp"
#include "cli/frame/stop_signal.hpp"

namespace {

using namespace granum;
using namespace granum::cli;

ExitCode fail(ExitCode code, std::string_view message) {
  say("error", message);
  return code;
}

ExitCode parse_and_run(int argc, char** argv) {
  CLI::App program(
      "How stiff is this packing of grains, how does that depend on stress, and how far can you trust "
      "the number?",
      "granum");
  program.set_version_flag("--version", fmt::format("granum {} ({})", version(), compiler()));
  program.require_subcommand(0, 1); // none at all is reported below, after unknown words
  program.footer(
      "Exit codes: 0 ok, 1 some rows failed or a check fell short, 2 usage, 3 file, 4 not converged, or\n"
      "outside validity under --strict, 130 or 143 stopped by Ctrl-C or SIGTERM. Quantities carry their "
      "unit:\n"
      "100kPa, 0.5mm, 30GPa, 26.5deg.");
  const std::vector<Command> commands{add_analyse(program), add_estimate(program), add_export(program),
                                      add_fit(program),     add_plan(program),     add_reproduce(program),
                                      add_sweep(program),   add_trade(program),    add_verify(program)};
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& request) { // --help, --version
    program.exit(request);
    return std::cout.flush() ? ExitCode::ok : fail(ExitCode::file, "standard output: cannot be written");
  } catch (const CLI::ParseError& error) {
    return fail(ExitCode::usage, std::string(error.what()) + "; see granum --help");
  }
  for (const Command& command : commands)
    if (command.app->parsed())
      return command.run();
  return fail(ExitCode::usage, "a subcommand is required; see granum --help");
}

/// What the command line asked for, for messages.
std::string asked_for(int argc, char** argv) {
  std::string words = "granum";
  for (int k = 1; k < argc; ++k)
    words += std::string(" ") + argv[k];
  return words;
}

} // namespace

/// The one place where errors become messages and exit codes.
int main(int argc, char** argv) {
  ExitCode code = ExitCode::ok;
  open_missing_streams();
  try {
    code = parse_and_run(argc, argv);
  } catch (const InvalidArgument& error) {
    code = fail(ExitCode::usage, error.what());
  } catch (const FileError& error) {
    code = fail(ExitCode::file, error.what());
  } catch (const std::filesystem::filesystem_error& error) { // such as a name that is too long
    code = fail(ExitCode::file, error.what());
  } catch (const NotConverged& error) {
    code = fail(ExitCode::not_converged, error.what());
  } catch (const Stopped& error) {
    code = fail(exit_code_of_stop(), error.what());
  } catch (const std::bad_alloc&) {
    code = fail(ExitCode::fell_short, "out of memory: there is not enough for " + asked_for(argc, argv) +
                                          "; fewer grains, states or frames need less");
  } catch (const std::exception& error) {
    code = fail(ExitCode::fell_short, error.what());
  }
  return static_cast<int>(code);
}
