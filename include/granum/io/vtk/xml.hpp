// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <granum/io/imported_packing.hpp>
#include <granum/io/text/source.hpp>
#include <granum/io/vtk/paraview.hpp>

/// Packings out of VTK's XML files (.vtu, .vtp), as granum writes them itself (paraview.hpp), YADE's
/// VTKRecorder and many programs. Arrays may be text, base64 or appended, compressed by zlib
/// or not, in either byte order; names may be in small or capital letters; others are skipped.
/// Checked by tests/io/vtk/test_xml.cpp, with files that VTK 9.1 wrote
namespace granum::io {

/// The grains: Points; point data "radius" or "radii"; their ids from point data "id", else they are
/// numbered from 0; their types from point data "type", "materialId" or "material"; the cell from field data
/// "cell", its three edges one after the other, otherwise the smallest upright box is used; the time from
/// field data "TimeValue". Not in such files, with a note: which faces are periodic (all are assumed so if
/// there is a cell, else none), units, contact law. Points of single precision, which YADE writes, are good
/// for the geometry, not for overlaps.
/// \throws   FileError with path and line for files of another kind, or not XML; more than one piece; arrays
///           that are missing, too short or too long, damaged, compressed otherwise; a radius that is not
///           positive, an id that is not an integer or occurs twice
///
/// And contacts, where there are any, lines of two points each, of either kind:
///   granum   cell data "grains", the two ids; "wall", at least 0 for a contact of the first of them with
///            that wall; "normal_force", "tangential_force", "overlap", "sliding", "normal_stiffness",
///            "tangential_stiffness"; each where it is there. The line is the line of centres, or goes from
///            the centre to the wall.
///   YADE     VTKRecorder's "intr": lines from centre to centre, matched with those of the grains by their
///            digits, and cell data "forceN", the normal force; tangential forces have no direction there.
///            Contacts with walls and through periodic faces cannot be matched and are refused: use
///            share/yade/granum_export.py.
/// \throws   FileError also for a line of other than two points, a line that ends at no grain, an unknown
///           grain, and as read_yade for contacts
[[nodiscard]] ImportedPacking read_vtk_xml(TextSource grains, std::optional<TextSource> contacts = {},
                                           const PackingFileOptions& options = {});

/// \file
/// Series of VTK files (.pvd), as granum, ParaView and many programs write them: the list of their names.
/// Checked by tests/io/vtk/test_collection.cpp

/// Whether a file looks like a series. The source is then somewhere in its first lines.
/// \throws   FileError if reading fails
[[nodiscard]] bool is_collection(TextSource& source);

/// The files of a series in the order of their times; names as in the file, relative to its folder.
/// \throws   FileError with path and line for text that is not XML or not a series, a data set without a file
///           or with a time that is no finite number, two data sets of one time (parts are not put together),
///           and none at all
[[nodiscard]] std::vector<SeriesEntry> read_collection(TextSource source);

} // namespace granum::io
