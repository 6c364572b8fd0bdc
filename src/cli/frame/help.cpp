// SPDX-License-Identifier: GPL-3.0-or-later
#include "help.hpp"

#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>

namespace granum::cli {

namespace {

constexpr std::size_t line_width = 80;
constexpr std::size_t meaning_column = 30;

std::size_t width(std::string_view text) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
}

/// Adds words to a text whose last line is `column` wide, in lines that go on at `indent`.
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

/// A line of two columns: what something is called, and what it is.
void append_entry(std::string& text, const std::string& name, const std::string& meaning) {
  const std::string left = "  " + name;
  text += left;
  if (width(left) + 2 > meaning_column)
    text += '\n' + std::string(meaning_column, ' ');
  else
    text += std::string(meaning_column - width(left), ' ');
  append_wrapped(text, meaning_column, meaning, meaning_column);
}

/// A line that fits: one that has columns goes on below its last one that leaves room, others below their
/// first word.
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

std::string called(const CLI::Option& option) {
  if (option.get_positional())
    return option.get_type_name() == "TEXT" ? option.get_name() : option.get_type_name();
  return joined(names_of(option), ", ");
}

/// The limits of a whole number, "INT in [2 - 1000]" of the parser, as "2 to 1000"; empty for others.
std::string limits_of(const std::string& type) {
  const std::size_t begin = type.find(" in [");
  if (begin == std::string::npos)
    return {};
  std::string limits = type.substr(begin + 5, type.find(']', begin) - begin - 5);
  if (const std::size_t dash = limits.find(" - "); dash != std::string::npos)
    limits.replace(dash, 3, " to ");
  return limits;
}

bool is_short(const std::vector<std::string>& choices) {
  return joined(choices, "|").size() <= line_width / 2;
}

std::string value_of(const CLI::Option& option) {
  if (option.get_positional() || option.get_items_expected_max() == 0)
    return {};
  const std::vector<std::string> choices = choices_of(option);
  if (!choices.empty())
    return is_short(choices) ? joined(choices, "|") : "WORD";
  const std::string full = option.get_type_name();
  const std::string type = full.substr(0, full.find(':'));
  return type == "UINT" || type == "INT" ? "N" : type == "FLOAT" ? "NUMBER" : type;
}

std::string meaning_of(const CLI::Option& option) {
  std::string meaning = option.get_description();
  if (const std::vector<std::string> choices = choices_of(option); !is_short(choices))
    meaning += ": " + joined(choices, ", ");
  std::vector<std::string> remarks;
  if (option.get_required())
    remarks.emplace_back("required");
  if (const std::string limits = limits_of(option.get_type_name()); !limits.empty())
    remarks.push_back(limits);
  if (!option.get_default_str().empty())
    remarks.push_back("default " + option.get_default_str());
  for (const CLI::Option* needed : option.get_needs())
    remarks.push_back("with " + needed->get_name());
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

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
    names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    names.push_back("--" + name);
  return names;
}

void in_group(CLI::App& command, const std::string& title, std::initializer_list<const char*> names) {
  // one pass over all names as they stand: get_option would copy each of them for each option
  for (CLI::Option* option : command.get_options([](const CLI::Option*) { return true; }))
    for (const std::string& own : option->get_lnames())
      if (std::any_of(names.begin(), names.end(), [&](const char* name) { return own == name + 2; }))
        option->group(title);
}

std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  std::vector<std::string> choices;
  const std::size_t brace = type.find(":{");
  const bool listed = brace != std::string::npos;
  const bool alternatives = !listed && type.find('|') != std::string::npos;
  std::istringstream stream(listed         ? type.substr(brace + 2, type.find('}') - brace - 2)
                            : alternatives ? type
                                           : "");
  for (std::string word; std::getline(stream, word, listed ? ',' : '|');)
    choices.push_back(word);
  return choices;
}

std::vector<OptionGroup> option_groups(const CLI::App& command) {
  std::vector<OptionGroup> groups;
  OptionGroup output{.title = output_group, .options = {}};
  const CLI::Option* help = command.get_help_ptr();
  const auto all =
      command.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
  for (const CLI::Option* option : all) {
    const OptionText text{called(*option), value_of(*option), meaning_of(*option), option};
    if (option == help)
      continue;
    if (option->get_positional())
      group_called(groups, "Arguments").options.push_back(text);
    else if (option->get_group() == output_group)
      output.options.push_back(text);
    else
      group_called(groups, option->get_group()).options.push_back(text);
  }
  if (help != nullptr)
    output.options.push_back({called(*help), "", help->get_description(), help});
  groups.push_back(output);
  return groups;
}

std::vector<CommandGroup> command_groups(const CLI::App& app) {
  std::vector<CommandGroup> groups;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_group().empty())
      continue;
    const auto same = [&](const CommandGroup& group) { return group.title == command->get_group(); };
    auto found = std::find_if(groups.begin(), groups.end(), same);
    if (found == groups.end())
      found = groups.insert(groups.end(), {.title = command->get_group(), .commands = {}});
    found->commands.push_back(command);
  }
  return groups;
}

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

std::string usage_line(const CLI::App& command) {
  std::string line = full_name(command);
  if (!command_groups(command).empty())
    return line + " COMMAND [OPTIONS]";
  for (const CLI::Option* option :
       command.get_options([](const CLI::Option* o) { return o->get_positional(); }))
    line += " " + called(*option) + (option->get_items_expected_max() > 1 ? "..." : "");
  return line + " [OPTIONS]";
}

std::string commands_text(const CLI::App& command) {
  std::string text;
  for (const CommandGroup& group : command_groups(command)) {
    text += "\n" + group.title + ":\n";
    for (const CLI::App* inner : group.commands)
      append_entry(text, inner->get_name(), inner->get_description());
  }
  return text;
}

std::string help_text(const CLI::App& command) {
  std::string text;
  append_wrapped(text, 0, command.get_description(), 0);
  text += "Usage: " + usage_line(command) + "\n";
  text += commands_text(command);
  for (const OptionGroup& group : option_groups(command)) {
    text += "\n" + group.title + ":\n";
    for (const OptionText& option : group.options)
      append_entry(text, option.value.empty() ? option.names : option.names + " " + option.value,
                   option.meaning);
  }
  std::istringstream footer(command.get_footer());
  if (!command.get_footer().empty())
    text += '\n';
  for (std::string line; std::getline(footer, line);)
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
