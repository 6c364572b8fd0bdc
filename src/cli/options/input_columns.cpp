// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_columns.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::cli {

namespace {

using estimate::Belongs;
using estimate::Input;
using estimate::InputRow;
using estimate::InputValues;

/// "--void-ratio" as void_ratio.
std::string heading_of(const std::string& option) {
  std::string name = option.substr(2);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Usual spellings of "void_ratio": "void ratio", "Void ratio", "Void Ratio", "Void_ratio".
std::vector<std::string> written_forms(const std::string& name) {
  std::string words = name;
  std::replace(words.begin(), words.end(), '_', ' ');
  const auto upper = [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); };
  std::string each = words;
  for (std::size_t k = 0; k < each.size(); ++k)
    if (k == 0 || each[k - 1] == ' ')
      each[k] = upper(each[k]);
  std::vector<std::string> forms{name, words, upper(name[0]) + name.substr(1),
                                 upper(words[0]) + words.substr(1), each};
  std::sort(forms.begin(), forms.end());
  forms.erase(std::unique(forms.begin(), forms.end()), forms.end());
  return forms;
}

void refuse_twice(bool option_given, const std::string& option, const std::string& heading) {
  if (option_given)
    throw InvalidArgument(fmt::format("{} is given as an option and by the column '{}'", option, heading));
}

} // namespace

std::vector<std::string> names_of_column(std::string_view symbols, const std::string& option) {
  std::vector<std::string> names = words_of(symbols);
  for (std::string& name : written_forms(option))
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
  return names;
}

std::vector<std::string> names_of_column(Input input) {
  const InputRow& row = estimate::row_of(input);
  return names_of_column(row.symbols, row.key);
}

InputColumns::InputColumns(const io::CsvTable& table, const InputValues& options)
    : table_(table), given_(options), read_(table.headings().size(), false),
      options_(table.headings().size()) {}

std::optional<io::CsvTable::Place> InputColumns::find(std::string_view symbols, const std::string& name,
                                                      Dimension dimension) const {
  const auto& headings = table_.headings();
  std::optional<io::CsvTable::Place> found;
  for (const std::string& one : names_of_column(symbols, name)) {
    if (!table_.has(one))
      continue;
    const io::CsvTable::Place column = table_.column(one, dimension);
    if (found && found->index != column.index)
      throw FileError(table_.name(), table_.heading_line(),
                      fmt::format("columns {} and {}, '{}' and '{}', both contain {}", found->index + 1,
                                  column.index + 1, headings[found->index], headings[column.index], name));
    found = column;
  }
  return found;
}

bool InputColumns::bind_number(Number* number, Input input, std::string_view symbols,
                               const std::string& option, Dimension dimension, bool option_given,
                               double by_default) {
  const std::optional<io::CsvTable::Place> place = find(symbols, heading_of(option), dimension);
  if (!place)
    return false;
  refuse_twice(option_given, option, table_.headings()[place->index]);
  numbers_.push_back(
      {number, input, *place, dimension == Dimension::dimensionless && place->factor != 1, by_default});
  read(place->index, option);
  return true;
}

bool InputColumns::bind(Number& number) {
  return bind_number(&number, {}, number.symbols, number.name, number.dimension, number.given(),
                     number.value);
}

bool InputColumns::bind(Input input) {
  const InputRow& row = estimate::row_of(input);
  if (row.kind != estimate::Kind::number)
    return bind_text(row);
  const bool sizes_given = input == Input::uniformity && given_.sizes;
  return bind_number(nullptr, input, row.symbols, row.option(), row.dimension,
                     given_.given(input) || sizes_given, 0);
}

bool InputColumns::bind_text(const InputRow& row) {
  const auto& headings = table_.headings();
  const std::vector<std::string> forms = written_forms(row.key);
  const auto found = std::find_if(headings.begin(), headings.end(), [&](const std::string& one) {
    return std::find(forms.begin(), forms.end(), one) != forms.end();
  });
  if (found == headings.end())
    return false;
  refuse_twice(given_.given(row.input) || (row.input == Input::sizes && given_.sizes), row.option(), *found);
  const auto index = static_cast<std::size_t>(found - headings.begin());
  texts_.push_back({row.input, index});
  read(index, row.option());
  return true;
}

void InputColumns::bind_packing() {
  for (const InputRow& row : estimate::inputs())
    if (row.belongs == Belongs::to_packing && row.input != Input::sieve) // which is a file
      bind(row.input);
}

void InputColumns::bind_material() {
  for (const InputRow& row : estimate::inputs())
    if (row.belongs == Belongs::to_answer && row.input != Input::preparation)
      bind(row.input);
}

bool InputColumns::gives_stress() const {
  const auto gives = [&](Input input) {
    return given_.given(input) || std::any_of(numbers_.begin(), numbers_.end(), [&](const NumberColumn& of) {
             return of.number == nullptr && of.input == input;
           });
  };
  return gives(Input::pressure) || gives(Input::stress_v) || gives(Input::stress_h);
}

InputColumns::Field InputColumns::field(const NumberColumn& column, std::size_t row) const {
  const std::string& field = table_.fields(row)[column.place.index];
  std::string text(trimmed(field));
  if (text.empty())
    return {};
  double share = 1;
  const Dimension dimension =
      column.number != nullptr ? column.number->dimension : estimate::row_of(column.input).dimension;
  if (dimension == Dimension::dimensionless && text.ends_with('%')) {
    text.pop_back();
    share = column.per_cent ? 1 : 0.01; // the sign in the cell repeats that of the heading
  }
  const auto value = parse_number(trimmed(text));
  const double number =
      value ? *value * share * column.place.factor : std::numeric_limits<double>::infinity();
  if (!std::isfinite(number))
    throw InvalidArgument(fmt::format("expected a finite number in column '{}', found '{}'",
                                      table_.headings()[column.place.index], field));
  return {number, true};
}

InputValues InputColumns::row(std::size_t row) const {
  InputValues values = given_;
  for (const NumberColumn& column : numbers_) {
    const Field cell = field(column, row);
    if (column.number != nullptr) {
      column.number->in_table = cell.given;
      column.number->value = cell.given ? cell.number : column.by_default;
      column.number->per_cent = column.per_cent;
    } else if (cell.given)
      values.give(column.input, cell.number, estimate::Source::table, column.per_cent);
  }
  for (const TextColumn& column : texts_)
    if (const std::string text(trimmed(table_.fields(row)[column.index])); !text.empty()) {
      if (column.input == Input::sizes && values.sizes)
        throw InvalidArgument("sizes and uniformity are alternatives: give one of them");
      values.give(column.input, text, estimate::Source::table);
    }
  return values;
}

void InputColumns::read(std::size_t column, const std::string& option) {
  read_[column] = true;
  options_[column] = option;
}

std::optional<std::string> InputColumns::heading(std::string_view option) const {
  const auto found = std::find(options_.begin(), options_.end(), option);
  if (found == options_.end())
    return std::nullopt;
  return table_.headings()[static_cast<std::size_t>(found - options_.begin())];
}

std::vector<std::string> InputColumns::unread() const {
  std::vector<std::string> headings;
  for (std::size_t k = 0; k < read_.size(); ++k)
    if (!read_[k])
      headings.push_back(table_.headings()[k]);
  return headings;
}

std::string unread_text(const std::vector<std::string>& headings) {
  return fmt::format("unused columns: {}", fmt::join(headings, ", "));
}

} // namespace granum::cli
