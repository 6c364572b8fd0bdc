// SPDX-License-Identifier: GPL-3.0-or-later
#include "contradictions.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace granum::cli {

namespace {

/// Whether a list contains one of the names of the option.
bool lists(std::string_view names, const OptionRow& row) {
  const std::vector<std::string> own = names_of(row);
  return std::any_of(own.begin(), own.end(), [&](const std::string& name) { return has_word(names, name); });
}

/// The contradiction between two options, according to the row of one of them.
std::optional<std::string> said_against(const OptionRow& row, const OptionRow& other) {
  for (const Exclusion& exclusion : row.excludes)
    if (lists(exclusion.others, other))
      return std::string(exclusion.sentence);
  return std::nullopt;
}

std::string first_word(std::string_view list) { return std::string(list.substr(0, list.find(' '))); }

} // namespace

std::string belongs_to_other_contact(const std::string& option, std::string_view wanted,
                                     std::string_view chosen) {
  return fmt::format("{} goes with --contact {}, not with --contact {}", option, wanted, chosen);
}

Contradictions::Contradictions(const std::vector<TypedArgument>& arguments) : arguments_(arguments) {
  for (const TypedArgument& argument : arguments)
    if (argument.option == nullptr && !argument.stray)
      all_known_ = false;
}

const TypedArgument* Contradictions::typed(std::string_view name) const {
  const auto found = std::find_if(arguments_.begin(), arguments_.end(), [&](const TypedArgument& argument) {
    return argument.option != nullptr && is_named(*argument.option, name);
  });
  return found == arguments_.end() ? nullptr : &*found;
}

bool Contradictions::any_typed(std::string_view names) const {
  return std::any_of(arguments_.begin(), arguments_.end(), [&](const TypedArgument& argument) {
    return argument.option != nullptr && lists(names, *argument.option);
  });
}

std::string Contradictions::excluded(std::size_t index) const {
  const OptionRow& row = *arguments_[index].option;
  for (std::size_t k = 0; k < index; ++k) {
    const OptionRow* other = arguments_[k].option;
    if (other == nullptr || other == &row)
      continue;
    std::optional<std::string> sentence = said_against(row, *other);
    if (!sentence)
      sentence = said_against(*other, row);
    if (sentence)
      return sentence->empty() ? fmt::format("{} excludes {}", first_name(row), first_name(*other))
                               : *sentence;
  }
  return {};
}

std::string Contradictions::lacking(const TypedArgument& argument) const {
  for (const auto& [one_of, reason, beside] : argument.option->needs)
    if (!any_typed(one_of) && (beside.empty() || any_typed(beside)))
      return reason.empty() ? fmt::format("{} requires {}", argument.word, first_word(one_of))
                            : fmt::format("{} goes with {}", argument.word, reason);
  return {};
}

std::string Contradictions::belonging(const TypedArgument& argument) const {
  if (typed("--table") != nullptr)
    return {};
  for (const auto& [chooser, choices, otherwise, reason] : argument.option->belongs) {
    const TypedArgument* chosen = typed(chooser);
    std::string choice(otherwise);
    if (chosen != nullptr && !chosen->values.empty())
      choice = in_small_letters(chosen->values.front());
    const std::vector<std::string>* known = chosen != nullptr ? &chosen->option->value.choices : nullptr;
    const bool mistyped = known != nullptr && std::find(known->begin(), known->end(), choice) == known->end();
    if (mistyped || has_word(choices, choice))
      continue; // an invalid choice has its own message
    return reason.empty() ? belongs_to_other_contact(argument.word, first_word(choices), choice)
                          : fmt::format("{} goes with {}", argument.word, reason);
  }
  return {};
}

std::string Contradictions::of(std::size_t index) {
  const TypedArgument& argument = arguments_[index];
  if (argument.option == nullptr)
    return {};
  std::string sentence = excluded(index);
  if (sentence.empty() && all_known_)
    sentence = lacking(argument);
  if (sentence.empty() && all_known_)
    sentence = belonging(argument);
  return said_.insert(sentence).second ? sentence : std::string();
}

} // namespace granum::cli
