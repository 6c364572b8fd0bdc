// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/io/imported_packing.hpp>
#include <granum/io/text/source.hpp>

namespace granum::io {

/// The grains of a legacy VTK file in text form as YADE's VTKExporter.exportSpheres and LIGGGHTS' dump
/// custom/vtk write it: POINTS, and the point data "radius", as SCALARS or in a FIELD; "id" and "type", where
/// they are there, else grains are numbered in their order. Six digits: good for the geometry, not for
/// overlaps.
/// \throws   FileError with path and line for text that is no such file, fields that are not numbers or
///           too few, no radii, a radius that is not positive
///
/// And the contacts, where there are any, of VTKExporter.exportInteractions: two points a contact, which
/// are matched with the centres of the spheres by their digits, LINES, and the cell data "fn" and "ft"
/// (normalForce and shearForce, on the second sphere) where they are there, or the size of fn as SCALARS. A line
/// that ends at no sphere is a contact with a wall across an axis whose plane the grain reaches. Contacts through periodic faces
/// cannot be matched, as the cell is not in such files, and are refused: use share/yade/granum_export.py.
/// \throws   FileError also for a line that ends at no sphere or at two, and as read_yade for contacts
/// Checked by tests/io/yade/test_vtk.cpp
[[nodiscard]] ImportedPacking read_yade_vtk(TextSource spheres, std::optional<TextSource> interactions = {});

} // namespace granum::io
