// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace granum::io {

enum class Existing {
  keep,    ///< an existing file is an error, and stays as it is
  replace, ///< an existing file is replaced, whole, at the end
};

/// Suffix of the name of an unfinished file; the name is cut if it would be too long.
inline constexpr std::string_view part_extension = ".granum.part";

/// Whether something exists at a path that a result must not replace without --force, also a dangling link.
/// Pipes, terminals and other character devices can be written to without loss: false.
[[nodiscard]] bool is_taken(const std::filesystem::path& path);

/// Whether two results of these names would be one file: links among their folders are followed, those of the
/// files are not, because a link is replaced. False where a folder cannot be looked up.
/// Checked by tests/io/test_output_file.cpp
[[nodiscard]] bool is_one_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Writes text to path so that a reader sees the old file or the whole new one, never a part: the text is
/// written to a temporary name in the same folder, is flushed to disk, and is renamed. A file that is
/// replaced passes on its permissions; a link is replaced, and its target kept; the temporary file of a
/// killed run is removed. A pipe, a character device and the descriptors of this process (/dev/stdout) are
/// written to, whatever `existing` is, and are never replaced.
/// Assumes   that SIGXFSZ and SIGPIPE are ignored where a file may grow past its limit or a pipe lose its
///                     reader: as errors they are FileError, else they end the program
/// \throws   FileError if the file exists and existing is keep, if path is a folder, a disk or a socket, if a
///                     pipe has no reader within a second, or if writing fails (no temporary file stays
///                     behind)
/// Checked by tests/io/test_output_file.cpp
void write_file(const std::filesystem::path& path, std::string_view text, Existing existing);

} // namespace granum::io
