// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <algorithm>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/version.hpp>

#include "cli/frame/command_line.hpp"
#include "cli/frame/messages.hpp"

namespace granum::cli {

ExitCode fail(ExitCode code, std::string_view message) {
  say("error", message);
  return code;
}

std::vector<Command> add_commands(CLI::App& program) {
  program.require_subcommand(0, 1); // none at all is reported by parse_and_run, after unknown words
  return {add_analyse(program), add_estimate(program), add_export(program),    add_fit(program),
          add_infer(program),   add_plan(program),     add_reproduce(program), add_sweep(program),
          add_trade(program),   add_verify(program)};
}

namespace {

/// The words behind the name of the program, units joined to their numbers.
std::vector<std::string> words_for_parser(const CLI::App& program, int argc, char** argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty())
    return words;
  const auto commands =
      program.get_subcommands([&](const CLI::App* app) { return app->get_name() == words[0]; });
  if (commands.empty())
    return words;
  std::vector<std::string> joined{words[0]};
  for (std::string& word : words_of(read_arguments(*commands[0], {words.begin() + 1, words.end()})))
    joined.push_back(std::move(word));
  return joined;
}

} // namespace

ExitCode parse_and_run(int argc, char** argv) {
  CLI::App program(
      "How stiff is this packing of grains, how does that depend on stress, and how far can you trust "
      "the number?",
      "granum");
  program.set_version_flag("--version", fmt::format("granum {} ({})", version(), compiler()));
  program.footer(
      "Exit codes: 0 ok, 1 some rows failed or a check fell short, 2 usage, 3 file, 4 not converged, or\n"
      "outside validity under --strict, 130 or 143 stopped by Ctrl-C or SIGTERM. Quantities carry their "
      "unit:\n"
      "100kPa, 0.5mm, 30GPa, 26.5deg.");
  const std::vector<Command> commands = add_commands(program);
  try {
    std::vector<std::string> words = words_for_parser(program, argc, argv);
    std::reverse(words.begin(), words.end()); // as the parser takes them
    program.parse(std::move(words));
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

} // namespace granum::cli
