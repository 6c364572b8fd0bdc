// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/version.hpp>

#include "cli/frame/command_line.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/messages.hpp"
#include "cli/frame/suggest.hpp"

namespace granum::cli {

ExitCode fail(ExitCode code, std::string_view message) {
  say("error", message);
  return code;
}

std::vector<Command> add_commands(CLI::App& program) {
  program.require_subcommand(0, 1); // none at all is reported by parse_and_run, after unknown words
  const struct {
    const char* group;
    std::vector<Command> commands;
  } groups[] = {{"From closed forms",
                 {add_estimate(program), add_infer(program), add_sweep(program), add_fit(program)}},
                {"From the files of a DEM code", {add_analyse(program)}},
                {"By simulation",
                 {add_verify(program), add_plan(program), add_reproduce(program), add_trade(program),
                  add_export(program)}}};
  std::vector<Command> all;
  for (const auto& [group, commands] : groups)
    for (const Command& command : commands) {
      command.app->group(group);
      all.push_back(command);
    }
  all.push_back(add_reference(program)); // for the build: help does not list it
  all.back().app->group("");
  return all;
}

namespace {

/// "help fit" as "fit --help".
std::vector<std::string> with_help_last(std::vector<std::string> words) {
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.resize(std::min<std::size_t>(words.size(), 1));
    words.emplace_back("--help");
  }
  return words;
}

ExitCode fail_with(const std::vector<std::string>& faults) {
  for (const std::string& fault : faults)
    (void)fail(ExitCode::usage, fault);
  return ExitCode::usage;
}

/// The command that the first words name, "export lammps" for instance; words from `first` on are its own.
struct NamedCommand {
  const CLI::App* app;
  std::size_t first = 0;
};

NamedCommand named_command(const CLI::App& program, const std::vector<std::string>& words) {
  NamedCommand named{.app = &program};
  while (named.first < words.size()) {
    const auto fits = [&](const CLI::App* app) { return app->get_name() == words[named.first]; };
    const std::vector<const CLI::App*> found = named.app->get_subcommands(fits);
    if (found.empty())
      break;
    named = {.app = found.front(), .first = named.first + 1};
  }
  return named;
}

bool asks_for_help(const CLI::App& command, const std::vector<TypedArgument>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [&](const TypedArgument& typed) {
    return typed.option != nullptr &&
           (typed.option == command.get_help_ptr() || typed.option == command.get_version_ptr());
  });
}

/// Looks at what was typed before the parser does: joins units to their numbers, and finds what nobody knows.
/// \return   what is wrong, in the order typed
std::vector<std::string> prepare(const CLI::App& program, std::vector<std::string>& words) {
  const auto [command, first] = named_command(program, words);
  const auto own = words.begin() + static_cast<std::ptrdiff_t>(first);
  const std::vector<TypedArgument> arguments = read_arguments(*command, {own, words.end()});
  if (asks_for_help(*command, arguments))
    return {};
  const bool names_commands = !command->get_subcommands([](const CLI::App*) { return true; }).empty();
  if (names_commands)
    return arguments.empty() ? std::vector<std::string>()
                             : std::vector<std::string>{unknown_command(*command, {own, words.end()})};
  words.resize(first);
  for (std::string& word : words_of(arguments))
    words.push_back(std::move(word));
  return faults_of(program, *command, arguments);
}

} // namespace

ExitCode parse_and_run(int argc, char** argv) {
  CLI::App program(
      "How stiff is this packing of grains, how does that depend on stress, and how far can you trust "
      "the number?",
      "granum");
  program.set_version_flag("--version", fmt::format("granum {} ({})", version(), compiler()));
  program.footer("Begin with\n"
                 "  granum estimate --void-ratio 0.6 --pressure 100kPa\n"
                 "and granum COMMAND --help. Quantities carry their unit: 100kPa, 0.5mm, 30GPa,\n"
                 "26.5deg.\n"
                 "\n"
                 "Exit codes: 0 ok, 1 some rows failed or a check fell short, 2 usage, 3 file,\n"
                 "4 not converged, or outside validity under --strict, 129, 130 or 143\n"
                 "stopped by SIGHUP, Ctrl-C or SIGTERM.");
  program.formatter_fn(
      [](const CLI::App* app, const std::string&, CLI::AppFormatMode) { return help_text(*app); });
  const std::vector<Command> commands = add_commands(program);
  std::string called = full_name(program);
  try {
    std::vector<std::string> words = with_help_last({argv + std::min(argc, 1), argv + argc});
    if (const std::vector<std::string> faults = prepare(program, words); !faults.empty())
      return fail_with(faults);
    called = full_name(*named_command(program, words).app);
    std::reverse(words.begin(), words.end()); // as the parser takes them
    program.parse(std::move(words));
  } catch (const CLI::Success& request) { // --help, --version
    std::ostringstream text;
    program.exit(request, text, text);
    print(text.str());
    return ExitCode::ok;
  } catch (const CLI::ParseError& error) {
    return fail(ExitCode::usage, std::string(error.what()) + "; see " + called + " --help");
  }
  for (const Command& command : commands)
    if (command.app->parsed())
      return command.run();
  (void)fail(ExitCode::usage, "a subcommand is required; see granum --help");
  to_standard_error(commands_text(program));
  return ExitCode::usage;
}

} // namespace granum::cli
