// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <granum/io/csv/packing.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/io/lammps/arrays.hpp>
#include <granum/io/text/source.hpp>

/// The formats of packings that granum reads, one row each. A new one is a source with its row and the two
/// functions in it, its name at the end of this header, a line in CMakeLists.txt, and a test.
/// Checked by tests/io/test_packing_files.cpp
namespace granum::io {

/// Content of a file of a packing.
enum class Holds { grains, contacts };

/// The frames of one file, or of a file of grains and its companion, one after the other.
struct PackingFrames {
  std::function<std::optional<ImportedPacking>()> next; ///< empty at the end
  /// Frames passed over so far because the companion has none of that time.
  std::function<std::size_t()> skipped = [] { return std::size_t{0}; };
  /// Steps, or times, of all frames of the grains in the order of the file; those that a later run of the
  /// job wrote again are passed over by next(). None for a file of one frame, and for a pipe.
  std::vector<double> moments = {};
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
  ContactTable (*read_contacts)(TextSource contacts, const PackingFileOptions& options) = nullptr;
};

/// Lines of a file that are looked at before it is given up.
inline constexpr int lines_looked_at = 40;

/// Frames of a reader that has next() and skipped().
template <class Reader>
PackingFrames frames_of(Reader reader) {
  const auto shared = std::make_shared<Reader>(std::move(reader));
  return {.next = [shared] { return shared->next(); },
          .skipped = [shared] { return shared->skipped(); },
          .moments = shared->moments()};
}

/// The single frame of files with one state.
PackingFrames one_frame(ImportedPacking packing);

extern const PackingFormat lammps_dump_format, yade_vtk_format, vtk_xml_format, yade_text_format,
    mercury_format, extended_xyz_format, lammps_data_format, csv_format;

/// All formats, in the order in which a file is compared with them.
inline constexpr const PackingFormat* packing_formats[] = {
    &lammps_dump_format, &yade_vtk_format,     &vtk_xml_format,     &yade_text_format,
    &mercury_format,     &extended_xyz_format, &lammps_data_format, &csv_format};

/// \file
/// Packings from files of any format that granum reads, recognised by content.
/// Checked by tests/io/test_packing_files.cpp

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
  /// Its place in a series, in the units of the index file.
  [[nodiscard]] const std::optional<double>& time() const { return time_; }
  void set_time(std::optional<double> time) { time_ = time; }
  /// Files of its series that were left out because a restarted job wrote their times again; said once.
  [[nodiscard]] const std::string& replaced() const { return replaced_; }
  void set_replaced(std::string text) { replaced_ = std::move(text); }
  /// The file from its beginning; once.
  /// \throws   FileError if it cannot be opened
  [[nodiscard]] TextSource open();

 private:
  std::filesystem::path path_;
  FileKind kind_;
  std::optional<double> time_;
  std::string replaced_;
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
/// Where steps go back, as those of a restarted job do, the later run answers: earlier frames from the step
/// on at which it begins are left out, within a file and, for dumps, among those whose names differ in
/// numbers alone. A dump that begins no later than the one ahead of it is another simulation.
class PackingFiles {
 public:
  /// \param    files   at least one; as many of contacts as of grains, or none of contacts; all of one format
  /// \throws   InvalidArgument for files that do not go together
  explicit PackingFiles(std::vector<PackingFile> files, PackingFileOptions options = {});
  /// \throws   FileError also, as recognise
  explicit PackingFiles(const std::vector<std::filesystem::path>& files, PackingFileOptions options = {})
      : PackingFiles(std::vector<PackingFile>(files.begin(), files.end()), std::move(options)) {}

  /// The next state; empty at the end of the last file. A state of a series (.pvd) has its place there as
  /// time, or as step where all places are whole numbers.
  /// \throws   FileError as the reader of the format, but not for a last frame that is cut off behind others
  [[nodiscard]] std::optional<ImportedPacking> next();

  /// The file of grains that the last state came from.
  /// Assumes   next() has been called.
  [[nodiscard]] const std::filesystem::path& path() const { return grains_[opened_ - 1].path(); }

  /// Frames passed over so far because another file has none of that time step.
  [[nodiscard]] std::size_t skipped() const;
  /// Why the last frame is missing, if the last file ends within it, as those of a killed job do; else empty.
  [[nodiscard]] const std::string& cut() const { return cut_; }
  /// What was left out so far for a later run of a restarted job, a line for each file; mostly none.
  [[nodiscard]] const std::vector<std::string>& replaced() const { return replaced_; }

 private:
  PackingFrames open_next();
  /// Finds what later files write again of the one that is open.
  void look_ahead();
  /// The next state of the file that is open, with its place in the series; empty at the end of the file.
  std::optional<ImportedPacking> next_of_file();

  PackingFileOptions options_;
  std::vector<PackingFile> grains_, contacts_;
  std::size_t opened_ = 0, skipped_ = 0; ///< skipped in files that have been read to their end
  std::optional<PackingFrames> frames_;
  bool steps_ = false;                                     ///< places in the series are steps
  bool begun_ = false;                                     ///< a state has been returned
  double until_ = std::numeric_limits<double>::infinity(); ///< step at which a later file begins
  std::string cut_;
  std::vector<std::string> replaced_;
};

} // namespace granum::io
