// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <granum/estimate/answer.hpp>

#include "sweep.hpp"

/// G/G0 and damping over the shear strain, for programs of site response: granum sweep --strain FROM..TO.
/// Checked by tests/cli/test_curves.cpp
namespace granum::cli {

/// The answer at a strain.
struct StrainPoint {
  double strain = 0;                       ///< amplitude of the shear strain [1]
  estimate::Range ratio, damping, modulus; ///< G/G0 [1], damping ratio [1], G [Pa]
};

/// A state, and its curve.
struct StrainCurve {
  std::string name;                     ///< no other curve has it
  std::optional<double> depth = {};     ///< in the ground [m]
  std::optional<std::size_t> line = {}; ///< of the table
  double mean_stress = 0;               ///< effective [Pa]
  double unit_weight = 0;               ///< with the water in its pores [N/m3]
  estimate::Range modulus, speed;       ///< G [Pa] and V_s [m/s] at small strain
  std::vector<StrainPoint> points = {}; ///< strains increase
};

/// Curves as models of pystrata, with its keys: strains and values as fractions, in TOML.
/// \param    comments   lines above them
/// [pystrata, site.py: names are unique, strains positive, G/G0 in (0, 1], damping in [0, 0.49]]
[[nodiscard]] std::string pystrata_text(const std::vector<StrainCurve>& curves,
                                        const std::vector<std::string>& comments);
/// Curves as soil types of Strata, in JSON: strains and damping in per cent, mean stress in atm, unit weight
/// in kN/m3. That of a single state, `alone`, is an object; others are an array, as in the catalogue of a
/// Strata file.
/// [Strata, SoilType.cpp and NonlinearProperty.cpp: strains increase, three or more]
[[nodiscard]] std::string strata_text(const std::vector<StrainCurve>& curves,
                                      const std::vector<std::string>& comments, bool alone);
/// Curves as rows of a table: strain in per cent, G/G0, damping in per cent, and their ranges.
/// \param    alone   whether it is the curve of a single state; otherwise columns of the state come first
[[nodiscard]] Table curve_table(const std::vector<StrainCurve>& curves, bool alone);

/// Their strains, G/G0 and damping with their ranges, for a page.
[[nodiscard]] Table shown_curves(const std::vector<StrainCurve>& curves);

/// Answers the states of the options for each strain, and prints the curves.
/// \throws   InvalidArgument if the first state has no answer, and for spheres, which have no law of strain
ExitCode sweep_curves(const SweepOptions& options);

} // namespace granum::cli
