// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/verify/findings.hpp"

namespace granum::studies {

/// HTML lists of agreements with the paper, differences from it, and checks of granum itself.
/// Checked by tests/studies/test_experiment_html.cpp
[[nodiscard]] std::string verdict_lists(const std::vector<Verdict>& verdicts);

} // namespace granum::studies
