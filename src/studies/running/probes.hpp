// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/analysis/measure.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/triaxial/probe.hpp>

/// Measurements by DEM on specimens of granum.
namespace granum::studies {

/// Shear moduli of the three probes of one frozen state [Pa].
struct Probes {
  double G_hh = 0;
  double G_hv = 0;
  double G_vh = 0;
  double amplitude = 0; ///< shear strain [1]

  bool operator==(const Probes&) const = default;
};

/// Input of analysis::measure in addition to the contacts of a specimen: their law, and the void ratio.
[[nodiscard]] analysis::Given known_of(const dem::Specimen& state, const dem::Material& material);

/// Shear moduli of a frozen state by DEM.
/// \throws   NotConverged if a probe does not come to rest; Stopped on options.stop_requested
[[nodiscard]] Probes run_probes(const dem::Specimen& state, const dem::Material& material,
                                const triaxial::ProbeOptions& options);

} // namespace granum::studies
