// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <granum/io/text/source.hpp>
#include <granum/io/vtk/paraview.hpp>

/// Series of VTK files (.pvd), as granum, ParaView and many programs write them: the list of their names.
/// Checked by tests/io/vtk/test_collection.cpp
namespace granum::io {

/// Whether a file looks like a series. The source is then somewhere in its first lines.
/// \throws   FileError if reading fails
[[nodiscard]] bool is_collection(TextSource& source);

/// The files of a series in the order of their times; names as in the file, relative to its folder.
/// \throws   FileError with path and line for text that is not XML or not a series, a data set without a file
///           or with a time that is no finite number, two data sets of one time (parts are not put together),
///           and none at all
[[nodiscard]] std::vector<SeriesEntry> read_collection(TextSource source);

} // namespace granum::io
