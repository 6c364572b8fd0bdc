// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/io/imported_packing.hpp>
#include <granum/io/text/source.hpp>

/// Packings from YADE's files of text and for VTK.
namespace granum::io {

/// The grains of a packing of YADE, from one of
///   share/yade/granum_export.py   <name>.grains, 17 digits, with cell, step and time
///   export.text, export.textExt   six digits: good for the geometry, not for overlaps; ids are the row
///                                 numbers from 0 unless a column `id` is there, so bodies that are no
///                                 spheres shift them
/// A column `material` (the script's), `mat`, `materialId` or `type` becomes the type.
/// Without a cell the smallest upright box is used, with a note.
/// \throws   FileError with path and line for text that is none of these, rows of other length than the
///           heading, fields that are not numbers, repeated ids, a radius that is not positive, no grains
///
/// And its contacts, where there are any: rows under "# id1 id2 ..." as the script writes them to
/// <name>.contacts. normal points from id1 to id2, the forces are those on id2; the line of centres is (R1
/// + R2 - pd) normal. A negative id2 is the wall -1 - id2, the branch to it (R1 - pd) normal. kn and ks
/// become the stiffnesses where they are there. Not in the files, and so noted: contact law, history,
/// units.
/// \throws   FileError also for a column that is missing, an unknown grain, a grain in contact with itself, a
///           normal that is no unit vector or does not fit the positions, one pair with two forces
/// Checked by tests/io/yade/test_text.cpp
[[nodiscard]] ImportedPacking read_yade(TextSource grains, std::optional<TextSource> contacts = {},
                                        const PackingFileOptions& options = {});

/// The grains of a legacy VTK file in text form as YADE's VTKExporter.exportSpheres and LIGGGHTS' dump
/// custom/vtk write it: POINTS, and the point data "radius", as SCALARS or in a FIELD; "id" and "type", where
/// they are there, else grains are numbered in their order. Six digits: good for the geometry, not for
/// overlaps.
/// \throws   FileError with path and line for text that is no such file, fields that are not numbers or
///           too few, no radii, a radius that is not positive
///
/// And the contacts, where there are any, of VTKExporter.exportInteractions: two points a contact, which
/// are matched with the centres of the spheres by their digits, LINES, and the cell data "fn" and "ft"
/// (normalForce and shearForce, on the second sphere) where they are there, or the size of fn as SCALARS. A
/// line that ends at no sphere is a contact with a wall across an axis whose plane the grain reaches.
/// Contacts through periodic faces cannot be matched, as the cell is not in such files, and are refused: use
/// share/yade/granum_export.py.
/// \throws   FileError also for a line that ends at no sphere or at two, and as read_yade for contacts
/// Checked by tests/io/yade/test_vtk.cpp
[[nodiscard]] ImportedPacking read_yade_vtk(TextSource spheres, std::optional<TextSource> interactions = {},
                                            const PackingFileOptions& options = {});

} // namespace granum::io
