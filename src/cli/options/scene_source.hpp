// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// The text of a scene file, checked before a parser sees it.
namespace granum::cli {

/// The text of a regular file or a pipe of at most one megabyte.
/// \throws   FileError for a folder, a device, a larger file, or one that cannot be read
[[nodiscard]] std::string read_scene_text(const std::string& path);

/// Scenes are flat: [section] and key = value. In deeply nested texts the recursion of the parser would
/// overflow the stack.
/// \throws   FileError with path and line for a key of more than 8 parts, brackets more than 8 deep, or a key
///           or value of more than 1,000 characters
void require_flat(std::string_view text, const std::string& path);

} // namespace granum::cli
