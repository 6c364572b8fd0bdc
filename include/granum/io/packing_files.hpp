// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <granum/io/column_map.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/io/packing_csv.hpp>
#include <granum/io/text_source.hpp>

/// Packings out of files of any format that granum reads, told apart by what stands in them.
/// Checked by tests/io/test_packing_files.cpp
namespace granum::io {

/// What a file holds.
enum class FileKind {
  dump_grains,   ///< LAMMPS or LIGGGHTS, dump custom
  dump_contacts, ///< LAMMPS or LIGGGHTS, dump local
  lammps_data,
  mercury_data,
  mercury_fstat,
  yade_grains,
  yade_contacts,
  vtk_grains,
  vtk_contacts,
  csv_grains,
  csv_contacts,
};

/// "a LAMMPS dump of grains" and so on.
[[nodiscard]] std::string_view description(FileKind kind);
/// Whether such a file holds contacts, not grains.
[[nodiscard]] bool holds_contacts(FileKind kind);

/// Looks at the beginning of a file, plain or gzip; the name does not matter.
/// \throws   FileError if reading fails or it is of no known kind
[[nodiscard]] FileKind recognise(TextSource source);

/// What files of some formats do not tell.
struct PackingFileOptions {
  ColumnMap columns = {};         ///< of dumps
  std::optional<CsvBox> box = {}; ///< of CSV files
};

/// All states of a packing that some files hold, one after the other. Files of grains and of contacts may be
/// mixed: the first file of grains goes with the first of contacts, the second with the second.
class PackingFiles {
 public:
  /// \param    files   at least one; as many of contacts as of grains, or none of contacts; all of one format
  /// \throws   InvalidArgument for files that do not go together; FileError as recognise
  explicit PackingFiles(const std::vector<std::filesystem::path>& files, PackingFileOptions options = {});
  PackingFiles(PackingFiles&&) noexcept;
  PackingFiles& operator=(PackingFiles&&) noexcept;
  ~PackingFiles();

  /// The next state; nothing at the end of the last file.
  /// \throws   FileError as the reader of the format
  [[nodiscard]] std::optional<ImportedPacking> next();

  /// Kinds of the files, in the order in which they were given.
  [[nodiscard]] const std::vector<FileKind>& kinds() const;
  /// Frames passed over so far because another file has none of that time step.
  [[nodiscard]] std::size_t skipped() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace granum::io
