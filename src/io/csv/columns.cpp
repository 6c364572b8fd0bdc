// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/columns.hpp>

#include <granum/core/error.hpp>
#include <granum/plot/page.hpp>

namespace granum::io {

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
