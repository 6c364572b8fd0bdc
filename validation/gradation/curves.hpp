// SPDX-License-Identifier: GPL-3.0-or-later
// G against the void ratio of each gradation of validation/gradation.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "states.hpp"

namespace gradation {

/// Means over the seeds of one gradation and preparation, or between two of them.
struct Point {
  std::string preparation = {}; ///< empty between two
  int seeds = 0;
  double void_ratio = 0;
  double z_star = 0;
  double rattler_fraction = 0;
  double closed = 0;               ///< G of rung 3, means over contacts counted [Pa]
  double from_sizes = 0;           ///< the same, means over contacts from the distribution [Pa]
  double network = 0;              ///< [Pa]
  double probe = 0;                ///< of those seeds whose probes converged; NaN without any [Pa]
  double stated = 0;               ///< error of rung 3 over its value [1]
  double closed_bulk_modulus = 0;  ///< K of rung 3 [Pa]
  double network_bulk_modulus = 0; ///< [Pa]
  double stated_bulk_error = 0;    ///< error of rung 3 over its value [1]
  double uniform_strain = 0;       ///< G of rung 2 [Pa]
  double affine = 0;               ///< the same of the network [Pa]
};

/// Of one gradation, from its densest preparation to its loosest.
struct Curve {
  std::string sizes;
  double uniformity = 0; ///< C_u, mean of the packings
  std::vector<Point> points;

  [[nodiscard]] bool holds(double void_ratio) const {
    return void_ratio >= points.front().void_ratio && void_ratio <= points.back().void_ratio;
  }
  /// 1 is the densest packing, 0 that of friction 0.3.
  [[nodiscard]] double void_ratio_of(double relative_density) const {
    return loose() - relative_density * (loose() - dense());
  }
  [[nodiscard]] double relative_density_of(double void_ratio) const {
    return (loose() - void_ratio) / (loose() - dense());
  }
  /// Straight between neighbours.
  [[nodiscard]] Point at(double void_ratio) const {
    std::size_t k = 1;
    while (k + 1 < points.size() && points[k].void_ratio < void_ratio)
      ++k;
    const Point &low = points[k - 1], &high = points[k];
    const double t = (void_ratio - low.void_ratio) / (high.void_ratio - low.void_ratio);
    const auto between = [&](double Point::*member) {
      return low.*member + t * (high.*member - low.*member);
    };
    return {.preparation = {},
            .seeds = 0,
            .void_ratio = void_ratio,
            .z_star = between(&Point::z_star),
            .rattler_fraction = between(&Point::rattler_fraction),
            .closed = between(&Point::closed),
            .from_sizes = between(&Point::from_sizes),
            .network = between(&Point::network),
            .probe = between(&Point::probe),
            .stated = between(&Point::stated),
            .closed_bulk_modulus = between(&Point::closed_bulk_modulus),
            .network_bulk_modulus = between(&Point::network_bulk_modulus),
            .stated_bulk_error = between(&Point::stated_bulk_error),
            .uniform_strain = between(&Point::uniform_strain),
            .affine = between(&Point::affine)};
  }

 private:
  [[nodiscard]] double dense() const { return points.front().void_ratio; }
  [[nodiscard]] double loose() const {
    const auto it = std::find_if(points.begin(), points.end(),
                                 [](const Point& p) { return p.preparation == "gas mu0.3"; });
    return (it == points.end() ? points.back() : *it).void_ratio;
  }
};

inline Point mean_point(const std::vector<State>& seeds) {
  const auto mean = [&seeds](const std::function<std::optional<double>(const State&)>& of) {
    double sum = 0, count = 0;
    for (const State& s : seeds)
      if (const std::optional<double> value = of(s)) {
        sum += *value;
        count += 1;
      }
    return sum / count;
  };
  return {.preparation = seeds.front().preparation,
          .seeds = static_cast<int>(seeds.size()),
          .void_ratio = mean([](const State& s) { return s.void_ratio(); }),
          .z_star = mean([](const State& s) { return s.z_star; }),
          .rattler_fraction = mean([](const State& s) { return s.rattler_fraction; }),
          .closed = mean([](const State& s) { return closed_forms(s).relaxed; }),
          .from_sizes = mean([](const State& s) { return closed_forms(s).relaxed_from_sizes; }),
          .network = mean([](const State& s) { return s.network; }),
          .probe = mean([](const State& s) { return s.probe(); }),
          .stated = mean([](const State& s) { return closed_forms(s).stated_error; }),
          .closed_bulk_modulus = mean([](const State& s) { return closed_forms(s).bulk_modulus; }),
          .network_bulk_modulus = mean([](const State& s) { return s.network_bulk_modulus; }),
          .stated_bulk_error = mean([](const State& s) { return closed_forms(s).stated_bulk_error; }),
          .uniform_strain = mean([](const State& s) { return closed_forms(s).uniform_strain; }),
          .affine = mean([](const State& s) { return s.affine; })};
}

/// Curves of all gradations of the usual size, by C_u.
inline std::vector<Curve> curves(const std::vector<State>& states) {
  std::map<std::string, std::map<std::string, std::vector<State>>> groups;
  for (const State& s : states)
    if (s.mean_radius == usual_radius)
      groups[s.sizes][s.preparation].push_back(s);
  std::vector<Curve> all;
  for (const auto& [sizes, by_preparation] : groups) {
    Curve curve;
    curve.sizes = sizes;
    double packings = 0;
    for (const auto& [preparation, seeds] : by_preparation) {
      curve.points.push_back(mean_point(seeds));
      for (const State& s : seeds) {
        curve.uniformity += s.uniformity;
        packings += 1;
      }
    }
    curve.uniformity /= packings;
    std::sort(curve.points.begin(), curve.points.end(),
              [](const Point& a, const Point& b) { return a.void_ratio < b.void_ratio; });
    if (curve.points.size() > 1)
      all.push_back(curve);
  }
  std::sort(all.begin(), all.end(),
            [](const Curve& a, const Curve& b) { return a.uniformity < b.uniformity; });
  return all;
}

} // namespace gradation
