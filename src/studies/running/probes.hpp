// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "studies/reproduce/experiment.hpp"
#include <granum/analysis/measure.hpp>
#include <granum/core/stop_request.hpp>
#include <granum/dem/specimen.hpp>

/// What studies measure by DEM on a specimen that granum made.
namespace granum::studies {

/// What analysis::measure needs beside the contacts of a specimen: their law, and the void ratio.
[[nodiscard]] analysis::Given known_of(const dem::Specimen& state, const dem::Material& material);

/// Shear moduli of a frozen state by DEM.
/// \throws   NotConverged if a probe does not come to rest; Stopped if stop_requested says so
[[nodiscard]] Probes run_probes(const dem::Specimen& state, const dem::Material& material,
                                const StopRequest& stop_requested);

/// A cycle of horizontal shear with friction, normal stresses held. Near failure it need not come to rest:
/// the loop is drawn as it is.
/// \throws   Stopped if stop_requested says so
[[nodiscard]] ShearLoop shear_loop(const dem::Specimen& state, const dem::Material& material, double eta,
                                   double amplitude, const StopRequest& stop_requested);

} // namespace granum::studies
