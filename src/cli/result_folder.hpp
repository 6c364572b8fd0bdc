// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace granum::cli {

/// Makes a folder for results, before any work is done.
/// \param    files   that will be written, by their names in the folder
/// \throws   FileError if it cannot be made or written to, or if one of the files is there and not released
void make_result_folder(const std::filesystem::path& folder, const std::vector<std::string>& files,
                        bool force);

} // namespace granum::cli
