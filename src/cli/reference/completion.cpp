// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>

#include "cli/frame/help.hpp"
#include "reference.hpp"

namespace granum::cli {

namespace {

/// Possible values of an option.
enum class Kind { none, words, file, folder, other };

bool is_placeholder(const std::string& word) {
  return std::any_of(word.begin(), word.end(),
                     [](char c) { return std::isupper(static_cast<unsigned char>(c)); });
}

/// The choices of an option; for "friction:NUMBER" the part before the number.
std::vector<std::string> words_for(const OptionRow& row) {
  std::vector<std::string> words;
  for (const std::string& choice : row.value.choices) {
    const std::string word = choice.substr(0, choice.find(':') + 1);
    if (!is_placeholder(choice))
      words.push_back(choice);
    else if (!word.empty() && !is_placeholder(word))
      words.push_back(word);
  }
  return words;
}

Kind kind_of(const OptionRow& row) {
  if (row.value.flag())
    return Kind::none;
  if (!words_for(row).empty())
    return Kind::words;
  const std::string type = row.value.type;
  if (type == "DIR")
    return Kind::folder;
  return type.find("FILE") != std::string::npos ? Kind::file : Kind::other;
}

std::vector<const Command*> within(const Command& app) {
  std::vector<const Command*> commands;
  for (const CommandGroup& group : command_groups(app))
    commands.insert(commands.end(), group.commands.begin(), group.commands.end());
  return commands;
}

std::vector<OptionText> options_of(const Command& command, bool positional) {
  std::vector<OptionText> options;
  for (const OptionGroup& group : option_groups(command))
    for (const OptionText& option : group.options)
      if (option.row->positional() == positional)
        options.push_back(option);
  return options;
}

// ---- bash

/// One branch of `case "$command $before"` for each kind of value.
void append_bash_values(std::string& script, const Command& command, const std::string& path) {
  for (const OptionText& text : options_of(command, false)) {
    const Kind value = kind_of(*text.row);
    if (value == Kind::none)
      continue;
    std::vector<std::string> patterns;
    for (const std::string& name : names_of(*text.row))
      patterns.push_back("'" + path + " " + name + "'");
    const std::string answer = value == Kind::words
                                   ? "compgen -W '" + joined(words_for(*text.row), " ") + "' -- \"$word\""
                               : value == Kind::file   ? "compgen -f -- \"$word\""
                               : value == Kind::folder ? "compgen -d -- \"$word\""
                                                       : "";
    script += "    " + joined(patterns, "|") + ")\n";
    if (!answer.empty())
      script += "      mapfile -t COMPREPLY < <(" + answer + ")\n";
    script += "      return ;;\n";
  }
  for (const Command* inner : within(command))
    append_bash_values(script, *inner, path + " " + inner->name);
}

/// One branch of `case "$command"` for each command: the possible words outside of values.
void append_bash_words(std::string& script, const Command& command, const std::string& path) {
  std::vector<std::string> words;
  for (const Command* inner : within(command))
    words.push_back(inner->name);
  for (const OptionText& text : options_of(command, false))
    for (const std::string& name : names_of(*text.row))
      words.push_back(name);
  script += "    '" + path + "')\n      words='" + joined(words, " ") + "'\n";
  if (!options_of(command, true).empty())
    script += "      files=yes\n";
  script += "      ;;\n";
  for (const Command* inner : within(command))
    append_bash_words(script, *inner, path + " " + inner->name);
}

std::string bash_commands(const Command& program) {
  std::vector<std::string> paths;
  for (const Command* command : within(program)) {
    paths.push_back("'granum " + command->name + "'");
    for (const Command* inner : within(*command))
      paths.push_back("'granum " + command->name + " " + inner->name + "'");
  }
  return joined(paths, "|");
}

// ---- zsh

/// Escapes a text for '...' and [...] of _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\')
      out += '\\';
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return out;
}

std::string zsh_action(const OptionRow& row) {
  switch (kind_of(row)) {
  case Kind::words:
    return "(" + joined(words_for(row), " ") + ")";
  case Kind::file:
    return "_files";
  case Kind::folder:
    return "_files -/";
  default:
    return " ";
  }
}

void append_zsh_arguments(std::string& script, const Command& command, const std::string& indent) {
  script += indent + "_arguments";
  for (const OptionText& text : options_of(command, false))
    for (const std::string& name : names_of(*text.row)) {
      const bool value = kind_of(*text.row) != Kind::none;
      script += " \\\n" + indent + "  '*" + name + (value ? "=" : "") + "[" + zsh_text(text.meaning) + "]" +
                (value ? ":" + zsh_text(text.value) + ":" + zsh_action(*text.row) : "") + "'";
    }
  for (const OptionText& text : options_of(command, true))
    script += " \\\n" + indent + "  '*:" + zsh_text(text.names) + ":_files'";
  script += '\n';
}

/// The commands within one, then the arguments of each.
void append_zsh_commands(std::string& script, const Command& app, const std::string& indent) {
  script += indent + "local -a commands=(\n";
  for (const Command* command : within(app))
    script += indent + "  '" + command->name + ":" + zsh_text(command->meaning) + "'\n";
  script +=
      indent + ")\n" + indent + "if (( CURRENT == 2 )); then\n" + indent + "  _describe command commands\n";
  append_zsh_arguments(script, app, indent + "  ");
  script += indent + "  return\n" + indent + "fi\n" + indent + "shift words\n" + indent + "(( CURRENT-- ))\n";
  script += indent + "case $words[1] in\n";
  for (const Command* command : within(app)) {
    script += indent + "  " + command->name + ")\n";
    if (within(*command).empty())
      append_zsh_arguments(script, *command, indent + "    ");
    else
      append_zsh_commands(script, *command, indent + "    ");
    script += indent + "    ;;\n";
  }
  script += indent + "esac\n";
}

} // namespace

std::string bash_completion(const Command& program) {
  std::string script =
      "# Completion of granum for bash, made by granum of its own options.\n"
      "_granum() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=granum k\n"
      "  local words= files=\n"
      "  if [[ $word == '=' ]]; then\n"
      "    word=\n"
      "  elif [[ $before == '=' ]]; then\n"
      "    before=${COMP_WORDS[COMP_CWORD-2]}\n"
      "  fi\n"
      "  for ((k = 1; k < COMP_CWORD; ++k)); do\n"
      "    case \"$command ${COMP_WORDS[k]}\" in\n"
      "      " +
      bash_commands(program) +
      ")\n"
      "        command+=\" ${COMP_WORDS[k]}\" ;;\n"
      "      *)\n"
      "        break ;;\n"
      "    esac\n"
      "  done\n"
      "  COMPREPLY=()\n"
      "  case \"$command $before\" in\n";
  append_bash_values(script, program, "granum");
  script += "  esac\n  case \"$command\" in\n";
  append_bash_words(script, program, "granum");
  script += "  esac\n"
            "  if [[ -n $files && $word != -* ]]; then\n"
            "    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
            "  else\n"
            "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
            "  fi\n"
            "}\n"
            "complete -o filenames -F _granum granum\n";
  return script;
}

std::string zsh_completion(const Command& program) {
  std::string script =
      "#compdef granum\n# Completion of granum for zsh, made by granum of its own options.\n_granum() {\n";
  append_zsh_commands(script, program, "  ");
  return script + "}\n_granum \"$@\"\n";
}

} // namespace granum::cli
