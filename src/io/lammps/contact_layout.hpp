// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <granum/io/lammps/arrays.hpp>
#include <granum/io/text/source.hpp>

namespace granum::io {

/// Indices of the values of one compute or fix of LAMMPS in a row of a dump.
using ColumnGroup = std::vector<std::size_t>;

/// The groups of a table: columns `c_name[1]`, `c_name[2]`, ... from 1 on without a gap, or `c_name` alone.
/// \param    prefix  "c_" for computes, "f_" for fixes
/// \return   groups with missing columns, or columns in another order, are left out
[[nodiscard]] std::vector<ColumnGroup> column_groups(const std::vector<std::string>& columns,
                                                     std::string_view prefix);

/// Whether a group can be a `compute property/local` that begins with the ids of two grains.
[[nodiscard]] inline bool can_hold_ids(const ColumnGroup& group) {
  return group.size() >= 2 && group.size() <= 6;
}

using ColumnTriple = std::array<std::size_t, 3>;

/// Indices of the quantities of a contact in its row. Forces act on grain 1.
struct ContactLayout {
  std::size_t id1 = 0, id2 = 0;
  std::optional<ColumnTriple> difference;    ///< centre of 1 minus centre of 2, nearest images
  std::optional<ColumnTriple> first, second; ///< centres, each inside the box
  std::optional<std::size_t> periodic;       ///< 1 where the pair reaches through a face
  std::optional<std::size_t> overlap;
  std::optional<std::size_t> force; ///< normal force, repulsion positive
  std::optional<ColumnTriple> normal, tangential, whole;
  std::optional<std::size_t> rolling = {}, twisting = {}; ///< magnitudes of the moments
  std::optional<std::size_t> normal_stiffness = {}, tangential_stiffness = {};

  [[nodiscard]] bool has_forces() const { return force || normal || whole; }
  [[nodiscard]] bool has_tangential() const { return tangential || whole; }
  [[nodiscard]] bool has_stiffness() const { return normal_stiffness && tangential_stiffness; }

  bool operator==(const ContactLayout&) const = default;
};

/// The layout of a map, or, for an empty map, the layout from the names of the columns:
/// the quantities' own names; `compute property/local patom1 patom2 ...` beside a `compute pair/local` of 17
/// values (dist force fx fy fz p1 ... p12); LIGGGHTS' 28 values of `compute pair/gran/local`.
/// \return   empty for other columns of computes, which need layout_by_values
/// \throws   FileError at the line of `source` for a column of the map that is not there, or unknown columns
[[nodiscard]] std::optional<ContactLayout> contact_layout(const std::vector<std::string>& columns,
                                                          const ColumnMap& map, const TextSource& source);

/// A column map for these columns, as an example in messages: that of the usual order of their code.
[[nodiscard]] std::string example_map(const std::vector<std::string>& columns);

class PackingBuilder;

/// A table of contacts as numbers, with unidentified columns.
struct UnnamedTable {
  std::vector<std::string> columns;
  std::vector<ColumnGroup> computes;
  std::vector<double> numbers; ///< row by row; 0 in columns of no compute
  std::vector<std::size_t> lines;

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return numbers[row * columns.size() + column];
  }
};

/// A layout confirmed by the values, and its description.
struct IdentifiedLayout {
  ContactLayout layout;
  std::string words;    ///< "c_cp[1] to c_cp[5] as dist force fx fy fz"
  bool swapped = false; ///< p1 p2 p3 precede fx fy fz
};

/// Identifies the values of `compute property/local patom1 patom2 ...` next to those of `compute pair/local`:
/// some of dist, dx dy dz, eng, force, fx fy fz and p1 p2 ..., in this order, and at least the distance or a
/// force. An order is accepted if the grains confirm it: dist is the distance of the centres, fx fy fz lies
/// along the line of centres as repulsion on patom1 and is as long as force, p1 p2 p3 lies across it and is
/// as long as p4, p10 p11 p12 is x1 - x2; all in the sum over the rows, within 1 %.
/// \param    length   unit of the table's lengths [m]
/// \throws   FileError at the first row if no order is confirmed, or if several are that give different
///           forces; the message lists them and the column maps that would decide
/// Checked by tests/io/lammps/test_layouts.cpp
[[nodiscard]] IdentifiedLayout layout_by_values(const UnnamedTable& table, const PackingBuilder& grains,
                                                double length);

/// Identifies the columns of one LIGGGHTS `compute pair/gran/local` with any options: the code writes
/// pos, vel, id, force, force_normal, force_tangential, ... in this order. Ids are grains of the packing
/// beside a flag of 0 or 1; forces are vectors whose directions agree with the positions.
/// Assumes   one compute, and rows
/// \throws   FileError at the first row if no order fits
/// Checked by tests/io/lammps/test_liggghts_by_values.cpp
[[nodiscard]] IdentifiedLayout liggghts_by_values(const UnnamedTable& table, const PackingBuilder& grains);

} // namespace granum::io
