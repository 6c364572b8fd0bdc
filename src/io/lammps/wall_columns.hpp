// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "column_group.hpp"
#include "dump_file.hpp"
#include "io/packing_builder.hpp"

namespace granum::io {

/// A grain at a wall, as `fix wall/gran ... contacts` of LAMMPS states it.
struct WallRow {
  long id = 0;
  std::size_t wall = 0; ///< number of the fix among those of the dump
  double mark = 0;      ///< 1, or the id of the grain in older versions
  Vec3 force{};         ///< of the wall on the grain
  Vec3 point{};         ///< on the wall
  double radius = 0;
  std::size_t line = 0;
};

/// Groups of columns f_name[1] ... f_name[8] or more, which fixes of walls write.
[[nodiscard]] std::vector<ColumnGroup> wall_columns(const std::vector<std::string>& columns);

/// Appends the contact with each wall that the grain of a row touches, from the columns of walls.
/// \throws   FileError for text where a number should be
void read_walls(const TextRow& row, long id, std::size_t line, const std::vector<ColumnGroup>& walls,
                std::vector<WallRow>& out);

/// Adds the contacts of those fixes whose rows agree with the grains: the radius is the grain's, the point
/// lies within it and the mark is 1 or its id. Columns of other fixes are passed over.
/// \throws   FileError as PackingBuilder::add_wall
void join_walls(PackingBuilder& builder, const std::vector<WallRow>& rows, const DumpUnits& units);

} // namespace granum::io
