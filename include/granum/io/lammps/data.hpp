// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include <granum/io/imported_packing.hpp>
#include <granum/io/text/source.hpp>

namespace granum::io {

/// The grains of a LAMMPS data file (write_data), atom style sphere: diameters, upright or tilted box. The
/// step is the one that the first line names. Not in such a file, and so noted: contacts, which faces are
/// periodic (all are assumed to be), units, contact law.
/// \throws   FileError with path and line for text that is no data file, another atom style, a box or count
///           that is missing, rows too few or too many, fields that are not numbers, repeated ids, a
///           diameter that is not positive
/// Checked by tests/io/lammps/test_data.cpp
[[nodiscard]] ImportedPacking read_lammps_data(TextSource source);

/// The grains as a data file that LAMMPS reads with atom style sphere: one atom type, all digits, at rest.
/// \param    density    of the grains [kg/m^3]
/// \param    id         empty for 1, 2, ... in the order of the grains, or one positive number each
/// \throws   InvalidArgument as require_valid(Assembly); for a cell that is not LAMMPS's (first edge along x,
///           second in the xy plane), a density that is not positive, ids that do not fit
/// Checked by tests/io/lammps/test_data.cpp
[[nodiscard]] std::string lammps_data(const packing::Assembly& assembly, double density,
                                      std::span<const long> id = {});

} // namespace granum::io
