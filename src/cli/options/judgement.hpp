// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/frame/frame.hpp"
#include "studies/verify/findings.hpp"
#include <nlohmann/json.hpp>

namespace granum::cli {

/// --strict of studies that compare with a paper.
void add_strict(Command& command, bool& strict);

/// Exit code of a finished study: fell_short if a check of granum failed or, under strict, if a result
/// differs from the paper; else ok. Writes each reason to standard error.
[[nodiscard]] ExitCode judged(const std::vector<studies::Verdict>& verdicts, bool strict);

} // namespace granum::cli
