// SPDX-License-Identifier: GPL-3.0-or-later
#include "suggest.hpp"

#include <algorithm>
#include <functional>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <granum/core/text.hpp>

#include "studies/scene/scene_keys.hpp"

namespace granum::cli {

namespace {

using Names = std::vector<std::string>;

/// Synonyms of a command, and its name.
struct OtherNames {
  std::vector<std::string> words;
  const char* command;
};

/// Properties that granum does not model, with their messages.
constexpr Synonyms not_modelled[] = {
    {"ocr overconsolidation age ageing",
     "overconsolidation and age are not modelled; granum infer uses a measured wave speed of the ground"},
    {"spt nspt n60 n1 blowcount cpt qc qt",
     "penetration tests are not modelled; granum infer uses a measured wave speed of the ground"},
};

/// Usual words, also of other programs, for the commands.
const std::vector<OtherNames>& other_command_names() {
  static const std::vector<OtherNames> table = {
      {{"analyze", "analysis", "read", "import", "postprocess"}, "analyse"},
      {{"calc", "calculate", "compute", "modulus", "stiffness", "gmax"}, "estimate"},
      {{"inverse", "invert", "calibrate"}, "infer"},
      {{"profile", "depth", "path", "table", "plot"}, "sweep"},
      {{"regress", "hardin"}, "fit"},
      {{"run", "simulate", "dem", "check"}, "verify"},
      {{"lammps", "write"}, "export"},
  };
  return table;
}

/// "--Void_Ratio" as "VoidRatio".
std::string bare(std::string_view word) {
  std::string text(word);
  std::erase_if(text, [](char c) { return c == '-' || c == '_'; });
  return text;
}

/// "--void-ratio" as "void-ratio".
std::string without_hyphens(const std::string& word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

/// Names without hyphens.
Names long_options(const Command& command) {
  Names names;
  for (const OptionRow& row : command.options)
    for (const std::string& name : names_of(row))
      if (name.starts_with("--"))
        names.push_back(name.substr(2));
  return names;
}

/// All commands with options.
std::vector<const Command*> all_commands(const Command& program) {
  std::vector<const Command*> found;
  for (const Command& command : program.within) {
    if (command.group.empty())
      continue;
    for (const Command& inner : command.within)
      found.push_back(&inner);
    if (command.within.empty())
      found.push_back(&command);
  }
  return found;
}

/// Options of a command with this word as a synonym.
struct Meant {
  Names options;
  std::string remark;
};

Meant called_so(const Command& command, const std::string& word) {
  Meant meant;
  for (const OptionRow& row : command.options)
    for (const auto& [words, remark] : row.synonyms)
      if (has_word(words, word)) {
        const bool first = !remark.empty() && meant.remark.empty(); // this one has a message
        meant.options.insert(first ? meant.options.begin() : meant.options.end(), names_of(row).back());
        if (first)
          meant.remark = remark;
      }
  return meant;
}

/// "--e is for ...": commands with an option of this name; empty if there is none.
std::string of_other_commands(const Command& program, const std::function<Names(const Command&)>& options) {
  std::string option;
  Names takers;
  for (const Command* command : all_commands(program)) {
    const Names here = options(*command);
    if (option.empty() && !here.empty())
      option = here.front();
    if (!option.empty() && command->find(option) != nullptr)
      takers.push_back(command->called);
  }
  return takers.empty() ? std::string() : fmt::format("{} is for {}", option, fmt::join(takers, ", "));
}

std::string takers_of(const Command& program, const std::string& option) {
  return of_other_commands(program, [&](const Command& command) {
    return command.find(option) != nullptr ? Names{option} : Names{};
  });
}

/// The word in the spelling of an option of the program: as typed, or else in small letters.
std::string known_word(const Command& program, const std::string& typed) {
  for (const Command* command : all_commands(program))
    if (!called_so(*command, typed).options.empty())
      return typed;
  return in_small_letters(typed);
}

/// Keys of the scene, for a command with a scene.
Names near_scene_keys(const Command& command, const std::string& name) {
  if (command.find("--set") == nullptr)
    return {};
  Names keys;
  for (const studies::SceneKey& key : studies::scene_keys())
    keys.push_back(key.name);
  return near_misses(name, keys);
}

/// The likely intended option, as the end of a sentence; empty if there is none.
std::string meant_option(const Command& program, const Command& command, const std::string& typed) {
  if (const std::string small = "--" + in_small_letters(without_hyphens(typed));
      command.find(small) != nullptr)
    return fmt::format("; did you mean {}?", small);
  const std::string word = known_word(program, bare(typed));
  for (const auto& [words, remark] : not_modelled)
    if (has_word(words, word))
      return fmt::format(": {}", remark);
  if (const auto [options, remark] = called_so(command, word); !options.empty())
    return fmt::format("; did you mean {}?{}", fmt::join(options, " or "),
                       remark.empty() ? "" : " (" + remark + ")");
  const std::string name = without_hyphens(typed);
  const Names near = near_misses(name, long_options(command));
  if (!near.empty() && near.size() <= 3)
    return fmt::format("; did you mean --{}?", fmt::join(near, " or --"));
  if (const Names keys = near_scene_keys(command, name); !keys.empty() && keys.size() <= 3)
    return fmt::format("; did you mean --set {}?", fmt::join(keys, " or --set "));
  if (const std::string exactly = takers_of(program, typed); !exactly.empty())
    return "; " + exactly;
  const std::string elsewhere =
      of_other_commands(program, [&](const Command& other) { return called_so(other, word).options; });
  return elsewhere.empty() ? fmt::format("; {} --help lists the options", command.called) : "; " + elsewhere;
}

/// A word that begins with a dash of a text processor, with hyphens instead; empty for other words.
std::string with_hyphens(const std::string& word) {
  constexpr std::string_view dashes[] = {"-", "\u2010", "\u2011", "\u2013", "\u2014", "\u2212"};
  std::string_view rest = word;
  for (auto dash = std::begin(dashes); dash != std::end(dashes);)
    if (rest.starts_with(*dash)) {
      rest.remove_prefix(dash->size());
      dash = std::begin(dashes);
    } else
      ++dash;
  return rest.size() == word.size() || word[0] == '-' ? std::string() : "--" + std::string(rest);
}

bool looks_like_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word != "--" && !leading_number(word);
}

} // namespace

std::string unknown_option(const Command& program, const Command& command, const std::string& typed) {
  return fmt::format("{} has no option {}{}", command.called, typed, meant_option(program, command, typed));
}

std::string stray_word(const Command& program, const Command& command, const std::string& word) {
  if (command.takes_arguments())
    return fmt::format("'{}' is an extra argument: {} reads one file", word, command.called);
  const std::string message = fmt::format("{} has no argument '{}'", command.called, word);
  if (const std::string mended = with_hyphens(word); !mended.empty())
    return fmt::format("'{}' begins with a dash, not with hyphens: write {}", word, mended);
  const std::string key = word.substr(0, word.find('='));
  if (key.size() < word.size()) {
    const std::string option = "--" + key;
    if (command.find(option) != nullptr)
      return fmt::format("{}: write {} {}", message, option, word.substr(key.size() + 1));
    return message + meant_option(program, command, option);
  }
  if (command.find("--" + word) != nullptr)
    return fmt::format("{}: write --{}", message, word);
  return message + ": each value needs the name of its option before it, as in --out FILE";
}

std::string unknown_command(const Command& program, const std::vector<std::string>& words) {
  const std::string& word = words.front();
  Names names;
  for (const Command& command : program.within)
    if (!command.group.empty())
      names.push_back(command.name);
  if (looks_like_option(word)) {
    const Names near = near_misses(without_hyphens(word), long_options(program));
    if (!near.empty())
      return fmt::format("{} has no option {}; did you mean --{}?", program.called, word, near.front());
    const std::string takers = takers_of(program, word.substr(0, word.find('=')));
    return fmt::format("the first word is the command, one of {}{}", fmt::join(names, ", "),
                       takers.empty() ? "" : "; " + takers);
  }
  const std::string message = fmt::format("there is no command '{}'", word);
  for (const auto& [others, command] : other_command_names())
    if (std::find(others.begin(), others.end(), in_small_letters(word)) != others.end() &&
        std::find(names.begin(), names.end(), command) != names.end())
      return fmt::format("{}; did you mean {}?", message, command);
  const std::string near = did_you_mean(word, names);
  return message + (near.empty() ? fmt::format("; there are {}", fmt::join(names, ", ")) : near);
}

} // namespace granum::cli
