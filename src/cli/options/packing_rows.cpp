// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_rows.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/sizes/distribution_text.hpp>

namespace granum::cli {

namespace {

/// "--void-ratio" as void_ratio.
std::string heading_of(const Number& number) {
  std::string name = number.name.substr(2);
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
  const estimate::InputRow& row = estimate::row_of(input);
  return names_of_column(row.symbols, row.key);
}

NumberColumns::NumberColumns(const io::CsvTable& table)
    : table_(table), read_(table.headings().size(), false), options_(table.headings().size()) {}

bool NumberColumns::bind(Number& number) {
  const auto& headings = table_.headings();
  std::optional<io::CsvTable::Place> found;
  for (const std::string& name : names_of_column(number.symbols, heading_of(number))) {
    if (!table_.has(name))
      continue;
    const io::CsvTable::Place column = table_.column(name, number.dimension);
    if (found && found->index != column.index)
      throw FileError(table_.name(), table_.heading_line(),
                      fmt::format("columns {} and {}, '{}' and '{}', both contain {}", found->index + 1,
                                  column.index + 1, headings[found->index], headings[column.index],
                                  heading_of(number)));
    found = column;
  }
  if (!found)
    return false;
  refuse_twice(number.given(), number.name, headings[found->index]);
  number.per_cent = number.dimension == Dimension::dimensionless && found->factor != 1;
  inputs_.push_back({&number, *found, number.value});
  read(found->index, number.name);
  return true;
}

std::optional<std::size_t> NumberColumns::text(const std::string& heading, bool option_given) {
  const auto& headings = table_.headings();
  const std::vector<std::string> forms = written_forms(heading);
  const auto found = std::find_if(headings.begin(), headings.end(), [&](const std::string& one) {
    return std::find(forms.begin(), forms.end(), one) != forms.end();
  });
  if (found == headings.end())
    return std::nullopt;
  const std::string option = option_of(heading);
  refuse_twice(option_given, option, *found);
  const auto index = static_cast<std::size_t>(found - headings.begin());
  read(index, option);
  return index;
}

void NumberColumns::take(std::size_t row) const {
  const auto& fields = table_.fields(row);
  for (const auto& [number, column, by_default] : inputs_) {
    const std::string& field = fields[column.index];
    number->in_table = !trimmed(field).empty();
    if (!number->in_table) {
      number->value = by_default;
      continue;
    }
    std::string text(trimmed(field));
    double share = 1;
    if (number->dimension == Dimension::dimensionless && text.ends_with('%')) {
      text.pop_back();
      share = number->per_cent ? 1 : 0.01; // the sign in the cell repeats that of the heading
    }
    auto value = parse_number(trimmed(text));
    if (value)
      *value *= share;
    if (!value || !std::isfinite(*value * column.factor))
      throw InvalidArgument(fmt::format("expected a finite number in column '{}', found '{}'",
                                        table_.headings()[column.index], field));
    number->value = *value * column.factor;
  }
}

void NumberColumns::read(std::size_t column, const std::string& option) {
  read_[column] = true;
  options_[column] = option;
}

std::optional<std::string> NumberColumns::heading(std::string_view option) const {
  const auto found = std::find(options_.begin(), options_.end(), option);
  if (found == options_.end())
    return std::nullopt;
  return table_.headings()[static_cast<std::size_t>(found - options_.begin())];
}

std::vector<std::string> NumberColumns::unread() const {
  std::vector<std::string> headings;
  for (std::size_t k = 0; k < read_.size(); ++k)
    if (!read_[k])
      headings.push_back(table_.headings()[k]);
  return headings;
}

PackingRows::PackingRows(const io::CsvTable& table, const PackingOptions& options)
    : table_(table), row_(options), contact_by_default_(options.contact), columns_(table) {
  for (Number* number : numbers(row_)) {
    const bool is_given = columns_.bind(*number) || number->given();
    const bool stress = number == &row_.pressure || number == &row_.stress_v || number == &row_.stress_h;
    tells_stress_ = tells_stress_ || (stress && is_given);
  }
  contact_ = columns_.text("contact", row_.contact_given());
  sizes_ = columns_.text("sizes", row_.sizes.has_value());
  uniformity_ = {0, Dimension::dimensionless, "C_u Cu", "--uniformity"};
  uniformity_.preset = row_.sizes.has_value();
  sizes_in_table_ = columns_.bind(uniformity_) || sizes_;
}

const PackingOptions& PackingRows::packing(std::size_t row) {
  const auto& fields = table_.fields(row);
  columns_.take(row);
  const std::string text(contact_ ? trimmed(fields[*contact_]) : "");
  row_.contact_in_table = !text.empty();
  row_.contact = contact_by_default_;
  if (row_.contact_in_table) {
    const std::optional<contact::Shape> shape = contact::find_shape(text);
    if (!shape)
      throw InvalidArgument(fmt::format("contact '{}' is not one of {}", text, contact::shape_names()));
    row_.contact = *shape;
  }
  take_sizes(fields);
  return row_;
}

/// Equal grains if the row has no sizes.
void PackingRows::take_sizes(const std::vector<std::string>& fields) {
  const bool is_given = sizes_ && !trimmed(fields[*sizes_]).empty();
  if (is_given && uniformity_.in_table)
    throw InvalidArgument("sizes and uniformity are alternatives: give one of them");
  if (sizes_in_table_) {
    row_.graded = uniformity_.in_table;
    row_.uniformity = uniformity_.in_table ? std::optional(uniformity_.value) : std::nullopt;
  }
  if (is_given)
    row_.sizes = sizes::parse_distribution(fields[*sizes_]);
  else if (uniformity_.in_table)
    row_.sizes = sizes::Distribution::uniformity(uniformity_.value);
  else if (sizes_in_table_)
    row_.sizes.reset();
}

} // namespace granum::cli
