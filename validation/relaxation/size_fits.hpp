// SPDX-License-Identifier: GPL-3.0-or-later
// What unequal grains add to the relaxation factors, fitted to unequal.csv, and their scatters to
// gradations.csv too, with the factors of equal grains given.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "factor_fits.hpp"
#include "scatter.hpp"

namespace relaxation {

struct SizeEffect {
  double shift = 0;       ///< of z* in G at the isostatic point, over the relative variance of branches
  double shift_error = 0; ///< its standard error
  double loss = 0;        ///< of K, as kernel::size_bulk_share has it
  double loss_error = 0;  ///< its standard error
  Scatter shear;          ///< standard deviation over the root of that variance
  double bulk = 0;        ///< the same of K, over kernel::bulk_size_measure
};

/// What the fit to equal grains says: coefficients and both scatters.
struct EqualFit {
  ShearFit shear;
  BulkFit bulk;
  ScatterParts shear_scatter, bulk_scatter;
};

inline double branch_variance(const Packing& p) { return kernel::branch_variance(p.state.contacts); }

/// What a shift of 1 adds to z*.
inline double unit_shift(const Packing& p) {
  return branch_variance(p) * kernel::looseness(p.mechanical_coordination);
}

/// G over that of the closed form, as equal grains of a shifted z* have it.
template <class T, int n>
T shifted_shear(const Packing& p, const Network& n_, const Numbers<T, n>& c, const T& shift) {
  const T z = T(p.mechanical_coordination) + shift * unit_shift(p);
  return kernel::shear_relaxation(z, T(n_.ratio), T(p.exponent()), c);
}

/// Isotropic states of usual contacts, which all fits and errors of this file are about.
inline bool is_usual(const Packing& p, const Network& n) {
  return p.isotropic() && n.ratio >= lowest_usual_ratio && p.relative_overlap < largest_overlap &&
         p.mechanical_coordination >= 4.2;
}

/// Fits one number of the sizes to ln of a factor, beside what small specimens are stiffer than large ones,
/// which the equal grains of the same file show.
/// \param    model      ln of the factor, of a packing, a network and that number
/// \param    measured   the same, of a packing and a network
template <class Model, class Measured>
Fit<2> fit_beside_specimens(const std::vector<Packing>& packings, const Choice& chosen, const Model& model,
                            const Measured& measured) {
  using D = Dual<2>;
  std::vector<Observation<2>> rows;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (is_usual(p, n) && chosen(p))
        rows.push_back({[=](const Numbers<D, 2>& k) { return D(model(p, n, k[0]) + k[1]); }, measured(p, n),
                        1, p.recipe});
  return least_squares<2>(std::move(rows), {0.5, 0.01});
}

inline Fit<2> fit_shift(const std::vector<Packing>& packings, const ShearFit& equal, const Choice& chosen) {
  using D = Dual<2>;
  const auto model = [coefficients = kernel::constants<D>(equal.coefficients)](
                         const Packing& p, const Network& n, const D& shift) {
    return D(log(shifted_shear<D, shear_size>(p, n, coefficients, shift)));
  };
  return fit_beside_specimens(packings, chosen, model, [](const Packing& p, const Network& n) {
    return std::log(shear_factor(p, n));
  });
}

/// K of unequal grains over that of equal ones.
template <class T>
T bulk_share(const Packing& p, const BulkFit& equal, const T& loss) {
  return kernel::size_bulk_share(T(p.mechanical_coordination), kernel::own_exponent(T(p.exponent())), loss,
                                 branch_variance(p), kernel::constants<T>(equal.coefficients));
}

inline Fit<2> fit_loss(const std::vector<Packing>& packings, const BulkFit& equal, const Choice& chosen) {
  using D = Dual<2>;
  const auto model = [equal](const Packing& p, const Network&, const D& loss) {
    return D(log(bulk_share<D>(p, equal, loss)));
  };
  return fit_beside_specimens(packings, chosen, model, [&equal](const Packing& p, const Network& n) {
    return -bulk_residual(p, n, equal).error;
  });
}

/// Error of ln K with the loss.
inline Residual lessened_bulk_residual(const Packing& p, const Network& n, const BulkFit& equal,
                                       double loss) {
  Residual r = bulk_residual(p, n, equal);
  r.error += std::log(bulk_share<double>(p, equal, loss));
  return r;
}

/// Error of ln G, and its slope by z*, with the shift.
inline Residual shifted_shear_residual(const Packing& p, const Network& n, const ShearFit& equal,
                                       double shift) {
  Packing shifted = p;
  shifted.mechanical_coordination += shift * unit_shift(p);
  return shear_residual(shifted, n, equal);
}

/// How many residuals each recipe has.
inline std::map<std::string, double> counts_of(const std::vector<Residual>& residuals) {
  std::map<std::string, double> counts;
  for (const Residual& r : residuals)
    counts[r.recipe] += 1;
  return counts;
}

/// What makes errors of G most likely beside the scatter of equal grains, over the root of the variance of
/// branches. Every recipe counts the same.
inline Scatter shear_size_scatter(const std::vector<Residual>& residuals,
                                  const std::vector<double>& variances, const ScatterParts& equal) {
  const std::map<std::string, double> counts = counts_of(residuals);
  std::vector<Deviation> deviations;
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    if (!(variances[k] > 0))
      continue;
    const Residual& r = residuals[k];
    const double of_equal = deviation(equal, r.sensitivity);
    deviations.push_back({.squared = r.error * r.error,
                          .squared_sensitivity = r.sensitivity * r.sensitivity,
                          .weight = 1 / counts.at(r.recipe),
                          .known = of_equal * of_equal,
                          .measure = variances[k]});
  }
  return most_likely_scatter(deviations);
}

/// What makes errors of K most likely beside the scatter of equal grains, over kernel::bulk_size_measure.
/// Every recipe counts the same.
inline double bulk_size_scatter(const std::vector<Residual>& residuals, const std::vector<double>& variances,
                                const ScatterParts& equal) {
  const std::map<std::string, double> counts = counts_of(residuals);
  double found = 0.01;
  for (int round = 0; round < 100; ++round) {
    double left = 0, weights = 0;
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      const Residual& r = residuals[k];
      const double known = std::pow(deviation(equal, r.sensitivity), 2);
      const double row = std::pow(kernel::bulk_size_measure(variances[k]), 2);
      const double weight = row / std::pow(known + found * row, 2) / counts.at(r.recipe);
      left += weight * (r.error * r.error - known);
      weights += weight * row;
    }
    found = std::max(0.0, left / weights);
  }
  return std::sqrt(found);
}

/// \param    packings     what all but the scatters is fitted to
/// \param    gradations   further ones for the scatters (gradations.hpp)
inline SizeEffect fit_size_effect(const std::vector<Packing>& packings,
                                  const std::vector<Packing>& gradations, const EqualFit& equal,
                                  const Choice& chosen) {
  const Fit<2> shift = fit_shift(packings, equal.shear, chosen);
  const Fit<2> loss = fit_loss(packings, equal.bulk, chosen);
  SizeEffect effect{.shift = shift.coefficients[0],
                    .shift_error = std::sqrt(shift.covariance(0, 0)),
                    .loss = loss.coefficients[0],
                    .loss_error = std::sqrt(loss.covariance(0, 0)),
                    .shear = {}};
  std::vector<Residual> G, K;
  std::vector<double> variances;
  for (const std::vector<Packing>* all : {&packings, &gradations})
    for (const Packing& p : *all)
      for (const Network& n : p.networks)
        if (is_usual(p, n) && chosen(p)) {
          G.push_back(shifted_shear_residual(p, n, equal.shear, effect.shift));
          K.push_back(lessened_bulk_residual(p, n, equal.bulk, effect.loss));
          variances.push_back(branch_variance(p));
        }
  effect.shear = shear_size_scatter(G, variances, equal.shear_scatter);
  effect.bulk = bulk_size_scatter(K, variances, equal.bulk_scatter);
  return effect;
}

} // namespace relaxation
