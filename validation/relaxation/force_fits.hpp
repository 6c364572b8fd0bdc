// SPDX-License-Identifier: GPL-3.0-or-later
// How forces scatter in packings that tell nothing of them, and what that takes off uniform strain.
#pragma once

#include <cmath>
#include <vector>

#include "factor_fits.hpp"
#include "size_fits.hpp"

namespace relaxation {

struct ForcesFit {
  Fit<3> scatter;           ///< kernel::force_coefficients
  Fit<2> share;             ///< kernel::share_coefficients
  double scatter_error = 0; ///< standard deviation of the scatter about its expectation
  double share_error = 0;   ///< the same of ln of the share, the scatter known, over b (1 - b)
};

/// Of isotropic packings with overlaps below 1 %.
inline ForcesFit fit_forces(const std::vector<Packing>& packings, const std::vector<Packing>& unequal) {
  std::vector<Observation<3>> scatters;
  std::vector<Observation<2>> shares;
  for (const std::vector<Packing>* all : {&packings, &unequal})
    for (const Packing& p : *all) {
      if (!p.isotropic() || p.relative_overlap > largest_overlap)
        continue;
      const double v = branch_variance(p), z = p.mechanical_coordination, b = p.exponent;
      scatters.push_back(
          {[=](const Numbers<Dual<3>, 3>& c) { return kernel::expected_scatter(Dual<3>(z), v, c); },
           p.force_scatter, 1 / (1 + 15 * v), p.recipe});
      if (b > 0)
        shares.push_back({[b, v, scatter = p.equal_scatter](const Numbers<Dual<2>, 2>& c) {
                            return Dual<2>(log(kernel::expected_share(Dual<2>(b), Dual<2>(scatter), v, c)) /
                                           (b * (1 - b)));
                          },
                          std::log(p.strain_share) / (b * (1 - b)), 1, p.recipe});
    }
  const auto deviation = []<int n>(const std::vector<Observation<n>>& rows, const Fit<n>& fit) {
    double sum = 0;
    for (const Observation<n>& row : rows)
      sum += std::pow(
          row.weight * (row.model(kernel::constants<Dual<n>>(fit.coefficients)).value() - row.target), 2);
    return std::sqrt(sum / static_cast<double>(rows.size()));
  };
  ForcesFit fit{.scatter = least_squares<3>(scatters, {0.65, 0.35, 1}),
                .share = least_squares<2>(shares, {0.6, 0.1})};
  fit.scatter_error = deviation(scatters, fit.scatter);
  fit.share_error = deviation(shares, fit.share);
  return fit;
}

/// Seeds that judge are not fitted.
inline bool is_fitted_seed(const Packing& p) { return p.seed % 100 < 2; }

} // namespace relaxation
