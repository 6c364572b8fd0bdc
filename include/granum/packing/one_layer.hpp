// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// Refuses a packing in two dimensions: ten grains or more whose centres, and lines of centres of all
/// contacts, lie in one plane across x, y or z, and not on one line. Its volume has no meaning, and nothing
/// holds it in its plane. A lattice one layer thick whose grains touch their images is in space: without
/// contacts, where 80 to 100 % of a diameter fit into the cell.
/// \throws   InvalidArgument
/// Checked by tests/packing/test_one_layer.cpp
void require_space(const Assembly& assembly);

} // namespace granum::packing
