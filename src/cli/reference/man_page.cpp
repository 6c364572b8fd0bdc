// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>
#include <sstream>

#include "cli/frame/help.hpp"
#include "reference.hpp"

namespace granum::cli {

namespace {

/// Escapes a text for troff: hyphens that can be copied, literal backslashes and leading points.
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

void append_options(std::string& page, const Command& command) {
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

void append_commands(std::string& page, const Command& command) {
  const std::vector<CommandGroup> groups = command_groups(command);
  if (groups.empty())
    return;
  page += ".SH COMMANDS\n";
  for (const CommandGroup& group : groups) {
    page += ".SS " + escaped(group.title) + "\n";
    for (const Command* inner : group.commands)
      page += ".TP\n\\fB" + escaped(inner->name) + "\\fR\n" + escaped(inner->meaning) + "\n";
  }
}

/// The lines below the options, as in help.
void append_notes(std::string& page, const Command& command) {
  const std::string notes = command.notes;
  if (notes.empty())
    return;
  page += ".SH NOTES\n.nf\n";
  std::istringstream lines(notes);
  for (std::string line; std::getline(lines, line);)
    page += line.empty() ? ".sp\n" : escaped(line) + "\n";
  page += ".fi\n";
}

void append_related(std::string& page, const Command& command) {
  std::string others;
  if (const std::size_t blank = command.called.rfind(' '); blank != std::string::npos)
    others = ".BR " + escaped(with_hyphens(command.called.substr(0, blank))) + " (1)";
  for (const CommandGroup& group : command_groups(command))
    for (const Command* inner : group.commands)
      others += (others.empty() ? "" : ",\n") + (".BR " + escaped(with_hyphens(inner->called))) + " (1)";
  if (!others.empty())
    page += ".SH SEE ALSO\n" + others + "\n";
}

} // namespace

std::string man_page(const Command& command, const std::string& version) {
  const std::string name = with_hyphens(command.called);
  std::string page =
      ".TH " + escaped(in_capitals(name)) + " 1 \"\" \"granum " + version + "\" \"User Commands\"\n";
  page += ".SH NAME\n" + escaped(name) + " \\- " + escaped(command.meaning) + "\n";
  const std::string usage = usage_line(command);
  const std::string called = command.called;
  page += ".SH SYNOPSIS\n\\fB" + escaped(called) + "\\fR" + escaped(usage.substr(called.size())) + "\n";
  append_commands(page, command);
  append_options(page, command);
  append_notes(page, command);
  append_related(page, command);
  return page;
}

} // namespace granum::cli
