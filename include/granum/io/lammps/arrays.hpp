// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/io/imported_packing.hpp>

namespace granum::io {

/// Columns of quantities in a dump: quantity -> name of the column. Quantities of grains:
///   id, radius or diameter, x y z (wrapped or not), xs ys zs (fractions of the box)
/// of contacts between grain 1 and grain 2, forces those on grain 1:
///   id1 id2            required
///   dx dy dz           centre of 1 minus centre of 2
///   delta              overlap
///   force              normal force, repulsion positive
///   fnx fny fnz        normal force vector
///   ftx fty ftz        tangential force vector
///   fx fy fz           whole force vector
///   kn kt              stiffnesses, both or none
/// of grains also body, the number of the rigid body; "none" as the column of body or shape means that the
/// grains are of no bodies, and spheres.
///
/// Reads "id1=c_cl[1],id2=c_cl[2],...", blanks around names allowed.
/// \throws   InvalidArgument for a quantity that is not one of the above, one given twice, or text that is no
///           list of quantity=column
/// Checked by tests/io/lammps/test_arrays.cpp
[[nodiscard]] ColumnMap parse_column_map(std::string_view text);

/// \file
/// Packings from the memory of LAMMPS, from a linked program or a script.
/// Checked by tests/io/lammps/test_arrays.cpp and, with LAMMPS itself, by tests/peer/lammps/hand_over.py

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
