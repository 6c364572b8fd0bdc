// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/measures.hpp>

#include <algorithm>
#include <string>

#include <granum/assembly/coordination.hpp>
#include <granum/assembly/fabric_tensor.hpp>
#include <granum/core/error.hpp>
#include <granum/fabric/anisotropy_estimate.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/triaxial/probe.hpp>

namespace granum::triaxial {

Microstructure microstructure(const Assembly& assembly) {
  const MechanicalCoordination mechanical = mechanical_coordination(assembly, ContactKind::frictional);
  const fabric::AnisotropyEstimate anisotropy = fabric::estimate_anisotropy(contact_normals(assembly));
  const auto sliding = std::count_if(assembly.contacts.begin(), assembly.contacts.end(),
                                     [](const Contact& c) { return c.sliding; });
  return {.coordination_number = coordination_number(assembly),
          .mechanical_coordination_number = mechanical.coordination_number,
          .rattler_fraction = mechanical.rattler_fraction,
          .fabric_anisotropy = anisotropy.anisotropy,
          .fabric_anisotropy_error = anisotropy.standard_error,
          .sliding_fraction = static_cast<double>(sliding) / static_cast<double>(assembly.contacts.size())};
}

FrozenModuli frozen_moduli(const dem::State& state, const dem::Material& material) {
  constexpr double rest = 1e-6;
  const FrozenState frozen = freeze_in_place(state, material);
  if (!(frozen.report.unbalanced_force_ratio < rest))
    throw NotConverged("frozen state: unbalanced force ratio " +
                       std::to_string(frozen.report.unbalanced_force_ratio) + " after " +
                       std::to_string(frozen.report.steps) + " steps");
  const network::Response response = network::linear_response(dem::freeze(frozen.state, material));
  return {.relaxed = response.relaxed(),
          .affine = response.affine(),
          .stress = frozen.report.stress,
          .unbalanced_force_ratio = frozen.report.unbalanced_force_ratio};
}

} // namespace granum::triaxial
