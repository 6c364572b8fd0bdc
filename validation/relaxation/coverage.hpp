// SPDX-License-Identifier: GPL-3.0-or-later
// Do the stated errors hold where the fit has seen nothing of a recipe?
#pragma once

#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../errors.hpp"
#include "factor_fits.hpp"
#include "scatter.hpp"

namespace relaxation {

/// Standard error of ln of a model that a fit to other recipes states: of its coefficients, and the scatter.
template <int n, class Model>
double coefficient_error(const Fit<n>& fit, const Packing& p, const Network& network, const Model& model) {
  Numbers<Dual<n>, n> c;
  for (int k = 0; k < n; ++k)
    c[static_cast<std::size_t>(k)] = Dual<n>(fit.coefficients[static_cast<std::size_t>(k)], n, k);
  const Dual<n> h = model(inputs<Dual<n>>(p, network), c);
  const auto& slopes = h.derivatives();
  return std::sqrt(slopes.dot(fit.covariance * slopes)) / h.value();
}

struct CoverageOfBoth {
  Coverage shear, bulk;
};

inline void print_coverage(const std::string& what, const CoverageOfBoth& c) {
  std::printf("%-40s %5d |", what.c_str(), c.shear.count);
  for (const auto& [name, coverage] : {std::pair{"G", &c.shear}, std::pair{"K", &c.bulk}})
    std::printf(" %s within one %3.0f %% two %3.0f %% largest stated %4.1f %% %s", name,
                100 * coverage->one(), 100 * coverage->two(), 100 * coverage->largest_stated,
                coverage == &c.shear ? "|" : "\n");
}

/// Each of these names left out in turn: how those packings are covered, printed, and all together.
/// \param    coverage_without   takes a name
template <class CoverageWithout>
CoverageOfBoth coverage_of_each(const std::set<std::string>& names, const std::string& together,
                                const CoverageWithout& coverage_without) {
  CoverageOfBoth all;
  for (const std::string& name : names) {
    const CoverageOfBoth here = coverage_without(name);
    print_coverage("  without " + name, here);
    all.shear.add(here.shear);
    all.bulk.add(here.bulk);
  }
  print_coverage(together, all);
  return all;
}

/// Every preparation left out in turn: coefficients and scatter of all others, errors on its packings.
inline CoverageOfBoth coverage_of_left_out(const std::vector<Packing>& packings) {
  std::set<std::string> names;
  for (const Packing& p : packings)
    if (p.isotropic())
      names.insert(unsheared(p.preparation));
  return coverage_of_each(names, "recipes left out, together", [&](const std::string& name) {
    const Choice left = [&](const Packing& p) { return unsheared(p.preparation) == name; };
    const Choice kept = [&](const Packing& p) { return !left(p); };
    const ShearFit shear = fit_shear(packings, kept);
    const BulkFit bulk = fit_bulk(packings, kept);
    const ScatterParts shear_scatter = scatter_parts(residuals(packings, shear, shear_residual, kept));
    const ScatterParts bulk_scatter = scatter_parts(residuals(packings, bulk, bulk_residual, kept));
    CoverageOfBoth here;
    for (const Packing& p : packings)
      for (const Network& n : p.networks) {
        if (!p.isotropic() || !left(p) || n.ratio < lowest_usual_ratio ||
            p.mechanical_coordination < lowest_usual_coordination || p.relative_overlap > largest_overlap)
          continue;
        const Residual G = shear_residual(p, n, shear), K = bulk_residual(p, n, bulk);
        here.shear.add(G.error,
                       std::hypot(coefficient_error(shear, p, n, kernel::shear_relaxation<Dual<shear_size>>),
                                  deviation(shear_scatter, G.sensitivity)));
        here.bulk.add(K.error,
                      std::hypot(coefficient_error(bulk, p, n, kernel::bulk_relaxation<Dual<bulk_size>>),
                                 deviation(bulk_scatter, K.sensitivity)));
      }
    return here;
  });
}

} // namespace relaxation
