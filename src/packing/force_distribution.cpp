// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/force_distribution.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>

namespace granum::packing {

namespace {

/// Empty bins from 0 to range.
std::vector<ForceBin> empty_bins(std::size_t count, double range) {
  std::vector<ForceBin> bins(count);
  const double number = static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    bins[k].low = range * (static_cast<double>(k) / number);
    bins[k].high = range * (static_cast<double>(k + 1) / number);
  }
  return bins;
}

} // namespace

std::vector<double> normal_forces(const Assembly& assembly) {
  std::vector<double> forces;
  forces.reserve(assembly.contacts.size());
  for (const Contact& c : assembly.contacts)
    forces.push_back(c.normal_force);
  return forces;
}

ForceDistribution force_distribution(std::span<const double> forces, std::size_t bins, double range) {
  require_closed("bins", static_cast<double>(bins), 1, 1000);
  require_positive("range", range);
  ForceDistribution out;
  for (const double f : forces) {
    require_finite("normal_force", f, "N");
    out.pressing += f > 0;
    out.unloaded += f == 0;
    out.in_tension += f < 0;
    out.largest = std::max(out.largest, f);
  }
  out.bins = empty_bins(bins, range);
  if (out.pressing == 0)
    return out;
  const double count = static_cast<double>(out.pressing);
  double sum = 0;
  for (const double f : forces)
    sum += f > 0 ? f : 0;
  out.mean = sum / count;
  for (const double f : forces) {
    if (!(f > 0))
      continue;
    const double place = f / out.mean / range * static_cast<double>(bins);
    if (place < static_cast<double>(bins))
      ++out.bins[static_cast<std::size_t>(place)].count;
    else
      ++out.beyond;
  }
  const double width = range / static_cast<double>(bins);
  for (ForceBin& bin : out.bins) {
    const double in_bin = static_cast<double>(bin.count);
    bin.density = in_bin / (count * width);
    bin.density_error = std::sqrt(in_bin) / (count * width);
  }
  return out;
}

} // namespace granum::packing
