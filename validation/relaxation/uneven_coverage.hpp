// SPDX-License-Identifier: GPL-3.0-or-later
// Do the stated errors hold where forces are known, for preparations that no fit has seen?
#pragma once

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "coverage.hpp"
#include "size_coverage.hpp"
#include "uneven_fits.hpp"

namespace relaxation {

/// Fits to some of the packings: of the factors, and of the gains by known forces.
struct FitsOfForces {
  EqualFit equal = {};
  SizeEffect sizes = {};
  KnownForces shear = {}, bulk = {};
};

inline FitsOfForces fits_of_forces(const std::vector<Packing>& packings, const std::vector<Packing>& unequal,
                                   const std::vector<Packing>& gradations, const Choice& chosen) {
  FitsOfForces fits;
  fits.equal.shear = fit_shear(packings, chosen);
  fits.equal.bulk = fit_bulk(packings, chosen);
  fits.equal.shear_scatter = scatter_parts(residuals(packings, fits.equal.shear, shear_residual, chosen));
  fits.equal.bulk_scatter = scatter_parts(residuals(packings, fits.equal.bulk, bulk_residual, chosen));
  fits.sizes = fit_size_effect(unequal, gradations, fits.equal, chosen);
  fits.shear = fit_known_forces(Of::shear, packings, unequal, fits.equal, fits.sizes, chosen);
  fits.bulk = fit_known_forces(Of::bulk, packings, unequal, fits.equal, fits.sizes, chosen);
  return fits;
}

/// As judged_shear and judged_bulk, with the gains and what they leave.
inline CoverageOfBoth coverage_of_known(const std::vector<Packing>& packings, const FitsOfForces& fits,
                                        const Choice& chosen) {
  EqualFit equal = fits.equal;
  equal.shear_scatter = fits.shear.scatter;
  equal.bulk_scatter = fits.bulk.scatter;
  SizeEffect sizes = fits.sizes;
  sizes.shear = fits.shear.sizes;
  sizes.bulk = fits.bulk.sizes.base;
  CoverageOfBoth all;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (is_usual(p, n) && has_unevenness(p, n) && chosen(p)) {
        const auto gained = [&](Of of, const KnownForces& known) {
          return gain<double>(left_of(of, p, n, fits.equal, fits.sizes), known.gain);
        };
        const Judged G = judged_shear(p, n, equal, sizes), K = judged_bulk(p, n, equal, sizes);
        all.shear.add(G.error + gained(Of::shear, fits.shear), G.stated);
        all.bulk.add(K.error + gained(Of::bulk, fits.bulk), K.stated);
      }
  return all;
}

/// Each preparation left out of all fits in turn, of equal grains and of unequal ones.
inline CoverageOfBoth coverage_of_left_out_forces(const std::vector<Packing>& packings,
                                                  const std::vector<Packing>& unequal,
                                                  const std::vector<Packing>& gradations,
                                                  const std::vector<Packing>& judged) {
  std::set<std::string> names;
  for (const Packing& p : judged)
    if (p.isotropic())
      names.insert(unsheared(p.preparation));
  return coverage_of_each(names, "left out, forces known, together", [&](const std::string& name) {
    const Choice left = [&](const Packing& p) { return unsheared(p.preparation) == name; };
    const FitsOfForces fits =
        fits_of_forces(packings, unequal, gradations, [&](const Packing& p) { return !left(p); });
    return coverage_of_known(judged, fits, left);
  });
}

} // namespace relaxation
