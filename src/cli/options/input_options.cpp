// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_options.hpp"

#include <algorithm>
#include <set>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>

namespace granum::cli {

namespace {

using estimate::Belongs;
using estimate::InputRow;
using estimate::Kind;

/// A text that rows of options refer to as long as the program runs.
std::string_view kept(std::string text) {
  static std::set<std::string> all;
  return *all.insert(std::move(text)).first;
}

Value number_value(InputValues& values, const InputRow& row) {
  Value value{.type = type_name(row.dimension), .dimension = row.dimension};
  if (row.by_default && !(row.law != nullptr && row.origin.empty()))
    value.by_default = pretty(*row.by_default, row.dimension);
  value.take = [&values, &row](const std::string& name, const std::string& text) {
    take_as(name, text, [&](const std::string& number) {
      values.give(row.input, quantity_in(name, number, row.dimension), estimate::Source::typed,
                  number.find('%') != std::string::npos);
    });
  };
  return value;
}

Value word_value(InputValues& values, const InputRow& row) {
  const Take take = [&values, &row](const std::string& text) { // units keep their letters
    const std::size_t word = std::min(text.find(':'), text.size());
    values.give(row.input, in_small_letters(text.substr(0, word)) + text.substr(word));
  };
  if (row.aliases.empty())
    return read_by(take, row.words);
  OtherWords others;
  for (const estimate::WordAlias& alias : row.aliases) {
    const auto known =
        std::find_if(others.begin(), others.end(), [&](const auto& of) { return of.first == alias.other; });
    if (known != others.end())
      known->second += " or " + alias.word;
    else
      others.emplace_back(alias.other, alias.word);
  }
  return choice(row.words, take, others);
}

Value distribution_value(InputValues& values, const InputRow& row) {
  if (row.input == Input::sieve)
    return read_by(
        [&values](const std::string& path) {
          values.give(Input::sieve, sizes::Distribution::sieve(io::read_sieve_curve(path)));
        },
        "FILE");
  return read_by([&values, &row](const std::string& text) { values.give(row.input, text); }, "DISTRIBUTION");
}

Value value_of(InputValues& values, const InputRow& row) {
  switch (row.kind) {
  case Kind::word:
    return word_value(values, row);
  case Kind::distribution:
    return distribution_value(values, row);
  default:
    return number_value(values, row);
  }
}

} // namespace

OptionRow input_option(InputValues& values, Input input) {
  const InputRow& of = estimate::row_of(input);
  OptionRow row{.name = of.option(), .value = value_of(values, of), .group = of.group, .meaning = of.meaning};
  for (const auto& [keys, sentence] : of.excludes) {
    std::string options;
    for (const std::string& key : words_of(keys))
      options += (options.empty() ? "" : " ") + estimate::find_input(key)->option();
    row.excludes.push_back({kept(options), kept(values.spelled(sentence))});
  }
  for (const auto& [words, remark] : of.synonyms)
    row.synonyms.push_back({words, remark});
  if (of.law != nullptr)
    row.belongs = {{"--contact", contact::name(of.law->shape), "sphere"}};
  if (input == Input::contact)
    row.value.by_default = contact::name(values.contact);
  return row;
}

void add_input(Command& command, InputValues& values, Input input) {
  command.add(input_option(values, input));
}

namespace {

/// All inputs of a packing in a group of help, but for those of contact laws.
void add_group(Command& command, InputValues& values, std::string_view group) {
  for (const InputRow& row : estimate::inputs())
    if (row.group == group && row.belongs == Belongs::to_packing && row.law == nullptr &&
        row.input != Input::contact)
      add_input(command, values, row.input);
}

} // namespace

void add_law_options(Command& command, InputValues& values, const std::string& name) {
  add_group(command, values, grains_group);
  OptionRow shape = input_option(values, Input::contact);
  shape.name = name;
  command.add(std::move(shape));
  for (const InputRow& row : estimate::inputs())
    if (row.law != nullptr)
      add_input(command, values, row.input);
}

void add_packing_options(Command& command, InputValues& values) {
  add_group(command, values, state_group);
  add_group(command, values, contacts_group);
  add_law_options(command, values);
  add_group(command, values, law_group);
  add_group(command, values, sizes_group);
}

void add_answer_options(Command& command, InputValues& values) {
  for (const bool words : {true, false}) // in help, the grains by name precede their density
    for (const InputRow& row : estimate::inputs())
      if (row.belongs == Belongs::to_answer && (row.kind == Kind::word) == words)
        add_input(command, values, row.input);
}

OptionRow uncertainty_row(std::vector<std::string>& settings) {
  Value value = texts(settings, "KEY=SD");
  value.joins_units = true;
  return {.name = "--uncertainty",
          .value = std::move(value),
          .meaning = "Standard deviation of an input, may be repeated. KEY is the name of its option: "
                     "void-ratio=0.02; or relative to its value: pressure=5%"};
}

} // namespace granum::cli
