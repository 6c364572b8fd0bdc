// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference.hpp"

#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
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

/// The page of a command, and of those within it.
void write_pages(const CLI::App& command, const fs::path& folder) {
  std::string name = full_name(command);
  for (char& c : name)
    c = c == ' ' ? '-' : c;
  write(folder / (name + ".1"), man_page(command, std::string(version())));
  for (const CommandGroup& group : command_groups(command))
    for (const CLI::App* inner : group.commands)
      write_pages(*inner, folder);
}

ExitCode run(const CLI::App& program, const fs::path& folder) {
  write_pages(program, folder / "man1");
  write(folder / "bash" / "granum", bash_completion(program));
  write(folder / "zsh" / "_granum", zsh_completion(program));
  return ExitCode::ok;
}

} // namespace

Command add_reference(CLI::App& program) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("reference", "Manual pages and completion for shells, for the build");
  add_path(*command, "--out", *folder, "Folder for them")->required();
  return {command, [&program, folder] { return run(program, *folder); }};
}

} // namespace granum::cli
