// SPDX-License-Identifier: GPL-3.0-or-later
// Command lines, one argument a line: every one is taken or refused with a message. No command runs.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <granum/core/error.hpp>

#include "cli/commands.hpp"
#include "cli/frame/command_line.hpp"
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
  for (std::string& argument : arguments) // as the system passes them: up to the first zero byte
    argument.resize(std::min(argument.find('\0'), argument.size()));
  const std::unique_ptr<cli::Command> program = cli::make_program();
  for (const cli::Command& command : program->within) // what is asked back, whatever the command
    try {
      for (const std::string& fault :
           cli::take_arguments(*program, command, cli::read_arguments(command, arguments)))
        fuzz::demand(!fault.empty());
    } catch (const FileError& error) {
      fuzz::demand(!std::string(error.what()).empty());
    }
  if (!arguments.empty())
    fuzz::demand(!cli::unknown_command(*program, arguments).empty());
  return 0;
}
