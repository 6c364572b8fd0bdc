// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/value.hpp>

#include <algorithm>
#include <cstdlib>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/csv/columns.hpp>
#include <granum/plot/page.hpp>

namespace granum::io {

namespace {

/// Blanks on one side make the text as wide as the column.
std::string padded(std::string text, int width) {
  const auto wide = static_cast<std::size_t>(std::abs(width));
  text.insert(width < 0 ? text.size() : 0, wide - std::min(wide, text.size()), ' ');
  return text;
}

std::string number_text(const ShownColumn& column, double number) {
  if (column.dimension)
    return pretty(number, *column.dimension);
  const char* format = column.fixed ? (column.sign ? "%+.*f" : "%.*f") : (column.sign ? "%+.*g" : "%.*g");
  return detail::formatted(format, column.digits, number / column.unit);
}

} // namespace

std::optional<double> number_of(const Value& value) {
  return std::visit(
      [](const auto& one) -> std::optional<double> {
        using One = std::decay_t<decltype(one)>;
        if constexpr (std::is_arithmetic_v<One>)
          return static_cast<double>(one);
        else if constexpr (std::same_as<One, Measured>)
          return one.value;
        else
          return std::nullopt;
      },
      value);
}

std::string shown_text(const ShownColumn& column, const Value& value, const char* sign) {
  const std::string text = std::visit(
      [&](const auto& one) -> std::string {
        using One = std::decay_t<decltype(one)>;
        if constexpr (std::same_as<One, std::monostate> || std::same_as<One, std::nullptr_t>)
          return column.absent;
        else if constexpr (std::same_as<One, double>)
          return number_text(column, one);
        else if constexpr (std::same_as<One, bool>)
          return one ? "yes" : "no";
        else if constexpr (std::integral<One>)
          return std::to_string(one);
        else if constexpr (std::same_as<One, std::string>)
          return one;
        else if constexpr (std::same_as<One, Measured>)
          return number_text(column, one.value) + sign +
                 detail::formatted(column.fixed ? "%.*f" : "%.*g", column.fixed ? column.digits : 2,
                                   one.standard_error / column.unit);
        else {
          std::string all;
          for (const auto& each : one)
            all += (all.empty() ? "" : " ") + shown_text(column, each, sign);
          return all;
        }
      },
      value);
  return is_nothing(value) || value.index() > 7 ? text : text + column.symbol;
}

std::string heading_text(const ShownColumn& column) { return padded(column.heading, column.width); }

std::string cell_text(const ShownColumn& column, const Value& value) {
  const std::string text = shown_text(column, value, screen_sign);
  const bool fills = column.width > 0 && text.size() >= static_cast<std::size_t>(column.width);
  return (fills ? " " : "") + padded(text, column.width) +
         (column.width < 0 && text.size() >= static_cast<std::size_t>(-column.width) ? " " : "");
}

std::string list_line(const ShownColumn& column, const Value& value, int label_width) {
  constexpr int value_width = 22;
  std::string text = shown_text(column, value, screen_sign);
  if (const auto* measured = std::get_if<Measured>(&value))
    text = number_text(column, measured->value) + " +- " +
           detail::formatted("%.2g", measured->standard_error / column.unit) + column.symbol;
  std::string line =
      "  " + padded(column.heading, -label_width) + " " + padded(text, -value_width) + " " + column.meaning;
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

void add_cell(std::vector<CsvCell>& to, const Value& value, bool has_error) {
  if (const auto* measured = std::get_if<Measured>(&value)) {
    to.insert(to.end(), {measured->value, measured->standard_error});
    return;
  }
  to.push_back(std::visit(
      [](const auto& one) -> CsvCell {
        using One = std::decay_t<decltype(one)>;
        if constexpr (std::same_as<One, std::string>)
          return one;
        else if constexpr (std::is_arithmetic_v<One>)
          return static_cast<double>(one);
        else if constexpr (std::same_as<One, std::monostate> || std::same_as<One, std::nullptr_t>)
          return empty_cell;
        else
          throw InvalidArgument("a list of numbers cannot be a cell of a table");
      },
      value));
  if (has_error)
    to.emplace_back(empty_cell);
}

std::string page_table(const std::vector<ShownColumn>& columns, const std::vector<std::vector<Value>>& rows) {
  std::vector<std::string> headings;
  for (const ShownColumn& column : columns)
    headings.push_back(column.heading);
  std::vector<std::vector<std::string>> texts(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t c = 0; c < columns.size(); ++c)
      texts[k].push_back(shown_text(columns[c], rows[k].at(c), page_sign));
  return plot::html_table(headings, texts);
}

} // namespace granum::io
