// SPDX-License-Identifier: GPL-3.0-or-later
// How far K of packings that other codes made lies from the curve of granum's own: a third part of its
// scatter, beside recipes and packings.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "size_coverage.hpp"

namespace relaxation {

/// The code whose packings the scatter is taken from; those of any other code judge it.
inline bool is_calibrating_code(const Packing& p) { return p.preparation.starts_with("lammps"); }

/// Standard deviation of ln K over the looseness that makes the errors most likely, beyond what is stated of
/// granum's own packings.
inline double fit_code_scatter(const std::vector<Packing>& packings, const EqualFit& equal,
                               const SizeEffect& effect) {
  double variance = 0.01;
  for (int round = 0; round < 100; ++round) {
    double left = 0, weights = 0;
    for (const Packing& p : packings)
      for (const Network& n : p.networks) {
        if (!is_usual(p, n) || !is_calibrating_code(p))
          continue;
        const Judged own = judged_bulk(p, n, equal, effect);
        const double known = own.stated * own.stated;
        const double row = std::pow(kernel::looseness(p.mechanical_coordination), 2);
        const double weight = row / std::pow(known + variance * row, 2);
        left += weight * (own.error * own.error - known);
        weights += weight * row;
      }
    variance = std::max(0.0, left / weights);
  }
  return std::sqrt(variance);
}

} // namespace relaxation
