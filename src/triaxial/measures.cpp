// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/measures.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include <granum/assembly/coordination.hpp>
#include <granum/assembly/fabric_tensor.hpp>
#include <granum/core/error.hpp>
#include <granum/dem/walls.hpp>
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

InteriorMeasures interior_measures(const dem::State& state, const dem::Material& material, double layer) {
  const Assembly assembly = dem::freeze(state, material);
  const dem::Interior interior(state.cell, layer);
  const MechanicalCoordination mechanical = mechanical_coordination(assembly, ContactKind::frictional);
  InteriorMeasures out;
  std::vector<bool> inside(assembly.grain_count());
  std::size_t rattlers = 0;
  double solid = 0;
  for (std::size_t g = 0; g < inside.size(); ++g) {
    solid += interior.part_of_sphere(assembly.position[g], assembly.radius[g]);
    inside[g] = interior.holds(assembly.position[g]);
    out.grains += inside[g];
    rattlers += inside[g] && mechanical.rattler[g];
  }
  if (out.grains == rattlers)
    throw InvalidArgument("layer at the walls", layer, "m", "a range that leaves grains that bear load");
  out.void_ratio = interior.volume() / solid - 1;
  const auto add_stress = [&](const Contact& c) {
    out.stress +=
        interior.share(assembly.position[c.i], c.branch) / interior.volume() * outer(force(c), c.branch);
  };
  std::size_t ends = 0, bearing_ends = 0, sliding = 0;
  std::vector<Vec3> normals;
  for (const Contact& c : assembly.contacts) {
    const std::size_t here = static_cast<std::size_t>(inside[c.i]) + static_cast<std::size_t>(inside[c.j]);
    ends += here;
    bearing_ends += mechanical.rattler[c.i] || mechanical.rattler[c.j] ? 0 : here;
    add_stress(c);
    if (interior.holds(assembly.position[c.i] + 0.5 * c.branch)) {
      normals.push_back(normal(c));
      sliding += c.sliding;
    }
  }
  for (const Contact& c : assembly.wall_contacts)
    add_stress(c);
  const fabric::AnisotropyEstimate anisotropy = fabric::estimate_anisotropy(normals);
  const auto share = [](std::size_t part, std::size_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);
  };
  out.micro = {.coordination_number = share(ends, out.grains),
               .mechanical_coordination_number = share(bearing_ends, out.grains - rattlers),
               .rattler_fraction = share(rattlers, out.grains),
               .fabric_anisotropy = anisotropy.anisotropy,
               .fabric_anisotropy_error = anisotropy.standard_error,
               .sliding_fraction = share(sliding, normals.size())};
  return out;
}

FrozenModuli frozen_moduli(const dem::State& state, const dem::Material& material, double force_tolerance,
                           const StopRequest& stop_requested) {
  const FrozenState frozen = freeze_in_place(state, material, force_tolerance, stop_requested);
  if (!(frozen.report.unbalanced_force_ratio < std::max(rest_bound, force_tolerance)))
    throw NotConverged("frozen state: unbalanced force ratio " +
                       std::to_string(frozen.report.unbalanced_force_ratio) + " after " +
                       std::to_string(frozen.report.steps) + " steps");
  const network::Response response =
      network::linear_response(dem::freeze(frozen.state, material), {.stop_requested = stop_requested});
  return {.relaxed = response.relaxed(),
          .affine = response.affine(),
          .stress = frozen.report.stress,
          .unbalanced_force_ratio = frozen.report.unbalanced_force_ratio};
}

} // namespace granum::triaxial
