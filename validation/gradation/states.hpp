// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded states of validation/gradation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/sizes/distribution.hpp>

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
  std::string sizes;
  std::string preparation;
  double seed = 0;
  double mean_radius = 0; ///< by number [m]
  double uniformity = 0;  ///< C_u
  double z_star = 0;
  double rattler_fraction = 0;
  effective::State counted; ///< with the means over contacts as they were counted
  ClosedForms recorded;
  double affine = 0;               ///< G of the network under uniform strain [Pa]
  double network = 0;              ///< G of the network, nearest isotropic solid [Pa]
  double network_bulk_modulus = 0; ///< [Pa]
  std::array<Probe, 3> probes;

  [[nodiscard]] double void_ratio() const { return counted.void_ratio; }
  [[nodiscard]] bool dense() const { return preparation == "dense"; }
  [[nodiscard]] bool probed() const {
    return std::all_of(probes.begin(), probes.end(), [](const Probe& p) { return p.converged; });
  }
  /// Mean of the three shear modes; nothing unless all converged [Pa].
  [[nodiscard]] std::optional<double> probe() const {
    if (!probed())
      return std::nullopt;
    return (probes[0].modulus + probes[1].modulus + probes[2].modulus) / 3;
  }
  [[nodiscard]] std::string name() const {
    return "C_u " + granum::short_text(uniformity, 2) + ", " + preparation + " #" + granum::short_text(seed);
  }
};

inline State state(const relaxation::detail::Row& row, const std::string& sizes,
                   const std::string& preparation) {
  const double ratio = contact::mindlin_stiffness_ratio(0.15);
  State s{.sizes = sizes,
          .preparation = preparation,
          .seed = row.at("seed"),
          .mean_radius = row.at("mean_radius_m"),
          .uniformity = row.at("C_u"),
          .z_star = row.at("z_star"),
          .rattler_fraction = row.at("rattler_fraction"),
          .counted = relaxation::detail::state(row, "sphere", ratio),
          .recorded = {.uniform_strain = row.at("G_uniform_strain_Pa"),
                       .relaxed = row.at("G_closed_Pa"),
                       .stated_error = row.at("G_closed_stated"),
                       .bulk_modulus = 0,
                       .stated_bulk_error = 0,
                       .relaxed_from_sizes = row.at("G_closed_sizes_Pa")},
          .affine = row.at("G_affine_Pa"),
          .network = row.at("G_network_Pa"),
          .network_bulk_modulus = row.at("K_network_Pa"),
          .probes = {}};
  const struct {
    const char* mode;
    const char* constant;
  } modes[] = {{"hh", "C66"}, {"hv", "C55"}, {"vh", "C55"}};
  for (std::size_t k = 0; k < s.probes.size(); ++k) {
    const std::string mode = modes[k].mode;
    s.probes[k] = {.network = row.at(modes[k].constant + std::string("_network_Pa")),
                   .modulus = row.at("G_" + mode + "_probe_Pa"),
                   .converged = row.at("converged_" + mode) == 1};
  }
  return s;
}

inline std::vector<State> read_states(const std::filesystem::path& path) {
  const io::CsvTable table = io::read_csv(path);
  std::vector<State> states;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::vector<std::string>& fields = table.fields(k);
    states.push_back(state(relaxation::detail::numbers(table.headings(), fields), fields[0], fields[1]));
  }
  return states;
}

/// What the library says of a state now.
inline ClosedForms closed_forms(const State& s) {
  return closed_forms(s.counted, s.z_star, s.rattler_fraction, sizes::parse_distribution(s.sizes),
                      s.mean_radius);
}

} // namespace gradation
