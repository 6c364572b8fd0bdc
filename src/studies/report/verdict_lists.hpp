// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/verify/findings.hpp"

namespace granum::studies {

/// HTML of what agrees with the paper, what differs, and of the checks of granum itself, in words.
/// Checked by tests/studies/test_experiment_html.cpp
[[nodiscard]] std::string verdict_lists(const std::vector<Verdict>& verdicts);

} // namespace granum::studies
