// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "contact_layout.hpp"

namespace granum::io {

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

} // namespace granum::io
