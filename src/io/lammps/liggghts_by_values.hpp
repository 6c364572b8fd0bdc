// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "layout_by_values.hpp"

namespace granum::io {

/// Identifies the columns of one LIGGGHTS `compute pair/gran/local` with any options: the code writes
/// pos, vel, id, force, force_normal, force_tangential, ... in this order. Ids are grains of the packing
/// beside a flag of 0 or 1; forces are vectors whose directions agree with the positions.
/// Assumes   one compute, and rows
/// \throws   FileError at the first row if no order fits
/// Checked by tests/io/lammps/test_liggghts_by_values.cpp
[[nodiscard]] IdentifiedLayout liggghts_by_values(const UnnamedTable& table, const PackingBuilder& grains);

} // namespace granum::io
