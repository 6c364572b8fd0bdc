// SPDX-License-Identifier: GPL-3.0-or-later
// How far K of packings that other codes made lies from the curve of granum's own: a third part of its
// scatter, beside recipes and packings.
#pragma once

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
  std::vector<Deviation> deviations;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (is_usual(p, n) && is_calibrating_code(p)) {
        const Judged own = judged_bulk(p, n, equal, effect);
        const double row = kernel::looseness(p.mechanical_coordination);
        deviations.push_back(
            {.squared = own.error * own.error, .known = own.stated * own.stated, .measure = row * row});
      }
  return further_scatter(deviations);
}

} // namespace relaxation
