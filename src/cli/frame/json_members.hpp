// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <granum/io/csv/columns.hpp>
#include <nlohmann/json.hpp>

namespace granum::cli {

/// What stands in JSON for a number that a row does not have.
enum class Absent { left_out, null };

/// The numbers of a row as members of an object, each at the key of its column.
template <class Row>
void put_members(nlohmann::ordered_json& object, const io::Columns<Row>& columns, const Row& row,
                 Absent absent = Absent::left_out) {
  for (const io::Column<Row>& column : columns) {
    const std::optional<double> number = column.of(row);
    if (column.key.empty() || (!number && absent == Absent::left_out))
      continue;
    nlohmann::ordered_json& member = object[nlohmann::ordered_json::json_pointer("/" + column.key)];
    if (!number)
      member = nullptr;
    else if (column.kind == io::ColumnKind::count)
      member = static_cast<std::uint64_t>(*number);
    else
      member = *number;
  }
}

template <class Row>
[[nodiscard]] nlohmann::ordered_json members(const io::Columns<Row>& columns, const Row& row,
                                             Absent absent = Absent::left_out) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  put_members(object, columns, row, absent);
  return object;
}

} // namespace granum::cli
