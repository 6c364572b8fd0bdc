// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <granum/core/error.hpp>

namespace granum::io {

/// The file ends where more should follow: a job was killed, or a copy is not complete.
class CutFile : public FileError {
 public:
  using FileError::FileError;
};

/// The lines of a text file, plain or gzip (recognised by content), one after the other. Uses one buffer and
/// the longest line, never the file.
/// Checked by tests/io/text/test_source.cpp
class TextSource {
 public:
  /// The longest line of a text [bytes], which limits the memory for a file without line ends.
  static constexpr std::size_t longest_line = std::size_t{1} << 26;

  /// \throws   FileError if the file cannot be opened or is a folder
  explicit TextSource(const std::filesystem::path& path);
  /// A text in memory, plain; `name` is the path in errors.
  [[nodiscard]] static TextSource of_text(std::string name, std::string_view text);
  TextSource(TextSource&&) noexcept;
  TextSource& operator=(TextSource&&) noexcept;
  ~TextSource();

  /// Goes to the next line; false at the end of the file. The last line needs no line end.
  /// \throws   FileError if reading fails, compressed data are damaged or end too early, or a line is longer
  ///           than longest_line
  bool next();
  /// The line here, without its line end (LF or CR LF) and a byte order mark; valid until the next call.
  [[nodiscard]] std::string_view line() const { return line_; }
  /// Makes the next call of next() stay on the line here.
  void hold() { held_ = true; }
  /// The same for the rest of the line, without so many characters at its beginning.
  void hold(std::size_t without) {
    line_.remove_prefix(without);
    hold();
  }
  /// The bytes in the buffer after the current line, for files that do not consist of lines; none at
  /// the end. Valid until the next call.
  /// \throws   FileError as next
  [[nodiscard]] std::string_view next_bytes();

  /// From here on all that is read of a pipe stays in memory, so that even a pipe can be read anew: for a
  /// look at the content of a file. Call it before reading.
  void keep_from_start();
  /// Before the first line again, from behind keep_from_start().
  /// \throws   FileError if the file cannot be read a second time
  void back_to_start();
  /// The file once more, from its first line, whatever was read here; empty for a pipe.
  /// \throws   FileError as the constructor
  [[nodiscard]] std::optional<TextSource> again() const;
  /// Text read from here on is not kept.
  void stop_keeping() { keeping_ = false; }

  /// Number of the line here, from 1; after the end that of the last line.
  [[nodiscard]] std::size_t line_number() const { return line_number_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// \throws   FileError with the name and the number of the line here, always; CutFile at the end of
  ///           the file
  [[noreturn]] void fail(const std::string& what) const;

 private:
  struct Stream;

  TextSource(std::string name, std::unique_ptr<Stream> stream);
  bool fill();
  void take(std::size_t end, std::size_t next);

  std::string name_;
  std::unique_ptr<Stream> stream_; ///< none for a text in memory
  std::vector<char> buffer_;
  std::size_t begin_ = 0; ///< of unread text in the buffer
  std::size_t end_ = 0;
  std::string_view line_;
  std::size_t line_number_ = 0;
  bool held_ = false;
  bool keeping_ = false;
  bool dropped_ = false; ///< of the buffer's beginning, to make room
};

/// All bytes of a file, plain or gzip: the one way in which a file is read whole.
/// \throws   FileError as TextSource, or if there are more than `most` bytes
[[nodiscard]] std::string file_content(const std::filesystem::path& path,
                                       std::size_t most = std::numeric_limits<std::size_t>::max());

/// \file
/// States of a series from the names of files.
/// Checked by tests/io/text/test_file_names.cpp

/// Whether one name comes before another as people count: numbers in them by their value, p50 before p100.
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

/// Which of some files belong together: those whose names, folders included, differ in numbers alone, as
/// dense_p50 and dense_p100 do, or dense/state.10 and dense/state.20.
/// \return   for each file the name of its series, the part that distinguishes it from others: "dense",
///           "loose"; where there is one series, the name of the first file without its folder
[[nodiscard]] std::vector<std::string> series_by_name(const std::vector<std::string>& files);

} // namespace granum::io
