// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_layout.hpp"

#include <algorithm>
#include <charconv>

#include "dump_file.hpp"

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

/// Values `first`, `first` + 1, `first` + 2 of a compute, counted from 1 as the codes do.
ColumnTriple triple(const ColumnGroup& group, std::size_t first) {
  return {group[first - 1], group[first], group[first + 1]};
}

ContactLayout liggghts_layout(const ColumnGroup& values) {
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

ContactLayout lammps_layout(const ColumnGroup& atoms, const ColumnGroup& pair) {
  return {.id1 = atoms[0],
          .id2 = atoms[1],
          .difference = triple(pair, 15),
          .first = {},
          .second = {},
          .periodic = {},
          .overlap = {},
          .force = pair[1],
          .normal = triple(pair, 3),
          .tangential = triple(pair, 6),
          .whole = {},
          .rolling = pair[12],
          .twisting = pair[13]};
}

std::optional<ContactLayout> known_layout(const std::vector<ColumnGroup>& computes) {
  if (computes.size() == 1 && computes[0].size() == 28)
    return liggghts_layout(computes[0]);
  if (computes.size() != 2)
    return std::nullopt;
  for (const std::size_t pair : {std::size_t{0}, std::size_t{1}}) {
    const ColumnGroup& values = computes[pair];
    const ColumnGroup& atoms = computes[1 - pair];
    if (values.size() == 17 && can_hold_ids(atoms))
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

/// Columns with the names of the quantities themselves.
ColumnMap own_names(const std::vector<std::string>& columns) {
  ColumnMap map;
  for (const char* quantity : {"id1", "id2", "dx", "dy", "dz", "delta", "force", "fnx", "fny", "fnz", "ftx",
                               "fty", "ftz", "fx", "fy", "fz"})
    if (find_column(columns, quantity))
      map.emplace(quantity, quantity);
  return map;
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

std::optional<ContactLayout> contact_layout(const std::vector<std::string>& columns, const ColumnMap& map,
                                            const TextSource& source) {
  if (map.contains("id1") || map.contains("id2"))
    return mapped_layout(MappedColumns(columns, map, source));
  const std::vector<ColumnGroup> computes = column_groups(columns, "c_");
  if (const auto layout = known_layout(computes))
    return layout;
  const ColumnMap own = own_names(columns);
  if (own.contains("id1") && own.contains("id2"))
    return mapped_layout(MappedColumns(columns, own, source));
  constexpr std::size_t fewest = 6; // id force of LIGGGHTS
  if (computes.size() == 1 && computes[0].size() >= fewest)
    return std::nullopt;
  if (computes.size() > 1 && std::any_of(computes.begin(), computes.end(), can_hold_ids))
    return std::nullopt;
  source.fail("the columns have no known layout; name them with a column map, such as " +
              example_map(columns));
}

std::string example_map(const std::vector<std::string>& columns) {
  const std::vector<ColumnGroup> computes = column_groups(columns, "c_");
  const auto of = [&](std::string_view quantity, std::size_t column) {
    return std::string(quantity) + "=" + columns[column];
  };
  constexpr std::size_t with_positions = 12, ids_and_force = 6;
  for (const ColumnGroup& values : computes) { // LIGGGHTS: pos id force, or id force
    const std::size_t first = values.size() >= with_positions ? 6 : 0;
    if (computes.size() == 1 && values.size() >= first + ids_and_force)
      return of("id1", values[first]) + "," + of("id2", values[first + 1]) + "," +
             of("fx", values[first + 3]) + "," + of("fy", values[first + 4]) + "," +
             of("fz", values[first + 5]);
  }
  const auto ids = std::find_if(computes.begin(), computes.end(), can_hold_ids);
  for (const ColumnGroup& values : computes)
    if (ids != computes.end() && &values != &*ids && values.size() > 1)
      return of("id1", (*ids)[0]) + "," + of("id2", (*ids)[1]) + "," + of("force", values[1]);
  return "id1=c_cl[1],id2=c_cl[2],force=c_cp[2], names as in the heading";
}

} // namespace granum::io
