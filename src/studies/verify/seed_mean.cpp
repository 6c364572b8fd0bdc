// SPDX-License-Identifier: GPL-3.0-or-later
#include "seed_mean.hpp"

#include <algorithm>
#include <cmath>

namespace granum::studies {

std::optional<TableValue> mean_over_seeds(const std::vector<TableValue>& each) {
  if (each.empty())
    return std::nullopt;
  const double count = static_cast<double>(each.size());
  TableValue mean;
  double own = 0, scatter = 0;
  bool known = each.size() > 1;
  for (const TableValue& one : each) {
    mean.value += one.value / count;
    own += one.standard_error ? *one.standard_error * *one.standard_error / count : 0;
    known = known || one.standard_error;
  }
  for (const TableValue& one : each)
    scatter += (one.value - mean.value) * (one.value - mean.value) / std::max(1.0, count - 1);
  if (known)
    mean.standard_error = std::sqrt(std::max(own, scatter) / count);
  return mean;
}

} // namespace granum::studies
