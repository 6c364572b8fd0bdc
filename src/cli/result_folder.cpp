// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_folder.hpp"

#include <unistd.h>

#include <granum/core/error.hpp>

namespace granum::cli {

namespace fs = std::filesystem;

void make_result_folder(const fs::path& folder, const std::vector<std::string>& files, bool force) {
  for (const std::string& file : files)
    if (!force && fs::exists(folder / file))
      throw FileError((folder / file).string(), 0, "exists already and is kept; --force replaces it");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw FileError(folder.string(), 0, "cannot be made: " + error.message());
  if (access(folder.c_str(), W_OK) != 0)
    throw FileError(folder.string(), 0, "cannot be written to");
}

} // namespace granum::cli
