// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/dem/state.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/shear_test.hpp>
#include <granum/verify/experiment.hpp>

namespace granum::verify {

/// Brings a copy of the state to rest at fixed cell and measures all that the experiment wants of it.
/// \param    at       where on its path the state was taken
/// \param    probed   whether to shear it by DEM as well
/// \param    notes    takes one more where probes did not come to rest: the state then goes without them
/// \throws   NotConverged if it does not come to rest, or its network is not solved; Stopped if so asked
[[nodiscard]] FrozenPoint frozen_point(const dem::State& state, const dem::Material& material,
                                       const triaxial::PathPoint& at, bool probed,
                                       std::vector<std::string>& notes, const StopRequest& stop_requested);

/// \throws   NotConverged if the probe did not come to rest
[[nodiscard]] double modulus_of(const triaxial::ProbeResult& result);

/// Shear moduli of a frozen state by DEM.
/// \throws   NotConverged if a probe does not come to rest; Stopped if so asked
[[nodiscard]] Probes run_probes(const dem::State& state, const dem::Material& material,
                                const StopRequest& stop_requested);

/// A cycle of horizontal shear with friction, normal stresses held. Near failure it need not come to rest.
/// \throws   Stopped if so asked
[[nodiscard]] ShearLoop shear_loop(const dem::State& state, const dem::Material& material, double eta,
                                   double amplitude, const StopRequest& stop_requested);

/// \throws   NotConverged if the ratio is beyond the limit
void require_rest(double unbalanced_force_ratio, const std::string& what,
                  double limit = triaxial::rest_bound);

} // namespace granum::verify
