// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference.hpp"

#include <filesystem>
#include <memory>
#include <string>

#include <granum/core/version.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"

namespace granum::cli {

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  prepare_folder(file.parent_path(), {}, true);
  io::write_file(file, text, io::Existing::replace);
}

/// Writes the page of a command and of its subcommands.
void write_pages(const Command& command, const fs::path& folder) {
  std::string name = command.called;
  for (char& c : name)
    c = c == ' ' ? '-' : c;
  write(folder / (name + ".1"), man_page(command, std::string(version())));
  for (const CommandGroup& group : command_groups(command))
    for (const Command* inner : group.commands)
      write_pages(*inner, folder);
}

ExitCode run(const Command& program, const fs::path& folder) {
  write_pages(program, folder / "man1");
  write(folder / "bash" / "granum", bash_completion(program));
  write(folder / "zsh" / "_granum", zsh_completion(program));
  return ExitCode::ok;
}

} // namespace

Command make_reference(const Command& program) {
  auto folder = std::make_shared<std::string>();
  Command command{.name = "reference", .meaning = "Manual pages and completion for shells, for the build"};
  command.add(
      output_group,
      {{.name = "--out", .value = path(*folder, "DIR"), .meaning = "Folder for them", .required = true}});
  command.run = [&program, folder] { return run(program, *folder); };
  return command;
}

} // namespace granum::cli
