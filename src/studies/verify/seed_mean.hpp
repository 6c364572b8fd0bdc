// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace granum::studies {

/// A measured number, with its standard error where there is one: the larger of the scatter between seeds and
/// the mean error of each, over the root of the number of seeds.
struct TableValue {
  double value = 0;
  std::optional<double> standard_error;
};

/// Prior knowledge of the scatter between specimens of one kind.
struct KnownScatter {
  double deviation = 0; ///< standard deviation of one specimen
  double degrees = 0;   ///< degrees of freedom of its measurement; 0: unknown
};

/// Mean over several specimens. Its error is the larger of their scatter, pooled with what is known
/// of it, and their mean own error, over the root of their number; one specimen without an error of its own,
/// of which no scatter is known, has none. Nothing from none.
[[nodiscard]] std::optional<TableValue> mean_over_seeds(const std::vector<TableValue>& each,
                                                        const KnownScatter& known = {});

} // namespace granum::studies
