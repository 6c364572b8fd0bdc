// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded states of validation/gradation, and G of each gradation against the void ratio.
#pragma once

#include <granum/sizes/distribution.hpp>

#include "../common.hpp"
#include "../relaxation/reading.hpp"
#include "closed_forms.hpp"

namespace gradation {

inline constexpr double usual_radius = 0.5e-3; ///< mean by number [m]

/// A modulus of the network, and what the probe of that shear mode has for it.
struct Probe {
  double network = 0; ///< [Pa]
  double modulus = 0; ///< [Pa]
  bool converged = false;
};

/// One row of states.csv.
struct State {
  std::string sizes, preparation;
  double seed = 0;
  double mean_radius = 0; ///< by number [m]
  double uniformity = 0;  ///< C_u
  double void_ratio = 0, z_star = 0, rattler_fraction = 0;
  ClosedForms recorded = {}, now = {}; ///< what the closed forms said when it was recorded, and say now
  double affine = 0;                   ///< G of the network under uniform strain [Pa]
  double network = 0;                  ///< G of the network, nearest isotropic solid [Pa]
  double network_bulk_modulus = 0;     ///< [Pa]
  std::array<Probe, 3> probes = {};

  [[nodiscard]] bool dense() const { return preparation == "dense"; }
  [[nodiscard]] bool usual() const { return mean_radius == usual_radius; }
  [[nodiscard]] bool probed() const {
    return std::ranges::all_of(probes, [](const Probe& p) { return p.converged; });
  }
  /// Mean of the three shear modes; not a number unless all converged [Pa].
  [[nodiscard]] double probe() const {
    return probed() ? (probes[0].modulus + probes[1].modulus + probes[2].modulus) / 3 : std::nan("");
  }
  [[nodiscard]] std::string name() const {
    return "C_u " + short_text(uniformity, 2) + ", " + preparation + " #" + short_text(seed);
  }
};

inline State state(const Entry& row) {
  State s{.sizes = row.text("sizes"),
          .preparation = row.text("preparation"),
          .seed = row("seed"),
          .mean_radius = row("mean_radius_m"),
          .uniformity = row("C_u"),
          .void_ratio = row("e"),
          .z_star = row("z_star"),
          .rattler_fraction = row("rattler_fraction"),
          .recorded = {.uniform_strain = row("G_uniform_strain_Pa"),
                       .relaxed = row("G_closed_Pa"),
                       .stated_error = row("G_closed_stated"),
                       .relaxed_from_sizes = row("G_closed_sizes_Pa")},
          .affine = row("G_affine_Pa"),
          .network = row("G_network_Pa"),
          .network_bulk_modulus = row("K_network_Pa")};
  s.now = closed_forms(relaxation::detail::state(row, "sphere", contact::mindlin_stiffness_ratio(0.15)),
                       s.z_star, s.rattler_fraction, sizes::parse_distribution(s.sizes), s.mean_radius);
  constexpr std::array<std::array<const char*, 2>, 3> modes{{{"hh", "C66"}, {"hv", "C55"}, {"vh", "C55"}}};
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const std::string mode = modes[k][0], constant = modes[k][1];
    s.probes[k] = {row(constant + "_network_Pa"), row("G_" + mode + "_probe_Pa"),
                   row("converged_" + mode) == 1};
  }
  return s;
}

inline std::vector<State> read_states(const std::string& path) {
  std::vector<State> states;
  for (const Entry& row : read_record(path))
    states.push_back(state(row));
  return states;
}

// ---- curves ----

/// Means over the seeds of one gradation and preparation, or between two of them.
struct Point {
  std::string preparation = {}; ///< empty between two
  int seeds = 0;
  double void_ratio = 0, z_star = 0, rattler_fraction = 0;
  double closed = 0,
         from_sizes = 0;          ///< G of rung 3, means over contacts counted or from the distribution [Pa]
  double network = 0, affine = 0; ///< G of the network, relaxed or under uniform strain [Pa]
  double probe = 0;               ///< of those seeds whose probes converged; NaN without any [Pa]
  double stated = 0, stated_bulk_error = 0;                 ///< errors of rung 3 over its values [1]
  double closed_bulk_modulus = 0, network_bulk_modulus = 0; ///< [Pa]
  double uniform_strain = 0;                                ///< G of rung 2 [Pa]
};

/// Every number of a point, and the one of a state that it is the mean of.
struct PointMember {
  double Point::*of;
  double (*from)(const State&);
};
inline constexpr PointMember point_members[] = {
    {&Point::void_ratio, [](const State& s) { return s.void_ratio; }},
    {&Point::z_star, [](const State& s) { return s.z_star; }},
    {&Point::rattler_fraction, [](const State& s) { return s.rattler_fraction; }},
    {&Point::closed, [](const State& s) { return s.now.relaxed; }},
    {&Point::from_sizes, [](const State& s) { return s.now.relaxed_from_sizes; }},
    {&Point::network, [](const State& s) { return s.network; }},
    {&Point::affine, [](const State& s) { return s.affine; }},
    {&Point::probe, [](const State& s) { return s.probe(); }},
    {&Point::stated, [](const State& s) { return s.now.stated_error; }},
    {&Point::stated_bulk_error, [](const State& s) { return s.now.stated_bulk_error; }},
    {&Point::closed_bulk_modulus, [](const State& s) { return s.now.bulk_modulus; }},
    {&Point::network_bulk_modulus, [](const State& s) { return s.network_bulk_modulus; }},
    {&Point::uniform_strain, [](const State& s) { return s.now.uniform_strain; }},
};

inline Point mean_point(const std::vector<State>& seeds) {
  Point mean{.preparation = seeds.front().preparation, .seeds = static_cast<int>(seeds.size())};
  for (const auto& [of, from] : point_members) {
    double sum = 0, count = 0;
    for (const State& s : seeds)
      if (const double value = from(s); !std::isnan(value)) {
        sum += value;
        count += 1;
      }
    mean.*of = sum / count;
  }
  return mean;
}

/// Of one gradation, from its densest preparation to its loosest.
struct Curve {
  double uniformity = 0; ///< C_u, mean of the packings
  std::vector<Point> points = {};

  [[nodiscard]] bool holds(double void_ratio) const {
    return void_ratio >= points.front().void_ratio && void_ratio <= points.back().void_ratio;
  }
  /// 1 is the densest packing, 0 that of friction 0.3.
  [[nodiscard]] double void_ratio_of(double relative_density) const {
    return loose() - relative_density * (loose() - points.front().void_ratio);
  }
  [[nodiscard]] double relative_density_of(double void_ratio) const {
    return (loose() - void_ratio) / (loose() - points.front().void_ratio);
  }
  /// Straight between neighbours.
  [[nodiscard]] Point at(double void_ratio) const {
    std::size_t k = 1;
    while (k + 1 < points.size() && points[k].void_ratio < void_ratio)
      ++k;
    const Point &low = points[k - 1], &high = points[k];
    const double t = (void_ratio - low.void_ratio) / (high.void_ratio - low.void_ratio);
    Point between;
    for (const auto& [of, from] : point_members)
      between.*of = low.*of + t * (high.*of - low.*of);
    between.void_ratio = void_ratio;
    return between;
  }

 private:
  [[nodiscard]] double loose() const {
    const auto it = std::ranges::find(points, "gas mu0.3", &Point::preparation);
    return (it == points.end() ? points.back() : *it).void_ratio;
  }
};

/// Curves of all gradations of the usual size, by C_u.
inline std::vector<Curve> curves(const std::vector<State>& states) {
  std::map<std::string, std::map<std::string, std::vector<State>>> groups;
  for (const State& s : states)
    if (s.usual())
      groups[s.sizes][s.preparation].push_back(s);
  std::vector<Curve> all;
  for (const auto& [sizes, by_preparation] : groups) {
    Curve curve;
    double packings = 0;
    for (const auto& [preparation, seeds] : by_preparation) {
      curve.points.push_back(mean_point(seeds));
      for (const State& s : seeds) {
        curve.uniformity += s.uniformity;
        packings += 1;
      }
    }
    curve.uniformity /= packings;
    std::ranges::sort(curve.points, {}, &Point::void_ratio);
    if (curve.points.size() > 1)
      all.push_back(curve);
  }
  std::ranges::sort(all, {}, &Curve::uniformity);
  return all;
}

} // namespace gradation
