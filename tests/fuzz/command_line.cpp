// SPDX-License-Identifier: GPL-3.0-or-later
// Command lines, one argument a line: every one is taken or refused with a message. No command runs.
#include <algorithm>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/commands.hpp"
#include "cli/frame/suggest.hpp"
#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> arguments;
  for (std::string_view rest = fuzz::text(data, size); !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    arguments.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  std::vector<const char*> argv{"granum"};
  for (const std::string& argument : arguments) // as the system passes them: up to the first zero byte
    argv.push_back(argument.c_str());
  CLI::App program("", "granum");
  const std::vector<cli::Command> commands = cli::add_commands(program);
  for (const cli::Command& command : commands) // what is asked back, whatever the command
    for (const std::string& fault :
         cli::faults_of(program, *command.app, cli::read_arguments(*command.app, arguments)))
      fuzz::demand(!fault.empty());
  if (!arguments.empty())
    fuzz::demand(!cli::unknown_command(program, arguments).empty());
  try {
    program.parse(static_cast<int>(argv.size()), argv.data());
  } catch (const CLI::ParseError& error) {
    fuzz::demand(!std::string(error.what()).empty());
  } catch (const InvalidArgument& error) {
    fuzz::demand(!std::string(error.what()).empty());
  }
  return 0;
}
