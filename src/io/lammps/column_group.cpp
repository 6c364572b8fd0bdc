// SPDX-License-Identifier: GPL-3.0-or-later
#include "column_group.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace granum::io {

namespace {

/// c_name and k of a column c_name[k]; k = 1 for c_name; empty for another prefix or malformed
/// brackets.
struct Indexed {
  std::string name;
  std::size_t index;
};
std::optional<Indexed> indexed(const std::string& column, std::string_view prefix) {
  if (!column.starts_with(prefix))
    return std::nullopt;
  const std::size_t open = column.find('[');
  if (open == std::string::npos)
    return Indexed{column, 1};
  std::size_t index = 0;
  const char* const last = column.data() + column.size() - 1;
  const auto [end, error] = std::from_chars(column.data() + open + 1, last, index);
  if (!column.ends_with(']') || error != std::errc{} || end != last || index == 0)
    return std::nullopt;
  return Indexed{column.substr(0, open), index};
}

} // namespace

std::vector<ColumnGroup> column_groups(const std::vector<std::string>& columns, std::string_view prefix) {
  struct Named {
    std::string name;
    ColumnGroup at;
    bool complete = true;
  };
  std::vector<Named> found;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto column = indexed(columns[k], prefix);
    if (!column)
      continue;
    auto group =
        std::find_if(found.begin(), found.end(), [&](const Named& g) { return g.name == column->name; });
    if (group == found.end())
      group = found.insert(found.end(), {column->name, {}});
    group->complete = group->complete && column->index == group->at.size() + 1;
    group->at.push_back(k);
  }
  std::vector<ColumnGroup> groups;
  for (Named& group : found)
    if (group.complete)
      groups.push_back(std::move(group.at));
  return groups;
}

} // namespace granum::io
