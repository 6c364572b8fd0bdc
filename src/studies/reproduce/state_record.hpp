// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce/experiment.hpp"
#include <granum/core/stop.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/triaxial/shear_test.hpp>

namespace granum::studies {

/// Brings a copy of the state to rest at fixed cell, measures it, and records the results.
/// \param    at       point of the path of the state
/// \param    probed   whether to shear it by DEM as well
/// \param    notes    gets a note if probes did not come to rest; the state is then without probes
/// \throws   NotConverged if it does not come to rest, or its network is not solved; Stopped if so
///           asked
[[nodiscard]] StateRecord state_record(const dem::Specimen& state, const dem::Material& material,
                                       const triaxial::PathPoint& at, bool probed,
                                       std::vector<std::string>& notes, const StopRequest& stop_requested);

/// A cycle of horizontal shear with friction at constant normal stresses. Near failure it need not come to
/// rest: the loop is drawn as it is.
/// \throws   Stopped on stop_requested
[[nodiscard]] ShearLoop shear_loop(const dem::Specimen& state, const dem::Material& material, double eta,
                                   double amplitude, const StopRequest& stop_requested);

} // namespace granum::studies
