// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <granum/io/packing_format.hpp>

/// Packings from files of any format that granum reads, recognised by content.
/// Checked by tests/io/test_packing_files.cpp
namespace granum::io {

/// Kind of a file: its format, and its role in the format.
struct FileKind {
  const PackingFormat* format = nullptr;
  Holds holds = Holds::grains;

  bool operator==(const FileKind&) const = default;
};

/// "a LAMMPS dump of grains" and so on.
[[nodiscard]] std::string_view description(const FileKind& kind);

/// Looks at the beginning of a file, plain or gzip; the name does not matter. The source is then before its
/// first line again afterwards.
/// \throws   FileError if reading fails or it is of no known format
[[nodiscard]] FileKind recognise(TextSource& source);

/// A file whose kind is known. A pipe, which can be read only once, stays open; of other files only the path
/// is kept.
class PackingFile {
 public:
  /// \throws   FileError as recognise
  explicit PackingFile(std::filesystem::path path);

  [[nodiscard]] const FileKind& kind() const { return kind_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The file from its beginning; once.
  /// \throws   FileError if it cannot be opened
  [[nodiscard]] TextSource open();

 private:
  std::filesystem::path path_;
  FileKind kind_;
  std::optional<TextSource> source_; ///< of a pipe
};

/// The files of some names, in the order of their states: by the names of the files of grains, numbers in
/// them by their value (p50 before p100). A series of VTK files (.pvd) means its files in the order of their
/// times. The first name of grains belongs to the first of contacts, the second with the second, before they
/// are sorted.
/// \throws   FileError as recognise, or as read_collection for a series; InvalidArgument for series of grains
///           and of contacts that do not go together: other numbers of files, or other times
[[nodiscard]] std::vector<PackingFile> files_of_series(const std::vector<std::filesystem::path>& names);

/// All states of a packing in some files, one after the other; one at a time in memory. Files of grains and
/// of contacts may be mixed: the first file of grains belongs to the first of contacts, the second with the
/// second.
class PackingFiles {
 public:
  /// \param    files   at least one; as many of contacts as of grains, or none of contacts; all of one format
  /// \throws   InvalidArgument for files that do not go together
  explicit PackingFiles(std::vector<PackingFile> files, PackingFileOptions options = {});
  /// \throws   FileError also, as recognise
  explicit PackingFiles(const std::vector<std::filesystem::path>& files, PackingFileOptions options = {})
      : PackingFiles(std::vector<PackingFile>(files.begin(), files.end()), std::move(options)) {}

  /// The next state; empty at the end of the last file.
  /// \throws   FileError as the reader of the format
  [[nodiscard]] std::optional<ImportedPacking> next();

  /// The file of grains that the last state came from.
  /// Assumes   next() has been called.
  [[nodiscard]] const std::filesystem::path& path() const { return grains_[opened_ - 1].path(); }

  /// Frames passed over so far because another file has none of that time step.
  [[nodiscard]] std::size_t skipped() const;

 private:
  PackingFrames open_next();

  PackingFileOptions options_;
  std::vector<PackingFile> grains_, contacts_;
  std::size_t opened_ = 0, skipped_ = 0; ///< skipped in files that have been read to their end
  std::optional<PackingFrames> frames_;
};

} // namespace granum::io
