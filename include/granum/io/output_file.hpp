// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace granum::io {

enum class Existing {
  keep,    ///< an existing file is an error, and stays as it is
  replace, ///< an existing file is replaced, whole, at the end
};

/// What a file that is being written has behind its name.
inline constexpr std::string_view part_extension = ".granum.part";

/// Whether something stands at a path, be it a link that leads nowhere.
[[nodiscard]] bool is_taken(const std::filesystem::path& path);

/// Writes text to path so that a reader sees the old file or the whole new one, never a part: the text goes
/// to a temporary name in the same folder, is flushed to disk, and is renamed. A file that is replaced
/// hands its mode on; what a killed run left of this file is removed.
/// \throws   FileError if the file exists and existing is keep, or if writing fails (no temporary file
///                     stays behind)
/// Checked by tests/io/test_output_file.cpp
void write_file(const std::filesystem::path& path, std::string_view text, Existing existing);

} // namespace granum::io
