// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_columns.hpp"

#include <algorithm>
#include <cmath>

namespace granum::io {

namespace {

constexpr std::size_t width = 8;

/// Whether a row belongs to the contact of a wall with its grain, within 0.01 for radii and points of six
/// digits.
bool is_of_wall(const WallRow& row, const PackingBuilder& builder, double unit) {
  constexpr double few_digits = 1e-2;
  const auto grain = builder.find(row.id);
  if (!grain || (row.mark != 1 && row.mark != static_cast<double>(row.id)))
    return false;
  const double radius = builder.radius(*grain);
  const double distance = norm(builder.nearest(unit * row.point - builder.position(*grain)));
  return std::abs(unit * row.radius - radius) <= few_digits * radius && distance > 0 &&
         distance <= (1 + few_digits) * radius;
}

PairRow contact_of(const WallRow& row, const PackingBuilder& builder, const DumpUnits& units) {
  PairRow contact{.a = builder.index(row.id, row.line), .line = row.line};
  contact.branch = builder.nearest(units.length * row.point - builder.position(contact.a));
  const double distance = norm(contact.branch);
  const Vec3 n = (1 / distance) * contact.branch, on_wall = -units.force * row.force;
  contact.overlap = builder.radius(contact.a) - distance;
  contact.normal_force = dot(on_wall, n);
  contact.tangential_force = on_wall + -contact.normal_force * n;
  return contact;
}

} // namespace

std::vector<ColumnGroup> wall_columns(const std::vector<std::string>& columns) {
  std::vector<ColumnGroup> groups = column_groups(columns, "f_");
  std::erase_if(groups, [](const ColumnGroup& group) { return group.size() < width; });
  return groups;
}

void read_walls(const TextRow& row, long id, std::size_t line, const std::vector<ColumnGroup>& walls,
                std::vector<WallRow>& out) {
  for (std::size_t wall = 0; wall < walls.size(); ++wall) {
    const auto value = [&](std::size_t k) { return row.number(walls[wall][k], "value of a fix"); };
    const double mark = value(0);
    if (mark != 0)
      out.push_back({.id = id,
                     .wall = wall,
                     .mark = mark,
                     .force = {value(1), value(2), value(3)},
                     .point = {value(4), value(5), value(6)},
                     .radius = value(7),
                     .line = line});
  }
}

void join_walls(PackingBuilder& builder, const std::vector<WallRow>& rows, const DumpUnits& units) {
  std::vector<bool> other; // fixes that are no walls
  for (const WallRow& row : rows) {
    other.resize(std::max(other.size(), row.wall + 1));
    other[row.wall] = other[row.wall] || !is_of_wall(row, builder, units.length);
  }
  for (const WallRow& row : rows)
    if (!other[row.wall])
      builder.add_wall(contact_of(row, builder, units), static_cast<long>(row.wall));
}

} // namespace granum::io
