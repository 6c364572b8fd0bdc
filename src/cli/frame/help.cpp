// SPDX-License-Identifier: GPL-3.0-or-later
#include "help.hpp"

#include <algorithm>
#include <sstream>

namespace granum::cli {

namespace {

constexpr std::size_t line_width = 80;
constexpr std::size_t meaning_column = 30;

std::size_t width(std::string_view text) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
}

/// Appends words to a text whose last line is `column` wide; continuation lines are indented by `indent`.
void append_wrapped(std::string& text, std::size_t column, std::string_view words, std::size_t indent) {
  std::istringstream stream{std::string(words)};
  bool first = true;
  for (std::string word; stream >> word; first = false) {
    const std::size_t needed = width(word) + (first ? 0 : 1);
    if (!first && column + needed > line_width) {
      text += "\n" + std::string(indent, ' ') + word;
      column = indent + width(word);
      continue;
    }
    text += (first ? "" : " ") + word;
    column += needed;
  }
  text += '\n';
}

/// A line of two columns: name and meaning.
void append_entry(std::string& text, const std::string& name, const std::string& meaning) {
  const std::string left = "  " + name;
  text += left;
  if (width(left) + 2 > meaning_column)
    text += '\n' + std::string(meaning_column, ' ');
  else
    text += std::string(meaning_column - width(left), ' ');
  append_wrapped(text, meaning_column, meaning, meaning_column);
}

/// Breaks a line to fit: a line with columns continues below its last column with enough room, others below
/// their first word.
void append_line(std::string& text, std::string_view line) {
  constexpr std::size_t room = 24;
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.rfind("  ", line_width - room);
  const std::size_t last =
      gap == std::string_view::npos || gap < begin ? begin : line.find_first_not_of(' ', gap);
  if (width(line) <= line_width || last == std::string_view::npos) {
    text += std::string(line) + '\n';
    return;
  }
  text += line.substr(0, last);
  append_wrapped(text, last, line.substr(last), line.substr(last).starts_with("- ") ? last + 2 : last);
}

std::string called(const OptionRow& row) {
  if (row.positional())
    return row.value.type;
  return joined(names_of(row), ", ");
}

bool is_short(const std::vector<std::string>& choices) {
  return joined(choices, "|").size() <= line_width / 2;
}

std::string value_of(const OptionRow& row) {
  const Value& value = row.value;
  if (row.positional() || value.flag())
    return {};
  if (!value.choices.empty())
    return is_short(value.choices) ? joined(value.choices, "|") : "WORD";
  return value.type;
}

std::string meaning_of(const OptionRow& row) {
  const Value& value = row.value;
  std::string meaning = row.meaning;
  if (!is_short(value.choices))
    meaning += ": " + joined(value.choices, ", ");
  std::vector<std::string> remarks;
  if (row.required)
    remarks.emplace_back("required");
  if (!value.limits.empty())
    remarks.push_back(value.limits);
  if (!value.by_default.empty())
    remarks.push_back("default " + value.by_default);
  for (const auto& [one_of, reason, beside] : row.needs)
    if (reason.empty())
      remarks.push_back("with " + std::string(one_of));
  return remarks.empty() ? meaning : meaning + " (" + joined(remarks, "; ") + ")";
}

OptionGroup& group_called(std::vector<OptionGroup>& groups, const std::string& title) {
  const auto same = [&](const OptionGroup& group) { return group.title == title; };
  const auto found = std::find_if(groups.begin(), groups.end(), same);
  return found != groups.end() ? *found : groups.emplace_back(OptionGroup{.title = title, .options = {}});
}

} // namespace

std::string joined(const std::vector<std::string>& words, const char* separator) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : separator) + word;
  return text;
}

std::vector<OptionGroup> option_groups(const Command& command) {
  std::vector<OptionGroup> groups;
  OptionGroup output{.title = output_group, .options = {}};
  for (const OptionRow& row : command.options) {
    const OptionText text{called(row), value_of(row), meaning_of(row), &row};
    if (row.positional())
      group_called(groups, "Arguments").options.push_back(text);
    else if (row.group == output_group)
      output.options.push_back(text);
    else
      group_called(groups, row.group).options.push_back(text);
  }
  if (!output.options.empty())
    groups.push_back(output);
  return groups;
}

std::vector<CommandGroup> command_groups(const Command& app) {
  std::vector<CommandGroup> groups;
  for (const Command& command : app.within) {
    if (command.group.empty())
      continue;
    const auto same = [&](const CommandGroup& group) { return group.title == command.group; };
    auto found = std::find_if(groups.begin(), groups.end(), same);
    if (found == groups.end())
      found = groups.insert(groups.end(), {.title = command.group, .commands = {}});
    found->commands.push_back(&command);
  }
  return groups;
}

std::string usage_line(const Command& command) {
  std::string line = command.called;
  if (!command_groups(command).empty())
    return line + " COMMAND [OPTIONS]";
  for (const OptionRow& row : command.options)
    if (row.positional())
      line += " " + called(row) + (row.value.several ? "..." : "");
  return line + " [OPTIONS]";
}

std::string commands_text(const Command& command) {
  std::string text;
  for (const CommandGroup& group : command_groups(command)) {
    text += "\n" + group.title + ":\n";
    for (const Command* inner : group.commands)
      append_entry(text, inner->name, inner->meaning);
  }
  return text;
}

std::string help_text(const Command& command) {
  std::string text;
  append_wrapped(text, 0, command.meaning, 0);
  text += "Usage: " + usage_line(command) + "\n";
  text += commands_text(command);
  for (const OptionGroup& group : option_groups(command)) {
    text += "\n" + group.title + ":\n";
    for (const OptionText& option : group.options)
      append_entry(text, option.value.empty() ? option.names : option.names + " " + option.value,
                   option.meaning);
  }
  std::istringstream notes(command.notes);
  if (!command.notes.empty())
    text += '\n';
  for (std::string line; std::getline(notes, line);)
    append_line(text, line);
  return text;
}

std::string within_width(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    append_line(out, text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

} // namespace granum::cli
