// SPDX-License-Identifier: GPL-3.0-or-later
// How far packings lie from the fitted factors: those of one recipe from one another, and recipes from the
// curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "factor_fits.hpp"

namespace relaxation {

/// Standard deviation of ln of a factor: base, and gain times its sensitivity to what is hidden, in
/// quadrature.
struct Scatter {
  double base = 0;
  double gain = 0;
};

/// Random effects: a recipe has a deviation of its own, which all its packings share; each packing has
/// another.
struct ScatterParts {
  Scatter recipes;
  Scatter packings;
};

inline double squared_base(const ScatterParts& parts) {
  return parts.recipes.base * parts.recipes.base + parts.packings.base * parts.packings.base;
}

/// One network against the fit.
struct Residual {
  std::string recipe;     ///< contact and preparation
  double error = 0;       ///< ln of fitted over measured factor
  double sensitivity = 0; ///< of ln of the factor to what is hidden
};

/// What is hidden acts on G as a shift of z*.
inline Residual shear_residual(const Packing& p, const Network& n, const ShearFit& fit) {
  const double h = shear_model(p, n, fit.coefficients);
  const Inputs<double> in(p, n);
  const Dual<1> z(in.z, 1, 0);
  const Dual<1> slope =
      kernel::shear_relaxation(z, Dual<1>(in.r), Dual<1>(in.b), kernel::constants<Dual<1>>(fit.coefficients));
  return {p.recipe, std::log(h / shear_factor(p, n)), slope.derivatives()[0] / h};
}

/// ... and on K as a shift of ln r: the tangential forces that a packing carries are its own.
inline Residual bulk_residual(const Packing& p, const Network& n, const BulkFit& fit) {
  const double h = bulk_model(p, n, fit.coefficients);
  const Inputs<double> in(p, n);
  const Dual<1> r(in.r, 1, 0);
  const Dual<1> slope =
      kernel::bulk_relaxation(Dual<1>(in.z), r, Dual<1>(in.b), kernel::constants<Dual<1>>(fit.coefficients));
  return {p.recipe, std::log(h / bulk_factor(p, n)), in.r * slope.derivatives()[0] / h};
}

/// Residuals of the networks that are not much softer along their contacts than across.
template <class Fit>
std::vector<Residual> residuals(const std::vector<Packing>& packings, const Fit& fit,
                                Residual (*residual)(const Packing&, const Network&, const Fit&),
                                const Choice& chosen) {
  constexpr double lowest_ratio = 0.1;
  std::vector<Residual> all;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (p.isotropic() && chosen(p) && n.ratio >= lowest_ratio)
        all.push_back(residual(p, n, fit));
  return all;
}

/// A squared deviation that known + measure (base^2 + gain^2 sensitivity^2) is to explain, and how much it
/// counts.
struct Deviation {
  double squared = 0;
  double squared_sensitivity = 0;
  double weight = 1;
  double known = 0;
  double measure = 1;
};

/// The base and the gain that make the deviations most likely.
inline Scatter most_likely_scatter(const std::vector<Deviation>& deviations) {
  double v = 1e-3, w = 1e-4;
  for (int round = 0; round < 200; ++round) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const Deviation& d : deviations) {
      const Eigen::Vector2d row(d.measure, d.measure * d.squared_sensitivity);
      const double variance = d.known + v * row[0] + w * row[1];
      normal += d.weight * row * row.transpose() / (variance * variance);
      right += d.weight * row * (d.squared - d.known) / (variance * variance);
    }
    const Eigen::Vector2d next = normal.inverse() * right;
    v = std::max(next[0], 1e-8);
    w = std::max(next[1], 1e-12);
  }
  return {std::sqrt(v), std::sqrt(w)};
}

/// The same of deviations that known + measure s^2 is to explain: s.
inline double further_scatter(const std::vector<Deviation>& deviations) {
  double variance = 0.01;
  for (int round = 0; round < 100; ++round) {
    double left = 0, weights = 0;
    for (const Deviation& d : deviations) {
      const double weight = d.weight * d.measure / std::pow(d.known + variance * d.measure, 2);
      left += weight * (d.squared - d.known);
      weights += weight * d.measure;
    }
    variance = std::max(0.0, left / weights);
  }
  return std::sqrt(variance);
}

/// The scatter of all networks about the fit, every recipe counting the same, and what of it is left within
/// the recipes; the difference is the recipes' own.
inline ScatterParts scatter_parts(const std::vector<Residual>& residuals) {
  struct Recipe {
    double count = 0, sum = 0;
  };
  std::map<std::string, Recipe> recipes;
  for (const Residual& r : residuals) {
    recipes[r.recipe].count += 1;
    recipes[r.recipe].sum += r.error;
  }
  std::vector<Deviation> all, within;
  for (const Residual& r : residuals) {
    const auto& [count, sum] = recipes.at(r.recipe);
    const double squared_sensitivity = r.sensitivity * r.sensitivity;
    all.push_back({r.error * r.error, squared_sensitivity, 1 / count});
    const double from_mean = r.error - sum / count;
    if (count > 1)
      within.push_back({from_mean * from_mean * count / (count - 1), squared_sensitivity, 1 / count});
  }
  const Scatter total = most_likely_scatter(all), packings = most_likely_scatter(within);
  const auto rest = [](double whole, double part) {
    return std::sqrt(std::max(0.0, whole * whole - part * part));
  };
  return {.recipes = {rest(total.base, packings.base), rest(total.gain, packings.gain)},
          .packings = packings};
}

/// Standard deviation of ln of a factor of that sensitivity, for a packing of a recipe that the fit does not
/// know.
inline double deviation(const ScatterParts& parts, double sensitivity) {
  return std::hypot(std::hypot(parts.recipes.base, parts.packings.base),
                    sensitivity * std::hypot(parts.recipes.gain, parts.packings.gain));
}

} // namespace relaxation
