// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/column_map.hpp>

#include <algorithm>
#include <array>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::io {

namespace {

constexpr std::array<std::string_view, 25> quantities{
    "id", "radius", "diameter", "x",   "y",   "z",   "xs",  "ys",  "zs",  "id1", "id2", "dx", "dy",
    "dz", "delta",  "force",    "fnx", "fny", "fnz", "ftx", "fty", "ftz", "fx",  "fy",  "fz"};

} // namespace

ColumnMap parse_column_map(std::string_view text) {
  ColumnMap map;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos)
      throw InvalidArgument("column map: expected quantity=column, found '" + std::string(item) + "'");
    const std::string_view quantity = trimmed(item.substr(0, equals));
    const std::string_view column = trimmed(item.substr(equals + 1));
    if (std::find(quantities.begin(), quantities.end(), quantity) == quantities.end())
      throw InvalidArgument("column map: '" + std::string(quantity) + "' is no quantity of a dump");
    if (column.empty())
      throw InvalidArgument("column map: no column is given for '" + std::string(quantity) + "'");
    if (!map.emplace(quantity, column).second)
      throw InvalidArgument("column map: '" + std::string(quantity) + "' is given twice");
  }
  return map;
}

} // namespace granum::io
