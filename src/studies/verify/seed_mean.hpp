// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "studies/reproduce/experiment_findings.hpp"

namespace granum::studies {

/// Mean of what several specimens gave. Its error is the larger of their scatter and their mean own error,
/// over the root of their number; one specimen without an error of its own has none. Nothing from none.
[[nodiscard]] std::optional<TableValue> mean_over_seeds(const std::vector<TableValue>& each);

} // namespace granum::studies
