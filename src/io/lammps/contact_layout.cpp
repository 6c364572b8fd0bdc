// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_layout.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include "dump_file.hpp"

namespace granum::io {

namespace {

/// Columns of one compute, c_<name>[1], c_<name>[2], ...: positions in the row by index.
using Group = std::vector<std::size_t>;

/// The index k of a column c_name[k], and c_name; nothing for any other name.
struct Indexed {
  std::string compute;
  std::size_t index;
};
std::optional<Indexed> indexed(const std::string& column) {
  const std::size_t open = column.find('[');
  if (!column.starts_with("c_") || open == std::string::npos || !column.ends_with(']'))
    return std::nullopt;
  std::size_t index = 0;
  const char* const last = column.data() + column.size() - 1;
  const auto [end, error] = std::from_chars(column.data() + open + 1, last, index);
  if (error != std::errc{} || end != last || index == 0)
    return std::nullopt;
  return Indexed{column.substr(0, open), index};
}

/// The computes of a table whose columns stand there from 1 on, each once.
std::vector<Group> groups(const std::vector<std::string>& columns) {
  std::vector<std::pair<std::string, Group>> found;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto column = indexed(columns[k]);
    if (!column)
      continue;
    if (found.empty() || found.back().first != column->compute)
      found.emplace_back(column->compute, Group{});
    if (column->index != found.back().second.size() + 1)
      return {};
    found.back().second.push_back(k);
  }
  std::vector<Group> result;
  for (auto& [name, group] : found)
    result.push_back(std::move(group));
  return result;
}

/// Values `first`, `first` + 1, `first` + 2 of a compute, counted from 1 as the codes do.
ColumnTriple triple(const Group& group, std::size_t first) {
  return {group[first - 1], group[first], group[first + 1]};
}

ContactLayout liggghts_layout(const Group& values) {
  return {.id1 = values[6],
          .id2 = values[7],
          .difference = {},
          .first = triple(values, 1),
          .second = triple(values, 4),
          .periodic = values[8],
          .overlap = values[24],
          .force = {},
          .normal = triple(values, 13),
          .tangential = triple(values, 16),
          .whole = {}};
}

ContactLayout lammps_layout(const Group& atoms, const Group& pair) {
  ContactLayout layout{.id1 = atoms[0],
                       .id2 = atoms[1],
                       .difference = {},
                       .first = {},
                       .second = {},
                       .periodic = {},
                       .overlap = {},
                       .force = pair[1],
                       .normal = triple(pair, 3),
                       .tangential = triple(pair, 6),
                       .whole = {}};
  if (pair.size() == 17)
    layout.difference = triple(pair, 15);
  return layout;
}

std::optional<ContactLayout> known_layout(const std::vector<std::string>& columns) {
  const std::vector<Group> computes = groups(columns);
  if (computes.size() == 1 && computes[0].size() == 28)
    return liggghts_layout(computes[0]);
  if (computes.size() != 2)
    return std::nullopt;
  for (const std::size_t pair : {std::size_t{0}, std::size_t{1}}) {
    const Group& values = computes[pair];
    const Group& atoms = computes[1 - pair];
    if ((values.size() == 17 || values.size() == 8) && atoms.size() >= 2 && atoms.size() <= 6)
      return lammps_layout(atoms, values);
  }
  return std::nullopt;
}

/// Looks columns up by the quantity that the map gives them.
class MappedColumns {
 public:
  MappedColumns(const std::vector<std::string>& columns, const ColumnMap& map, const TextSource& source)
      : columns_(columns), map_(map), source_(source) {}

  [[nodiscard]] std::optional<std::size_t> one(std::string_view quantity) const {
    const auto entry = map_.find(quantity);
    if (entry == map_.end())
      return std::nullopt;
    const auto column = find_column(columns_, entry->second);
    if (!column)
      source_.fail("expected a column " + shown(entry->second) + " for " + std::string(quantity));
    return column;
  }
  [[nodiscard]] std::size_t needed(std::string_view quantity) const {
    const auto column = one(quantity);
    if (!column)
      source_.fail("the column map gives no column for " + std::string(quantity));
    return *column;
  }
  /// All three of a vector, or none.
  [[nodiscard]] std::optional<ColumnTriple> three(const std::string& stem) const {
    const auto given = [&](char axis) { return map_.contains(stem + axis); };
    if (!given('x') && !given('y') && !given('z'))
      return std::nullopt;
    return ColumnTriple{needed(stem + 'x'), needed(stem + 'y'), needed(stem + 'z')};
  }

 private:
  const std::vector<std::string>& columns_;
  const ColumnMap& map_;
  const TextSource& source_;
};

ContactLayout mapped_layout(const MappedColumns& column) {
  return {.id1 = column.needed("id1"),
          .id2 = column.needed("id2"),
          .difference = column.three("d"),
          .first = {},
          .second = {},
          .periodic = {},
          .overlap = column.one("delta"),
          .force = column.one("force"),
          .normal = column.three("fn"),
          .tangential = column.three("ft"),
          .whole = column.three("f")};
}

/// Columns that bear the names of the quantities themselves.
ColumnMap own_names(const std::vector<std::string>& columns) {
  ColumnMap map;
  for (const char* quantity : {"id1", "id2", "dx", "dy", "dz", "delta", "force", "fnx", "fny", "fnz", "ftx",
                               "fty", "ftz", "fx", "fy", "fz"})
    if (find_column(columns, quantity))
      map.emplace(quantity, quantity);
  return map;
}

} // namespace

ContactLayout contact_layout(const std::vector<std::string>& columns, const ColumnMap& map,
                             const TextSource& source) {
  if (map.contains("id1") || map.contains("id2"))
    return mapped_layout(MappedColumns(columns, map, source));
  if (const auto layout = known_layout(columns))
    return *layout;
  const ColumnMap own = own_names(columns);
  if (own.contains("id1") && own.contains("id2"))
    return mapped_layout(MappedColumns(columns, own, source));
  source.fail("the columns have no known layout; say what they hold with a column map, such as "
              "id1=c_cl[1],id2=c_cl[2],force=c_cp[2]");
}

} // namespace granum::io
