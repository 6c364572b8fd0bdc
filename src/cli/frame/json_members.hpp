// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/io/csv/columns.hpp>
#include <nlohmann/json.hpp>

namespace granum::cli {

/// A value with its error is an object of both; an empty value is null.
[[nodiscard]] inline nlohmann::ordered_json json_of(const io::Value& value) {
  return std::visit(
      [](const auto& one) -> nlohmann::ordered_json {
        using One = std::decay_t<decltype(one)>;
        if constexpr (std::same_as<One, std::monostate>)
          return nullptr;
        else if constexpr (std::same_as<One, Measured>)
          return {{"value", one.value}, {"standard_error", one.standard_error}};
        else
          return one;
      },
      value);
}

/// The values of a row as members of an object, each with the key of its column; empty ones are left out.
template <class Row>
void put_members(nlohmann::ordered_json& object, const io::Columns<Row>& columns, const Row& row) {
  for (const io::Column<Row>& column : columns)
    if (!column.key.empty())
      if (const io::Value value = column.of(row); value.index() != 0)
        object[nlohmann::ordered_json::json_pointer("/" + column.key)] = json_of(value);
}

template <class Row>
[[nodiscard]] nlohmann::ordered_json members(const io::Columns<Row>& columns, const Row& row) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  put_members(object, columns, row);
  return object;
}

/// An object for each row.
template <class Row>
[[nodiscard]] nlohmann::ordered_json members_of_all(const io::Columns<Row>& columns,
                                                    const std::vector<Row>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows)
    list.push_back(members(columns, row));
  return list;
}

} // namespace granum::cli
