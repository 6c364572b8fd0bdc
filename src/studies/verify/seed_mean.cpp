// SPDX-License-Identifier: GPL-3.0-or-later
#include "seed_mean.hpp"

#include <algorithm>
#include <cmath>

namespace granum::studies {

std::optional<TableValue> mean_over_seeds(const std::vector<TableValue>& each, const KnownScatter& known) {
  if (each.empty())
    return std::nullopt;
  const double count = static_cast<double>(each.size());
  TableValue mean;
  double own = 0, scatter = 0;
  bool has_error = each.size() > 1 || known.degrees > 0;
  for (const TableValue& one : each) {
    mean.value += one.value / count;
    own += one.standard_error ? *one.standard_error * *one.standard_error / count : 0;
    has_error = has_error || one.standard_error;
  }
  const double degrees = count - 1 + known.degrees;
  for (const TableValue& one : each)
    scatter += (one.value - mean.value) * (one.value - mean.value) / std::max(1.0, degrees);
  if (degrees > 0)
    scatter += known.degrees / degrees * known.deviation * known.deviation;
  if (has_error)
    mean.standard_error = std::sqrt(std::max(own, scatter) / count);
  return mean;
}

} // namespace granum::studies
