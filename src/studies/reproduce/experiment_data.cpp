// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment_data.hpp"

#include <algorithm>
#include <cmath>

namespace granum::studies {

const PathRun* find_run(const ExperimentSpecimen& specimen, const std::optional<stress::ShearPath>& path) {
  const auto found = std::find_if(specimen.runs.begin(), specimen.runs.end(),
                                  [&](const PathRun& run) { return run.path == path; });
  return found == specimen.runs.end() ? nullptr : &*found;
}

std::vector<const StateRecord*> early_points(const ExperimentSpecimen& specimen) {
  // A snapshot at a multiple of eta is taken just after it.
  constexpr double margin = 0.01;
  std::vector<const StateRecord*> out;
  for (const PathRun& run : specimen.runs)
    for (const StateRecord& point : run.points) {
      // Past the peak eta may fall below the limit again: the path has left the range for good.
      if (!run.path || std::abs(point.at.stress.ratio()) > early_eta + margin)
        break;
      out.push_back(&point);
    }
  return out;
}

std::vector<const StateRecord*> fit_points(const ExperimentSpecimen& specimen) {
  std::vector<const StateRecord*> out = early_points(specimen);
  for (const StateRecord& point : specimen.runs.front().points)
    out.push_back(&point);
  return out;
}

std::optional<double> network_G_hh(const StateRecord& point) { return point.G_hh(); }
std::optional<double> network_G_vh(const StateRecord& point) { return point.G_vh(); }

std::optional<double> probe_G_hh(const StateRecord& point) {
  return point.probes ? std::optional(point.probes->G_hh) : std::nullopt;
}
std::optional<double> probe_G_hv(const StateRecord& point) {
  return point.probes ? std::optional(point.probes->G_hv) : std::nullopt;
}
std::optional<double> probe_G_vh(const StateRecord& point) {
  return point.probes ? std::optional(point.probes->G_vh) : std::nullopt;
}

} // namespace granum::studies
