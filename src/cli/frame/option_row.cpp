// SPDX-License-Identifier: GPL-3.0-or-later
#include "option_row.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::cli {

namespace {

std::size_t whole_in(const std::string& name, const std::string& text) {
  constexpr double largest = 1e15;
  const std::optional<double> value = parse_number(text);
  if (!value || *value != std::floor(*value))
    throw InvalidArgument(fmt::format("{} = '{}': expected a whole number", name, text));
  return static_cast<std::size_t>(require_closed(name, *value, 0, largest));
}

Value of_dimension(Dimension dimension) { return {.type = type_name(dimension), .dimension = dimension}; }

} // namespace

double quantity_in(const std::string& name, const std::string& text, Dimension dimension) {
  try {
    return parse_quantity(name, text, dimension);
  } catch (const InvalidArgument& error) {
    const std::string what = error.what();
    if (what.find("several values") == std::string::npos)
      throw;
    throw InvalidArgument(what + "; granum sweep takes a path or a table of states");
  }
}

// ---- commands and rows

void Command::add(OptionRow row) {
  if (row.value.number != nullptr)
    row.value.number->name = first_name(row);
  options.push_back(std::move(row));
}

void Command::add(const std::string& their_group, std::initializer_list<OptionRow> rows) {
  for (OptionRow row : rows) {
    if (row.group.empty())
      row.group = their_group;
    add(std::move(row));
  }
}

const OptionRow* Command::find(std::string_view option) const {
  const auto found = std::find_if(options.begin(), options.end(),
                                  [&](const OptionRow& row) { return is_named(row, option); });
  return found == options.end() ? nullptr : &*found;
}

OptionRow& Command::row(std::string_view option) {
  for (OptionRow& row : options)
    if (is_named(row, option))
      return row;
  throw std::logic_error(fmt::format("{} has no row {}", name, option));
}

void Command::remove(std::string_view option) {
  std::erase_if(options, [&](const OptionRow& row) { return is_named(row, option); });
}

bool Command::takes_arguments() const {
  return std::any_of(options.begin(), options.end(), [](const OptionRow& row) { return row.positional(); });
}

std::vector<std::string> names_of(const OptionRow& row) {
  return row.positional() ? std::vector<std::string>() : split_at(row.name, ',');
}

std::string first_name(const OptionRow& row) { return row.name.substr(0, row.name.find(',')); }

bool is_named(const OptionRow& row, std::string_view option) {
  std::string_view rest = row.name;
  while (!rest.empty() && !row.positional()) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    if (rest.substr(0, end) == option)
      return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string option_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos)
      return parts;
    text.remove_prefix(end + 1);
  }
}

bool has_word(std::string_view list, std::string_view word) {
  for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (!word.empty() && (at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' '))
      return true;
  }
  return false;
}

// ---- values

Value flag(bool& target) {
  return {.take = [&target](const std::string&, const std::string&) { target = true; }};
}

Value number_without_default(Number& target) {
  Value value = of_dimension(target.dimension);
  value.number = &target;
  value.take = [&target](const std::string& name, const std::string& text) {
    target.value = quantity_in(name, text, target.dimension);
    target.typed = true;
    target.per_cent = text.find('%') != std::string::npos;
  };
  return value;
}

Value number(Number& target) {
  Value value = number_without_default(target);
  value.by_default = pretty(target.value, target.dimension);
  return value;
}

Value quantity(std::optional<double>& target, Dimension dimension) {
  Value value = of_dimension(dimension);
  value.take = [&target, dimension](const std::string& name, const std::string& text) {
    target = quantity_in(name, text, dimension);
  };
  return value;
}

Value quantity(double& target, Dimension dimension) {
  Value value = of_dimension(dimension);
  value.by_default = pretty(target, dimension);
  value.take = [&target, dimension](const std::string& name, const std::string& text) {
    target = quantity_in(name, text, dimension);
  };
  return value;
}

Value count(std::optional<std::size_t>& target) {
  return {.type = "N", .take = [&target](const std::string& name, const std::string& text) {
            target = whole_in(name, text);
          }};
}

Value whole_number(std::size_t& target, std::size_t least, std::size_t most) {
  const std::string limits = fmt::format("{} to {}", least, most);
  return {.type = "N",
          .by_default = std::to_string(target),
          .limits = limits,
          .take = [&target, least, most, limits](const std::string& name, const std::string& text) {
            const std::size_t value = whole_in(name, text);
            if (value < least || value > most)
              throw InvalidArgument(fmt::format("{}: {} is not in the range {}", name, value, limits));
            target = value;
          }};
}

Value text(std::string& target, std::string type) {
  return {.type = std::move(type),
          .by_default = target,
          .take = [&target](const std::string&, const std::string& text) { target = text; }};
}

Value path(std::string& target, std::string type) {
  Value value = text(target, std::move(type));
  value.take = [&target](const std::string& name, const std::string& text) {
    if (text.empty())
      throw InvalidArgument(name + " is empty: give a name, or leave the option out");
    target = text;
  };
  return value;
}

Value texts(std::vector<std::string>& target, std::string type) {
  return {.type = std::move(type),
          .repeated = true,
          .take = [&target](const std::string&, const std::string& text) { target.push_back(text); }};
}

Value read_by(Take take, std::string type) {
  return {.type = std::move(type),
          .take = [take = std::move(take)](const std::string& name, const std::string& text) {
            take_as(name, text, take);
          }};
}

void take_as(const std::string& name, const std::string& text, const Take& take) {
  try {
    take(text);
  } catch (const InvalidArgument& error) {
    const std::string_view what = error.what();
    throw InvalidArgument(what.starts_with("--") ? std::string(what) : fmt::format("{}: {}", name, what));
  }
}

Value read_by(Take take, std::vector<std::string> choices) {
  Value value = read_by(std::move(take), fmt::format("{}", fmt::join(choices, "|")));
  value.choices = std::move(choices);
  return value;
}

Value choice(std::vector<std::string> words, Take take, OtherWords others) {
  const std::string list = fmt::format("{{{}}}", fmt::join(words, ","));
  Value value{.type = list, .choices = words};
  value.take = [words = std::move(words), others = std::move(others), take = std::move(take),
                list](const std::string& name, const std::string& text) {
    const std::vector<std::string> near = near_misses(text, words);
    const std::string small = in_small_letters(text);
    if (near.size() == 1 && slips_between(small, in_small_letters(near[0])) == 0)
      return take(near[0]);
    std::string question = did_you_mean(text, words);
    for (const auto& [other, word] : others)
      if (small == other)
        question = "; did you mean " + word + "?";
    throw InvalidArgument(fmt::format("{}: {} not in {}{}", name, text, list, question));
  };
  return value;
}

Value choice(std::vector<std::string> words, std::string& target) {
  Value value = choice(std::move(words), [&target](const std::string& word) { target = word; });
  value.by_default = target;
  return value;
}

std::string type_name(Dimension dimension) {
  if (dimension == Dimension::dimensionless)
    return "NUMBER";
  const std::string_view words = description(dimension);
  std::string name(words.substr(words.find(' ') + 1));
  for (char& c : name)
    c = c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::string in_small_letters(std::string text) {
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

} // namespace granum::cli
