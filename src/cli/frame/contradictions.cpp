// SPDX-License-Identifier: GPL-3.0-or-later
#include "contradictions.hpp"

#include <algorithm>
#include <deque>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/contact/laws.hpp>

#include "help.hpp"

namespace granum::cli {

namespace {

using OptionNames = std::vector<const char*>;

/// Options of which no two, or none of the first beside one of the second, go together.
struct Exclusion {
  OptionNames these;
  OptionNames those; ///< empty: any two of the first
  const char* sentence;
};

const std::vector<Exclusion>& exclusions() {
  static const std::vector<Exclusion> table = {
      {{"--void-ratio", "--porosity", "--solid-fraction", "--relative-density"}, {}, said_twice::density},
      {{"--pressure"}, {"--stress-v", "--stress-h"}, said_twice::stress},
      {{"--radius", "--d50"}, {}, said_twice::size},
      {{"--sizes", "--sieve", "--uniformity"}, {}, said_twice::sizes},
      {{"--eta"}, {"--friction-angle"}, "give one of --eta and --friction-angle, where the path ends"},
      {{"--material"},
       {"--grain-shear-modulus", "--grain-poisson-ratio"},
       "--material says what --grain-shear-modulus and --grain-poisson-ratio say: leave these out"},
      {{"--quick"}, {"--full", "--budget"}, "--quick cannot go with --full or --budget"},
      {{"--paper"}, {"--scene"}, "--paper is a scene of its own; give it or --scene"},
      {{"--resume"},
       {"--paper", "--scene", "--set", "--grains", "--seeds", "--out"},
       "--resume takes its scene and folder from the earlier run; only --threads may be given with it"},
      {{"--report"},
       {"--scene", "--set", "--grains", "--seeds", "--threads", "--out"},
       "--report takes all from the earlier run; no scene and no other folder may be given with it"},
  };
  return table;
}

/// Options that go with one of others alone.
struct Companion {
  const char* command; ///< that asks for it
  OptionNames options;
  OptionNames needed; ///< one of them
  OptionNames beside; ///< only where one of them is typed; empty: always
  const char* reason; ///< behind "--pressure goes with "
};

const std::vector<Companion>& companions() {
  static const OptionNames stresses = {"--pressure", "--stress-v", "--stress-h"};
  static const std::vector<Companion> table = {
      {"sweep", stresses, {"--table"}, {"--depth"}, "--table; in the ground the weight above is the stress"},
      {"sweep", stresses, {"--table", "--depth"}, {}, "--table; a path takes its stress from --from"},
      {"sweep",
       {"--unit-weight", "--saturated-unit-weight", "--water-table", "--water-unit-weight", "--k0",
        "--surcharge"},
       {"--depth"},
       {},
       "--depth"},
      {"sweep",
       {"--saturated-unit-weight", "--water-unit-weight"},
       {"--water-table"},
       {},
       "--water-table, below which it holds"},
      {"sweep", {"--force"}, {"--out", "--picture"}, {}, "--out or --picture"},
      {"infer", {"--force"}, {"--out", "--picture"}, {}, "--out or --picture"},
      {"fit", {"--force"}, {"--out", "--picture"}, {}, "--out or --picture"},
  };
  return table;
}

/// Options that go with some choices of another one.
struct Belonging {
  OptionNames options;
  const char* chooser;
  OptionNames choices;
  const char* otherwise; ///< the choice where none is typed
  const char* reason;    ///< behind "--eta goes with "; empty: as of contacts
};

/// Numbers of contact laws, as the table of laws has them.
std::vector<Belonging> of_contact_laws() {
  static std::deque<std::string> words;
  std::vector<Belonging> out;
  for (const contact::LawRow& row : contact::laws()) {
    OptionNames options;
    for (const contact::LawParameter& parameter : row.parameters)
      options.push_back(words.emplace_back(parameter.option()).c_str());
    if (!options.empty())
      out.push_back({options, "--contact", {words.emplace_back(name(row.shape)).c_str()}, "sphere", ""});
  }
  return out;
}

std::vector<Belonging> all_belongings() {
  std::vector<Belonging> table = of_contact_laws();
  table.insert(
      table.end(),
      {
          {{"--material"}, "--contact", {"sphere"}, "sphere", "--contact sphere"},
          {{"--eta", "--friction-angle"},
           "--path",
           {"txc", "rtxc", "rtxe", "txe"},
           "iso",
           "--path txc, rtxc, rtxe and txe, not with iso"},
          {{"--to"}, "--path", {"iso"}, "iso", "--path iso; other paths end at --eta or --friction-angle"},
      });
  return table;
}

const std::vector<Belonging>& belongings() {
  static const std::vector<Belonging> table = all_belongings();
  return table;
}

bool holds(const OptionNames& names, const std::string& name) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

} // namespace

std::string belongs_to_other_contact(const std::string& option, std::string_view wanted,
                                     std::string_view chosen) {
  return fmt::format("{} goes with --contact {}, not with --contact {}", option, wanted, chosen);
}

Contradictions::Contradictions(const CLI::App& command, const std::vector<TypedArgument>& arguments)
    : command_(command), arguments_(arguments) {
  for (const TypedArgument& argument : arguments)
    if (argument.option == nullptr && argument.word.starts_with('-'))
      all_known_ = false;
}

bool Contradictions::typed(const char* name, std::size_t before) const {
  const CLI::Option* option = command_.get_option_no_throw(name);
  return option != nullptr &&
         std::any_of(arguments_.begin(), arguments_.begin() + static_cast<std::ptrdiff_t>(before),
                     [&](const TypedArgument& argument) { return argument.option == option; });
}

bool Contradictions::any_typed(const OptionNames& names, std::size_t before) const {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return typed(name, before); });
}

std::optional<std::string> Contradictions::chosen(const char* name, const char* otherwise) const {
  const CLI::Option* option = command_.get_option_no_throw(name);
  for (const TypedArgument& argument : arguments_)
    if (option != nullptr && argument.option == option && !argument.values.empty()) {
      const CheckedValue choice = checked(*option, argument.values.front());
      return choice.complaint.empty() ? std::optional(choice.value) : std::nullopt;
    }
  return otherwise;
}

std::string Contradictions::by_rules(std::size_t index) const {
  const TypedArgument& argument = arguments_[index];
  // An option may have several names, of which rules know one.
  const auto is_one_of = [&](const OptionNames& names) {
    const std::vector<std::string> own = names_of(*argument.option);
    return std::any_of(own.begin(), own.end(), [&](const std::string& name) { return holds(names, name); });
  };
  for (const auto& [these, those, sentence] : exclusions())
    if ((is_one_of(these) && any_typed(those.empty() ? these : those, index)) ||
        (is_one_of(those) && any_typed(these, index)))
      return sentence;
  if (!all_known_)
    return {};
  const std::size_t all = arguments_.size();
  for (const auto& [command, options, needed, beside, reason] : companions())
    if (command_.get_name() == command && is_one_of(options) && !any_typed(needed, all) &&
        (beside.empty() || any_typed(beside, all)))
      return fmt::format("{} goes with {}", argument.word, reason);
  for (const auto& [options, chooser, choices, otherwise, reason] : belongings()) {
    const bool table_may_tell = typed("--table", all);
    if (!is_one_of(options) || command_.get_option_no_throw(chooser) == nullptr || table_may_tell)
      continue;
    if (const auto choice = chosen(chooser, otherwise); choice && !holds(choices, *choice))
      return *reason != '\0' ? fmt::format("{} goes with {}", argument.word, reason)
                             : belongs_to_other_contact(argument.word, choices.front(), *choice);
  }
  return {};
}

/// What was said to the parser.
std::string Contradictions::by_parser(std::size_t index) const {
  const CLI::Option& option = *arguments_[index].option;
  const std::set<CLI::Option*> excluded = option.get_excludes(), needed = option.get_needs();
  for (std::size_t k = 0; k < index; ++k)
    for (const CLI::Option* other : excluded)
      if (arguments_[k].option == other)
        return fmt::format("{} excludes {}", option.get_name(), other->get_name());
  for (const CLI::Option* other : needed)
    if (all_known_ && !typed(other->get_name().c_str(), arguments_.size()))
      return fmt::format("{} requires {}", option.get_name(), other->get_name());
  return {};
}

std::string Contradictions::of(std::size_t index) {
  if (arguments_[index].option == nullptr)
    return {};
  std::string sentence = by_rules(index);
  if (sentence.empty())
    sentence = by_parser(index);
  return said_.insert(sentence).second ? sentence : std::string();
}

} // namespace granum::cli
