// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

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
using ColumnMap = std::map<std::string, std::string, std::less<>>;

/// Reads "id1=c_cl[1],id2=c_cl[2],...", blanks around names allowed.
/// \throws   InvalidArgument for a quantity that is not one of the above, one given twice, or text that is no
///           list of quantity=column
/// Checked by tests/io/lammps/test_column_map.cpp
[[nodiscard]] ColumnMap parse_column_map(std::string_view text);

} // namespace granum::io
