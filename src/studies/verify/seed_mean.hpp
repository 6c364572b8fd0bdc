// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "studies/reproduce/experiment_findings.hpp"
#include "studies/verify/known_scatter.hpp"

namespace granum::studies {

/// Mean of what several specimens gave. Its error is the larger of their scatter, pooled with what is known
/// of it, and their mean own error, over the root of their number; one specimen without an error of its own,
/// of which no scatter is known, has none. Nothing from none.
[[nodiscard]] std::optional<TableValue> mean_over_seeds(const std::vector<TableValue>& each,
                                                        const KnownScatter& known = {});

} // namespace granum::studies
