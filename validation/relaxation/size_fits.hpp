// SPDX-License-Identifier: GPL-3.0-or-later
// What unequal grains add to the relaxation factors, fitted to unequal.csv, and their scatters to
// gradations.csv too, with the factors of equal grains given; and whether stated errors hold.
#pragma once

#include "../common.hpp"
#include "factors.hpp"

namespace relaxation {

/// As it is, of equal grains.
struct SizeEffect {
  double shift = 0;       ///< of z* in G at the isostatic point, over the relative variance of branches
  double shift_error = 0; ///< its standard error
  double loss = 1;        ///< of K, as kernel::size_bulk_share has it
  double loss_error = 0;  ///< its standard error
  Scatter shear = {};     ///< standard deviation over the root of that variance
  double bulk = 0;        ///< the same of K, over kernel::bulk_size_measure
};

inline double branch_variance(const Packing& p) { return kernel::branch_variance(p.state.contacts); }

/// What a shift of 1 adds to z*.
inline double unit_shift(const Packing& p) {
  return branch_variance(p) * kernel::looseness(p.mechanical_coordination);
}

/// G over that of the closed form, as equal grains of a shifted z* have it.
template <class T>
T shifted_shear(const Packing& p, const Network& n, const Numbers<double, Shear::size>& c, const T& shift) {
  return Shear::model<T>(p.mechanical_coordination + shift * unit_shift(p), n.ratio, p.exponent(),
                         kernel::constants<T>(c));
}

/// K of unequal grains over that of equal ones.
template <class T>
T bulk_share(const Packing& p, const Numbers<double, Bulk::size>& c, const T& loss) {
  return kernel::size_bulk_share<T>(p.mechanical_coordination, kernel::own_exponent(T(p.exponent())), loss,
                                    branch_variance(p), kernel::constants<T>(c));
}

/// Isotropic states of usual contacts, which all fits and errors of this file are about.
inline bool is_usual(const Packing& p, const Network& n) {
  return p.isotropic() && n.ratio >= lowest_usual_ratio && p.relative_overlap < largest_overlap &&
         p.mechanical_coordination >= 4.2;
}

/// Fits one number of the sizes to ln of a factor, beside what small specimens are stiffer than large ones,
/// which the equal grains of the same file show.
/// \param    model      the factor, of a packing, a network and that number
/// \param    measured   the same, of a packing and a network
template <class Model, class Measured>
Fit<2> fit_beside_specimens(const std::vector<Packing>& packings, const Choice& chosen, const Model& model,
                            const Measured& measured) {
  using D = Dual<2>;
  std::vector<Observation<2>> rows;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (is_usual(p, n) && chosen(p))
        rows.push_back({[=](const Numbers<D, 2>& k) { return log(model(p, n, k[0])) + k[1]; }, measured(p, n),
                        1, p.recipe});
  return least_squares<2>(std::move(rows), {0.5, 0.01});
}

/// Error of ln K with the loss.
inline Residual lessened_bulk_residual(const Packing& p, const Network& n, const EqualFit& equal,
                                       double loss) {
  Residual r = residual(equal.bulk, p, n);
  r.error += std::log(bulk_share<double>(p, equal.bulk.coefficients, loss));
  return r;
}

/// Error of ln G, and its slope by z*, with the shift.
inline Residual shifted_shear_residual(const Packing& p, const Network& n, const EqualFit& equal,
                                       double shift) {
  Packing shifted = p;
  shifted.mechanical_coordination += shift * unit_shift(p);
  return residual(equal.shear, shifted, n);
}

/// What residuals deviate beside the scatter of equal grains, over that measure of the variance of branches.
/// Every recipe counts the same.
template <class Measure>
std::vector<Deviation> size_deviations(const std::vector<Residual>& residuals,
                                       const std::vector<double>& variances, const ScatterParts& equal,
                                       const Measure& measure) {
  const std::map<std::string, double> counts = counts_of(residuals);
  std::vector<Deviation> deviations;
  for (std::size_t k = 0; k < residuals.size(); ++k)
    if (const Residual& r = residuals[k]; variances[k] > 0)
      deviations.push_back({.squared = r.error * r.error,
                            .squared_sensitivity = r.sensitivity * r.sensitivity,
                            .weight = 1 / counts.at(r.recipe),
                            .known = std::pow(equal.deviation(r.sensitivity), 2),
                            .measure = measure(variances[k])});
  return deviations;
}
inline Scatter shear_size_scatter(const std::vector<Residual>& residuals,
                                  const std::vector<double>& variances, const ScatterParts& equal) {
  return most_likely_scatter(size_deviations(residuals, variances, equal, [](double v) { return v; }));
}
inline double bulk_size_scatter(const std::vector<Residual>& residuals, const std::vector<double>& variances,
                                const ScatterParts& equal) {
  return further_scatter(size_deviations(residuals, variances, equal,
                                         [](double v) { return std::pow(kernel::bulk_size_measure(v), 2); }));
}

/// \param    packings     what all but the scatters is fitted to
/// \param    gradations   further ones for the scatters
inline SizeEffect fit_size_effect(const std::vector<Packing>& packings,
                                  const std::vector<Packing>& gradations, const EqualFit& equal,
                                  const Choice& chosen) {
  using D = Dual<2>;
  const Fit<2> shift = fit_beside_specimens(
      packings, chosen,
      [&equal](const Packing& p, const Network& n, const D& s) {
        return shifted_shear<D>(p, n, equal.shear.coefficients, s);
      },
      [](const Packing& p, const Network& n) { return std::log(Shear::measured(p, n)); });
  const Fit<2> loss = fit_beside_specimens(
      packings, chosen,
      [&equal](const Packing& p, const Network&, const D& l) {
        return bulk_share<D>(p, equal.bulk.coefficients, l);
      },
      [&equal](const Packing& p, const Network& n) { return -residual(equal.bulk, p, n).error; });
  SizeEffect effect{.shift = shift.coefficients[0],
                    .shift_error = shift.error(0),
                    .loss = loss.coefficients[0],
                    .loss_error = loss.error(0)};
  std::vector<Residual> G, K;
  std::vector<double> variances;
  for (const std::vector<Packing>* all : {&packings, &gradations})
    for (const Packing& p : *all)
      for (const Network& n : p.networks)
        if (is_usual(p, n) && chosen(p)) {
          G.push_back(shifted_shear_residual(p, n, equal, effect.shift));
          K.push_back(lessened_bulk_residual(p, n, equal, effect.loss));
          variances.push_back(branch_variance(p));
        }
  effect.shear = shear_size_scatter(G, variances, equal.shear.scatter);
  effect.bulk = bulk_size_scatter(K, variances, equal.bulk.scatter);
  return effect;
}

// ---- stated errors ----

/// An error of ln of a factor and what it is stated to be.
struct Judged {
  double error = 0;
  double stated = 0;
};

inline Judged judged_shear(const Packing& p, const Network& n, const EqualFit& equal,
                           const SizeEffect& effect) {
  const double root = std::sqrt(branch_variance(p));
  const Residual G = shifted_shear_residual(p, n, equal, effect.shift);
  const double by_shift =
      std::abs(G.sensitivity) * std::hypot(root * effect.shear.gain, unit_shift(p) * effect.shift_error);
  return {G.error,
          std::hypot(stated_error(equal.shear, p, n, G.sensitivity), root * effect.shear.base, by_shift)};
}

/// \param    codes   scatter of K between codes; 0 among granum's own packings
inline Judged judged_bulk(const Packing& p, const Network& n, const EqualFit& equal, const SizeEffect& effect,
                          double codes = 0) {
  const Residual K = lessened_bulk_residual(p, n, equal, effect.loss);
  const double by_loss =
      (1 - bulk_share<double>(p, equal.bulk.coefficients, effect.loss)) / effect.loss * effect.loss_error;
  const double by_sizes = kernel::bulk_size_measure(branch_variance(p)) * effect.bulk;
  const double of_granum =
      std::hypot(stated_error(equal.bulk, p, n, K.sensitivity), std::hypot(by_sizes, by_loss));
  return {K.error, std::hypot(of_granum, codes * kernel::looseness(p.mechanical_coordination))};
}

/// Errors of the chosen packings against what they are stated to be.
inline ErrorsOfBoth coverage_of(const std::vector<Packing>& packings, const EqualFit& equal,
                                const SizeEffect& effect, const Choice& chosen, double codes = 0) {
  ErrorsOfBoth all;
  for (const Packing& p : packings)
    for (const Network& n : p.networks) {
      if (!is_usual(p, n) || !chosen(p) || p.mechanical_coordination < lowest_usual_coordination)
        continue;
      const Judged G = judged_shear(p, n, equal, effect), K = judged_bulk(p, n, equal, effect, codes);
      all.G.add(G.error, G.stated);
      all.K.add(K.error, K.stated);
    }
  return all;
}

// ---- packings of other codes ----

/// The code whose packings the scatter is taken from; those of any other code judge it.
inline bool is_calibrating_code(const Packing& p) { return p.preparation.starts_with("lammps"); }

/// How far K of packings that other codes made lies from the curve of granum's own: the standard deviation of
/// ln K over the looseness that makes the errors most likely, beyond what is stated of granum's own packings.
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
