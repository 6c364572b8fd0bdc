// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include <granum/io/imported_packing.hpp>
#include <granum/io/output_file.hpp>

/// Packings as HDF5, for h5dump, h5py and whoever else reads it. The component granum::hdf5, which is there
/// if granum was configured with GRANUM_HDF5=ON and HDF5's C library (Debian: libhdf5-dev).
///
/// The attributes `format`, "granum packing", and `signs` stand at the root. Every data set has the
/// attributes `unit` ("m", "N", "N/m", "s", "1") and `meaning`. One row a grain, a contact, an edge of the
/// cell:
///   /cell [3][3], its edges; /periodic [3]; /step [1]; /time [0 or 1]
///   /grains/id, position [][3], radius
///   /contacts/i, j, branch [][3], overlap, normal_force, tangential_force [][3], normal_stiffness,
///       tangential_stiffness, sliding; i and j are rows of /grains, everything points from i to j
///   /wall_contacts, the same; j is the wall's number
/// Assumes   one thread at a time: Debian's HDF5 is no thread-safe one.
/// Checked by tests/hdf5/test_packing_hdf5.cpp, and tests/hdf5/check_packing.py with h5py
namespace granum::io {

/// Writes all of a packing but its notes, to the bit, whole or not at all.
/// \throws   InvalidArgument as require_valid(Assembly), or for another number of ids than grains; FileError
///           as write_file
void write_packing_hdf5(const std::filesystem::path& path, const ImportedPacking& packing, Existing existing);

/// Reads it back to the bit. Not in such a file, and so noted: contact law, loading history.
/// Assumes   a file that can be trusted: HDF5 itself does not stand every damage.
/// \throws   FileError with path and data set for what is no such file, data sets that are missing, of
///           another shape or unit, ids or contacts out of order, and what require_valid refuses
[[nodiscard]] ImportedPacking read_packing_hdf5(const std::filesystem::path& path);

} // namespace granum::io
