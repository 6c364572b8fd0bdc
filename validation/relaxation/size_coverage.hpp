// SPDX-License-Identifier: GPL-3.0-or-later
// Do the stated errors hold for unequal grains that the fit of the sizes has not seen?
#pragma once

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "coverage.hpp"
#include "size_fits.hpp"

namespace relaxation {

/// An error and what it is stated to be.
struct Judged {
  double error = 0;
  double stated = 0;
};

/// What a scatter of forces that was not recorded leaves unknown of ln of a factor.
template <class Fitted>
double error_by_scatter(const Packing& p, const Network& n, const Fitted& fit,
                        double (*model)(const Packing&, const Network&,
                                        const decltype(Fitted::coefficients)&)) {
  Packing more = p;
  more.equal_scatter += p.scatter_error;
  return std::log(model(more, n, fit.coefficients) / model(p, n, fit.coefficients));
}

inline Judged judged_shear(const Packing& p, const Network& n, const EqualFit& equal,
                           const SizeEffect& effect) {
  const double root = std::sqrt(branch_variance(p));
  const Residual G = shifted_shear_residual(p, n, equal.shear, effect.shift);
  const double stated =
      std::hypot(coefficient_error(equal.shear, p, n, kernel::shear_relaxation<Dual<shear_size>>),
                 deviation(equal.shear_scatter, G.sensitivity), root * effect.shear.base);
  const double by_shift =
      std::abs(G.sensitivity) * std::hypot(root * effect.shear.gain, unit_shift(p) * effect.shift_error);
  return {G.error, std::hypot(stated, by_shift, error_by_scatter(p, n, equal.shear, shear_model))};
}

/// For a packing of granum: without the scatter between codes.
inline Judged judged_bulk(const Packing& p, const Network& n, const EqualFit& equal,
                          const SizeEffect& effect) {
  const Residual K = lessened_bulk_residual(p, n, equal.bulk, effect.loss);
  const double by_loss =
      (1 - bulk_share<double>(p, equal.bulk, effect.loss)) / effect.loss * effect.loss_error;
  const double by_sizes = kernel::bulk_size_measure(branch_variance(p)) * effect.bulk;
  return {K.error, std::hypot(coefficient_error(equal.bulk, p, n, kernel::bulk_relaxation<Dual<bulk_size>>),
                              deviation(equal.bulk_scatter, K.sensitivity),
                              std::hypot(by_sizes, by_loss, error_by_scatter(p, n, equal.bulk, bulk_model)))};
}

/// Errors of the chosen packings against what they are stated to be.
/// \param    codes   scatter of K between codes (code_scatter.hpp); 0 among granum's own packings
inline CoverageOfBoth coverage_of(const std::vector<Packing>& packings, const EqualFit& equal,
                                  const SizeEffect& effect, const Choice& chosen, double codes = 0) {
  CoverageOfBoth all;
  for (const Packing& p : packings)
    for (const Network& n : p.networks) {
      if (!is_usual(p, n) || !chosen(p) || p.mechanical_coordination < lowest_usual_coordination)
        continue;
      const Judged G = judged_shear(p, n, equal, effect), K = judged_bulk(p, n, equal, effect);
      all.shear.add(G.error, G.stated);
      all.bulk.add(K.error, std::hypot(K.stated, codes * kernel::looseness(p.mechanical_coordination)));
    }
  return all;
}

/// Each value of a label left out of the fit of the sizes in turn: what a fit to the others states of it.
/// \param    judged   the packings that are asked: those of the fit, or the gradations
template <class Label>
CoverageOfBoth coverage_of_left_out_sizes(const std::vector<Packing>& packings,
                                          const std::vector<Packing>& gradations, const EqualFit& equal,
                                          const Label& label, const std::vector<Packing>& judged) {
  std::set<std::string> names;
  for (const Packing& p : judged)
    if (p.isotropic() && p.sizes != "equal")
      names.insert(label(p));
  return coverage_of_each(names, "left out, together", [&](const std::string& name) {
    const SizeEffect effect =
        fit_size_effect(packings, gradations, equal, [&](const Packing& p) { return label(p) != name; });
    return coverage_of(judged, equal, effect,
                       [&](const Packing& p) { return label(p) == name && p.sizes != "equal"; });
  });
}

} // namespace relaxation
