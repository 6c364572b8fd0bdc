// SPDX-License-Identifier: GPL-3.0-or-later
#include "probes.hpp"

#include <utility>

#include <granum/triaxial/probe.hpp>

namespace granum::studies {

analysis::Given known_of(const dem::Specimen& state, const dem::Material& material) {
  return {.law = material.law,
          .tangential_ratio = material.tangential_ratio,
          .void_ratio = dem::void_ratio(state)};
}

Probes run_probes(const dem::Specimen& state, const dem::Material& material,
                  const StopRequest& stop_requested) {
  const auto [hh, hv, vh] = triaxial::probe_all(state, material, {.stop_requested = stop_requested});
  return {.G_hh = hh.shear_modulus(),
          .G_hv = hv.shear_modulus(),
          .G_vh = vh.shear_modulus(),
          .amplitude = hh.amplitude};
}

ShearLoop shear_loop(const dem::Specimen& state, const dem::Material& material, double eta, double amplitude,
                     const StopRequest& stop_requested) {
  triaxial::ProbeResult result = triaxial::probe(state, material, triaxial::ShearMode::hh,
                                                 {.amplitude = amplitude,
                                                  .sliding = true,
                                                  .hold_normal_stress = true,
                                                  .loop_points = 5,
                                                  .force_tolerance = 1e-6,
                                                  .max_steps = 4000,
                                                  .stop_requested = stop_requested});
  return {.eta = eta, .amplitude = amplitude, .points = std::move(result.last_loop)};
}

} // namespace granum::studies
