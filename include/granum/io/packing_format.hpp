// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include <granum/io/csv/packing.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/io/lammps/column_map.hpp>
#include <granum/io/text/source.hpp>

/// The formats of packings that granum reads, one row each. A new one is a source with its row and the two
/// functions in it, its name at the end of this header, a line in CMakeLists.txt, and a test.
/// Checked by tests/io/test_packing_files.cpp
namespace granum::io {

/// Content of a file of a packing.
enum class Holds { grains, contacts };

/// Data that files of some formats do not contain.
struct PackingFileOptions {
  ColumnMap columns = {};         ///< of dumps
  std::optional<CsvBox> box = {}; ///< of CSV files
};

/// The frames of one file, or of a file of grains and its companion, one after the other.
struct PackingFrames {
  std::function<std::optional<ImportedPacking>()> next; ///< empty at the end
  /// Frames passed over so far because the companion has none of that time.
  std::function<std::size_t()> skipped = [] { return std::size_t{0}; };
};

struct PackingFormat {
  std::string_view name;     ///< in lists of formats
  std::string_view sign;     ///< how its files are recognised, for help
  std::string_view grains;   ///< "a LAMMPS dump of grains"
  std::string_view contacts; ///< the companion file; empty if none
  /// Whether a file, from its beginning, looks like one of this format, and which.
  /// \throws   FileError for a file that can be of no other format, but does not identify its content
  std::optional<Holds> (*recognise)(TextSource& source);
  /// Reads the file of grains, and its companion where there is one.
  /// \throws   FileError as the reader of the format, here or from next()
  PackingFrames (*read)(TextSource grains, std::optional<TextSource> contacts,
                        const PackingFileOptions& options);
  /// Reads contacts without grains; empty if these are not sufficient.
  ContactTable (*read_contacts)(TextSource contacts) = nullptr;
};

/// Lines of a file that are looked at before it is given up.
inline constexpr int lines_looked_at = 40;

/// Frames of a reader that has next() and skipped().
template <class Reader>
PackingFrames frames_of(Reader reader) {
  const auto shared = std::make_shared<Reader>(std::move(reader));
  return {.next = [shared] { return shared->next(); }, .skipped = [shared] { return shared->skipped(); }};
}

/// The single frame of files with one state.
PackingFrames one_frame(ImportedPacking packing);

extern const PackingFormat lammps_dump_format, yade_vtk_format, vtk_xml_format, yade_text_format,
    mercury_format, lammps_data_format, csv_format;

/// All formats, in the order in which a file is compared with them.
inline constexpr const PackingFormat* packing_formats[] = {
    &lammps_dump_format, &yade_vtk_format,    &vtk_xml_format, &yade_text_format,
    &mercury_format,     &lammps_data_format, &csv_format};

} // namespace granum::io
