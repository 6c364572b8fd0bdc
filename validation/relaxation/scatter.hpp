// SPDX-License-Identifier: GPL-3.0-or-later
// How far packings lie from the fitted factors: those of one recipe from one another, and recipes from the
// curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

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

  [[nodiscard]] double squared_base() const {
    return recipes.base * recipes.base + packings.base * packings.base;
  }
  /// Of ln of a factor of that sensitivity, for a packing of a recipe that the fit does not know.
  [[nodiscard]] double deviation(double sensitivity) const {
    return std::hypot(std::hypot(recipes.base, packings.base),
                      sensitivity * std::hypot(recipes.gain, packings.gain));
  }
};

/// One network against the fit.
struct Residual {
  std::string recipe;     ///< contact and preparation
  double error = 0;       ///< ln of fitted over measured factor
  double sensitivity = 0; ///< of ln of the factor to what is hidden
};

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
    double n00 = 0, n01 = 0, n11 = 0, right0 = 0, right1 = 0;
    for (const Deviation& d : deviations) {
      const double row0 = d.measure, row1 = d.measure * d.squared_sensitivity;
      const double variance = d.known + v * row0 + w * row1, weight = d.weight / (variance * variance);
      n00 += weight * row0 * row0;
      n01 += weight * row0 * row1;
      n11 += weight * row1 * row1;
      right0 += weight * row0 * (d.squared - d.known);
      right1 += weight * row1 * (d.squared - d.known);
    }
    const double determinant = n00 * n11 - n01 * n01;
    v = std::max((n11 * right0 - n01 * right1) / determinant, 1e-8);
    w = std::max((n00 * right1 - n01 * right0) / determinant, 1e-12);
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

/// How many have each recipe.
template <class OfRecipe>
std::map<std::string, double> counts_of(const std::vector<OfRecipe>& all) {
  std::map<std::string, double> counts;
  for (const OfRecipe& one : all)
    counts[one.recipe] += 1;
  return counts;
}

/// The scatter of all networks about the fit, every recipe counting the same, and what of it is left within
/// the recipes; the difference is the recipes' own.
inline ScatterParts scatter_parts(const std::vector<Residual>& residuals) {
  const std::map<std::string, double> counts = counts_of(residuals);
  std::map<std::string, double> sums;
  for (const Residual& r : residuals)
    sums[r.recipe] += r.error;
  std::vector<Deviation> all, within;
  for (const Residual& r : residuals) {
    const double count = counts.at(r.recipe), from_mean = r.error - sums.at(r.recipe) / count,
                 squared_sensitivity = r.sensitivity * r.sensitivity;
    all.push_back({r.error * r.error, squared_sensitivity, 1 / count});
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

} // namespace relaxation
