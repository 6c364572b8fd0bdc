// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>
#include <sstream>

#include <CLI/CLI.hpp>

#include "cli/frame/help.hpp"
#include "reference.hpp"

namespace granum::cli {

namespace {

/// Text as troff takes it: hyphens that may be copied, backslashes and leading points that mean themselves.
std::string escaped(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\''))
    out = "\\&";
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '~')
      out += "\\(ti";
    else if (c == '^')
      out += "\\(ha";
    else
      out += c;
  }
  return out;
}

std::string with_hyphens(std::string name) {
  for (char& c : name)
    c = c == ' ' ? '-' : c;
  return name;
}

std::string in_capitals(std::string text) {
  for (char& c : text)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

void append_options(std::string& page, const CLI::App& command) {
  page += ".SH OPTIONS\n";
  for (const OptionGroup& group : option_groups(command)) {
    page += ".SS " + escaped(group.title) + "\n";
    for (const OptionText& option : group.options) {
      page += ".TP\n\\fB" + escaped(option.names) + "\\fR";
      page += option.value.empty() ? "\n" : " \\fI" + escaped(option.value) + "\\fR\n";
      page += escaped(option.meaning) + "\n";
    }
  }
}

void append_commands(std::string& page, const CLI::App& command) {
  const std::vector<CommandGroup> groups = command_groups(command);
  if (groups.empty())
    return;
  page += ".SH COMMANDS\n";
  for (const CommandGroup& group : groups) {
    page += ".SS " + escaped(group.title) + "\n";
    for (const CLI::App* inner : group.commands)
      page += ".TP\n\\fB" + escaped(inner->get_name()) + "\\fR\n" + escaped(inner->get_description()) + "\n";
  }
}

/// The lines below the options as they stand in help.
void append_notes(std::string& page, const CLI::App& command) {
  const std::string footer = command.get_footer();
  if (footer.empty())
    return;
  page += ".SH NOTES\n.nf\n";
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);)
    page += line.empty() ? ".sp\n" : escaped(line) + "\n";
  page += ".fi\n";
}

void append_related(std::string& page, const CLI::App& command) {
  std::string others;
  if (command.get_parent() != nullptr)
    others = ".BR " + escaped(with_hyphens(full_name(*command.get_parent()))) + " (1)";
  for (const CommandGroup& group : command_groups(command))
    for (const CLI::App* inner : group.commands)
      others += (others.empty() ? "" : ",\n") + (".BR " + escaped(with_hyphens(full_name(*inner)))) + " (1)";
  if (!others.empty())
    page += ".SH SEE ALSO\n" + others + "\n";
}

} // namespace

std::string man_page(const CLI::App& command, const std::string& version) {
  const std::string name = with_hyphens(full_name(command));
  std::string page =
      ".TH " + escaped(in_capitals(name)) + " 1 \"\" \"granum " + version + "\" \"User Commands\"\n";
  page += ".SH NAME\n" + escaped(name) + " \\- " + escaped(command.get_description()) + "\n";
  const std::string usage = usage_line(command);
  const std::string called = full_name(command);
  page += ".SH SYNOPSIS\n\\fB" + escaped(called) + "\\fR" + escaped(usage.substr(called.size())) + "\n";
  append_commands(page, command);
  append_options(page, command);
  append_notes(page, command);
  append_related(page, command);
  return page;
}

} // namespace granum::cli
