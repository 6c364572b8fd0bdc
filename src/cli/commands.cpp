// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <algorithm>
#include <string>

#include <fmt/core.h>
#include <granum/core/error.hpp>
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

namespace {

/// Sets the full name of a command, and adds --help as its last option.
void finish(Command& command, const std::string& above) {
  command.called = above.empty() ? command.name : above + " " + command.name;
  for (Command& inner : command.within)
    finish(inner, command.called);
  command.add(command.within.empty() ? output_group : "Options",
              {{.name = "-h,--help",
                .value = {.take = [](const std::string&, const std::string&) {}},
                .meaning = "Print this help message and exit"}});
}

} // namespace

std::unique_ptr<Command> make_program() {
  auto program = std::make_unique<Command>(Command{
      .name = "granum",
      .meaning = "How stiff is this packing of grains, how does that depend on stress, and how far can "
                 "you trust the number?",
      .notes = "Begin with\n"
               "  granum estimate --void-ratio 0.6 --pressure 100kPa\n"
               "and granum COMMAND --help. Quantities carry their unit: 100kPa, 0.5mm, 30GPa,\n"
               "26.5deg.\n"
               "\n"
               "Exit codes: 0 ok, 1 some rows or checks failed, 2 usage, 3 file,\n"
               "4 not converged, or a warning under --strict, 129, 130 or 143 stopped by\n"
               "SIGHUP, Ctrl-C or SIGTERM."});
  program->add("Options", {{.name = "--version",
                            .value = {.take = [](const std::string&, const std::string&) {}},
                            .meaning = "Display program version information and exit"}});
  const auto add = [&](const char* group, Command command) {
    command.group = group;
    program->within.push_back(std::move(command));
  };
  add("From closed forms", make_estimate());
  add("From closed forms", make_infer());
  add("From closed forms", make_sweep());
  add("From closed forms", make_fit());
  add("From the files of a DEM code", make_analyse());
  add("By simulation", make_verify());
  add("By simulation", make_plan());
  add("By simulation", make_reproduce());
  add("By simulation", make_trade());
  add("By simulation", make_export());
  add("", make_reference(*program)); // for the build; not listed in help
  finish(*program, "");
  return program;
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

/// The command named by the first words, for instance "export lammps"; words from `first` on are its
/// arguments.
struct NamedCommand {
  const Command* command;
  std::size_t first = 0;
};

NamedCommand named_command(const Command& program, const std::vector<std::string>& words) {
  NamedCommand named{.command = &program};
  for (bool found = true; found && named.first < words.size();) {
    found = false;
    for (const Command& inner : named.command->within)
      if (!found && inner.name == words[named.first]) {
        named = {.command = &inner, .first = named.first + 1};
        found = true;
      }
  }
  return named;
}

bool asks_for(const std::vector<TypedArgument>& arguments, const char* option) {
  return std::any_of(arguments.begin(), arguments.end(), [&](const TypedArgument& typed) {
    return typed.option != nullptr && is_named(*typed.option, option);
  });
}

} // namespace

ExitCode parse_and_run(int argc, char** argv) {
  const std::unique_ptr<Command> program = make_program();
  const std::vector<std::string> words = with_help_last({argv + std::min(argc, 1), argv + argc});
  const auto [command, first] = named_command(*program, words);
  const std::vector<std::string> own(words.begin() + static_cast<std::ptrdiff_t>(first), words.end());
  const std::vector<TypedArgument> arguments = read_arguments(*command, own);
  if (asks_for(arguments, "--help") || asks_for(arguments, "--version")) {
    print(asks_for(arguments, "--help") ? help_text(*command)
                                        : fmt::format("granum {} ({})\n", version(), compiler()));
    return ExitCode::ok;
  }
  if (!command->within.empty()) {
    if (!own.empty())
      return fail(ExitCode::usage, unknown_command(*command, own));
    (void)fail(ExitCode::usage, "a subcommand is required; see " + command->called + " --help");
    to_standard_error(commands_text(*command));
    return ExitCode::usage;
  }
  if (const std::vector<std::string> faults = take_arguments(*program, *command, arguments); !faults.empty())
    return fail_with(faults);
  remember_asked(arguments);
  try {
    return command->run();
  } catch (const InvalidArgument& error) {
    throw as_typed(error, arguments);
  }
}

} // namespace granum::cli
