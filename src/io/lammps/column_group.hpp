// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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

} // namespace granum::io
