// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/io/imported_packing.hpp>
#include <granum/io/lammps/column_map.hpp>

/// Packings from the memory of LAMMPS, from a linked program or a script.
/// Checked by tests/io/lammps/test_arrays.cpp and, with LAMMPS itself, by tests/peer/lammps/hand_over.py
namespace granum::io {

/// Local values of computes, one row a contact, as `dump local` would write them.
struct LammpsLocals {
  std::vector<std::string> columns; ///< "c_ids[1]", "c_ids[2]", "c_forces[1]", ...
  std::span<const double> values;   ///< row after row
  ColumnMap map = {};               ///< meaning of the columns, if their values do not show it
};

/// Grains of one process, in any order, in the units that LAMMPS works in.
struct LammpsArrays {
  std::span<const long> id;
  std::span<const Vec3> position;  ///< one for each id, in the box or in an image of it
  std::span<const double> radius;  ///< one for each id, > 0
  std::span<const long> type = {}; ///< one for each id, or none
  Mat3 cell;                       ///< columns are the edges of the box
  std::array<bool, 3> periodic{true, true, true};
  std::string units = "si"; ///< si, cgs, micro, nano; lj: numbers are assumed to be SI, with a note
  long step = 0;
  std::optional<LammpsLocals> contacts = {};
};

/// The packing that `dump custom` and `dump local` of this state would be read as (LammpsDump), with the same
/// layouts of the contacts and the same checks; contacts with walls are not among them.
/// \throws   InvalidArgument naming the array and its element, as packing_of(PackingArrays); for other units,
///           for columns that no layout or several fit
[[nodiscard]] ImportedPacking lammps_packing(const LammpsArrays& arrays);

} // namespace granum::io
