// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "studies/report/panel.hpp"

namespace granum::cli {

/// Numbers and picture of each panel; replaces those of an earlier run.
/// \param    folder   created if missing
/// \throws   FileError
void write_panels(const std::filesystem::path& folder, const std::vector<studies::Panel>& panels);

} // namespace granum::cli
