// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <granum/io/imported_packing.hpp>
#include <granum/io/text/source.hpp>

/// Packings out of values separated by commas, semicolons, tabs or blanks: spreadsheets, tomography, exports
/// of ParaView and of codes without a reader of their own.
///
/// Headings carry units (lx_mm, fn_N); a line "# units: SI" above them, or PackingFileOptions::si, means that
/// those without are SI. ParaView's Points:0 to Points:2 are x, y, z in SI, with a note; PFC's end1, end2 are
/// id1, id2.
/// Contacts:  nx, ny, nz              needed; from grain 1 to grain 2, of any length
///            id1, id2                numbers of the grains
///            fn, ft                  normal force (compression positive) and size of the tangential force
///            fx, fy, fz              whole force exerted by grain 1 on grain 2, instead of fn and ft
///            lx, ly, lz              centre of grain 2 minus centre of grain 1
///            delta                   overlap
///            kn, kt                  stiffnesses [N/m], both or none; also k_n, k_t or ks, or
///                                    normal_stiffness, tangential_stiffness, with _N/m or without
/// Grains:    x, y, z                 needed
///            radius or diameter      needed
///            type                    of the material, an integer
///            id                      numbers from 0 in the order of the rows where it is missing
/// Checked by tests/io/csv/test_packing.cpp
namespace granum::io {

/// A list of contacts; missing columns are empty.
struct ContactTable {
  std::vector<Vec3> normal; ///< unit vectors
  std::vector<std::array<long, 2>> id;
  std::vector<double> normal_force;                           ///< [N]
  std::vector<double> tangential_size;                        ///< [N]
  std::vector<Vec3> force;                                    ///< exerted by 1 on 2 [N]
  std::vector<Vec3> branch;                                   ///< [m]
  std::vector<double> overlap;                                ///< [m]
  std::vector<double> normal_stiffness, tangential_stiffness; ///< both or none [N/m]
  std::vector<std::size_t> line;                              ///< of the file
  std::vector<std::string> unused;                            ///< headings
  std::size_t empty_rows = 0;                                 ///< of zeros alone, left out
};

/// \throws   FileError with path and line for text that is not such a table, fields that are not numbers,
///           a normal of length 0, one coordinate of a vector without the others
[[nodiscard]] ContactTable read_contact_csv(TextSource source, const PackingFileOptions& options = {});

/// Grains, and contacts if there are any. Without a box the smallest upright one is used, with a note.
/// Of contacts id1, id2 are needed. Lines of centres are lx, ly, lz, or the nearest images of the
/// positions; overlaps are delta, or come from the radii.
/// \throws   FileError also for ids twice, a radius that is not positive, a box without volume, an unknown
///            grain, a grain in contact with itself, a line of centres that does not fit the positions or
///            the normal, one pair with two forces
[[nodiscard]] ImportedPacking read_packing_csv(TextSource grains, std::optional<TextSource> contacts = {},
                                               const PackingFileOptions& options = {});

} // namespace granum::io
