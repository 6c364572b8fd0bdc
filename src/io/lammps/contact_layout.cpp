// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_layout.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "dump_file.hpp"
#include "io/packing_builder.hpp"

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
          .whole = column.three("f"),
          .normal_stiffness = column.one("kn"),
          .tangential_stiffness = column.one("kt")};
}

/// Columns with the names of the quantities themselves.
ColumnMap own_names(const std::vector<std::string>& columns) {
  ColumnMap map;
  for (const char* quantity : {"id1", "id2", "dx", "dy", "dz", "delta", "force", "fnx", "fny", "fnz", "ftx",
                               "fty", "ftz", "fx", "fy", "fz", "kn", "kt"})
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

namespace {

constexpr double within = 1e-2; // six-digit positions
constexpr std::size_t rows_asked = 5000;

/// A pair of the table, and the line of centres of its grains.
struct Pair {
  std::size_t row;
  Vec3 normal;        ///< from grain 1 to grain 2, of unit length
  double overlap = 0; ///< by the positions
};

class Values {
 public:
  Values(const UnnamedTable& table, const PackingBuilder& grains)
      : table_(table), columns_(table.computes.front()), grains_(grains) {}

  [[nodiscard]] std::size_t size() const { return columns_.size(); }
  [[nodiscard]] std::size_t column(std::size_t value) const { return columns_[value]; }
  [[nodiscard]] ColumnTriple triple(std::size_t first) const {
    return {columns_[first], columns_[first + 1], columns_[first + 2]};
  }
  [[nodiscard]] std::string span(std::size_t first, std::size_t last) const {
    return table_.columns[columns_[first]] + " to " + table_.columns[columns_[last]];
  }

  /// Whether the columns are two ids and the flag of a periodic face; stores the pairs if so.
  bool take_pairs(std::size_t first) {
    pairs_.clear();
    const std::size_t step = std::max<std::size_t>(1, table_.rows() / rows_asked);
    for (std::size_t row = 0; row < table_.rows(); row += step) {
      const auto a = grain(row, first), b = grain(row, first + 1);
      const double flag = at(row, first + 2);
      if (!a || !b || *a == *b || (flag != 0 && flag != 1))
        return false;
      if (grains_.ambiguous(*a, *b))
        continue;
      const Vec3 branch = grains_.nearest(grains_.straight(*a, *b));
      if (norm(branch) > 0)
        pairs_.push_back({row, (1 / norm(branch)) * branch, grains_.radius_sum(*a, *b) - norm(branch)});
    }
    return true;
  }

  [[nodiscard]] Vec3 vector(const Pair& pair, std::size_t first) const {
    return {at(pair.row, first), at(pair.row, first + 1), at(pair.row, first + 2)};
  }
  /// Push on grain 1 in the mean, against the normal.
  [[nodiscard]] bool pushes(std::size_t first) const {
    double along = 0, size = 0;
    for (const Pair& pair : pairs_) {
      along -= dot(vector(pair, first), pair.normal);
      size += norm(vector(pair, first));
    }
    return along >= 0 && (size == 0 || along > within * size);
  }
  /// How large the part of a vector across the normals is, or along them, over the whole.
  [[nodiscard]] double share(std::size_t first, bool across) const {
    double part = 0, size = 0;
    for (const Pair& pair : pairs_) {
      const Vec3 f = vector(pair, first);
      const double along = dot(f, pair.normal);
      part += across ? norm(f - along * pair.normal) : std::abs(along);
      size += norm(f);
    }
    return size > 0 ? part / size : 0;
  }
  [[nodiscard]] bool is_normal(std::size_t first) const {
    return pushes(first) && share(first, true) <= within;
  }
  [[nodiscard]] bool is_tangential(std::size_t first) const { return share(first, false) <= within; }
  /// Whether one vector is the sum of two others, or of one where the other is not there.
  [[nodiscard]] bool is_sum(std::size_t whole, std::size_t normal, std::size_t tangential) const {
    double off = 0, size = 0;
    for (const Pair& pair : pairs_) {
      off += norm(vector(pair, whole) - vector(pair, normal) - vector(pair, tangential));
      size += norm(vector(pair, whole));
    }
    return off <= within * size;
  }
  /// The column after `first` with the overlaps.
  [[nodiscard]] std::optional<std::size_t> overlap_from(std::size_t first) const {
    for (std::size_t value = first; value < size(); ++value) {
      double off = 0, sum = 0;
      for (const Pair& pair : pairs_) {
        off += std::abs(at(pair.row, value) - pair.overlap);
        sum += std::abs(pair.overlap);
      }
      if (sum > 0 && off <= within * sum)
        return value;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] double at(std::size_t row, std::size_t value) const {
    return table_.at(row, columns_[value]);
  }
  [[nodiscard]] std::optional<std::uint32_t> grain(std::size_t row, std::size_t value) const {
    constexpr double largest = 1e15;
    const double id = at(row, value);
    if (!(std::abs(id) <= largest) || id != std::floor(id))
      return std::nullopt;
    return grains_.find(static_cast<long>(id));
  }

  const UnnamedTable& table_;
  const ColumnGroup& columns_;
  const PackingBuilder& grains_;
  std::vector<Pair> pairs_;
};

/// Sets the forces in the columns from `first` on.
/// \return   their description; empty if there are none
std::string take_forces(const Values& values, std::size_t first, ContactLayout& layout) {
  const std::size_t second = first + 3, third = first + 6;
  const auto there = [&](std::size_t at) { return at + 3 <= values.size(); };
  if (there(third) && values.is_normal(second) && values.is_tangential(third) &&
      values.is_sum(first, second, third)) {
    layout.normal = values.triple(second);
    layout.tangential = values.triple(third);
    return " force force_normal force_tangential";
  }
  if (there(second) && values.is_normal(first) && values.is_tangential(second)) {
    layout.normal = values.triple(first);
    layout.tangential = values.triple(second);
    return " force_normal force_tangential";
  }
  if (!there(first) || !values.pushes(first))
    return "";
  if (values.is_normal(first)) {
    layout.normal = values.triple(first);
    return " force_normal";
  }
  layout.whole = values.triple(first);
  return " force";
}

} // namespace

IdentifiedLayout liggghts_by_values(const UnnamedTable& table, const PackingBuilder& grains) {
  Values values(table, grains);
  for (const std::size_t first : {std::size_t{0}, std::size_t{6}, std::size_t{12}}) {
    constexpr std::size_t ids = 3;
    if (first + ids > values.size() || !values.take_pairs(first))
      continue;
    ContactLayout layout;
    layout.id1 = values.column(first);
    layout.id2 = values.column(first + 1);
    layout.periodic = values.column(first + 2);
    if (first > 0) {
      layout.first = values.triple(0);
      layout.second = values.triple(3);
    }
    const std::string forces = take_forces(values, first + ids, layout);
    if (forces.empty())
      continue;
    if (const auto overlap = values.overlap_from(first + ids + 3))
      layout.overlap = values.column(*overlap);
    return {layout,
            values.span(0, values.size() - 1) + " as " + (first > 0 ? "pos " : "") +
                (first > 6 ? "vel " : "") + "id" + forces + (layout.overlap ? " ... delta" : "") +
                " of LIGGGHTS' compute pair/gran/local",
            false};
  }
  grains.fail_contact(
      table.lines.front(),
      "no columns of ids and forces as in LIGGGHTS' compute pair/gran/local (pos vel id force "
      "force_normal force_tangential ...) agree with the positions of the grains; name the columns "
      "with a column map, such as " +
          example_map(table.columns));
}

} // namespace granum::io
