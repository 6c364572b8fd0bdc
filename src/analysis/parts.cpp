// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/parts.hpp>

#include <optional>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/fabric/estimates.hpp>
#include <granum/packing/interior.hpp>

namespace granum::analysis {

packing::Assembly counted_part(const packing::Assembly& assembly, const contact::NormalLaw& law) {
  packing::Assembly counted = assembly;
  if (law.surface().begins_at_touch)
    return counted;
  double mean = 0;
  for (const packing::Contact& c : assembly.contacts)
    mean += c.normal_force / static_cast<double>(assembly.contacts.size());
  if (!(mean > 0))
    return counted;
  constexpr double hardly = 0.05;
  const double least = hardly * law.stiffness_at_force(mean);
  std::erase_if(counted.contacts, [&](const packing::Contact& c) {
    return !(c.normal_force > 0 && law.stiffness_at_force(c.normal_force) >= least);
  });
  return counted;
}

namespace {

/// Empty if no grain inside carries load.
std::optional<InteriorMeasures> measures_of(const packing::Assembly& assembly,
                                            const packing::MechanicalCoordination& mechanical,
                                            const packing::Interior& interior) {
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
    return std::nullopt;
  out.void_ratio = interior.volume() / solid - 1;
  const auto add_stress = [&](const packing::Contact& c) {
    out.stress +=
        interior.share(assembly.position[c.i], c.branch) / interior.volume() * outer(force(c), c.branch);
  };
  std::size_t ends = 0, bearing_ends = 0, sliding = 0;
  std::vector<Vec3> normals;
  for (const packing::Contact& c : assembly.contacts) {
    const std::size_t here = static_cast<std::size_t>(inside[c.i]) + static_cast<std::size_t>(inside[c.j]);
    ends += here;
    bearing_ends += mechanical.rattler[c.i] || mechanical.rattler[c.j] ? 0 : here;
    add_stress(c);
    if (interior.holds(assembly.position[c.i] + 0.5 * c.branch)) {
      normals.push_back(normal(c));
      sliding += c.sliding;
    }
  }
  for (const packing::Contact& c : assembly.wall_contacts)
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

} // namespace

InteriorMeasures interior_measures(const packing::Assembly& assembly,
                                   const packing::MechanicalCoordination& mechanical, double layer) {
  const auto out = measures_of(assembly, mechanical, packing::Interior(assembly.cell, layer));
  if (!out)
    throw InvalidArgument("layer at the walls", layer, "m", "a range that leaves grains which carry load");
  return *out;
}

InteriorMeasures interior_measures(const packing::Assembly& assembly,
                                   const packing::MechanicalCoordination& mechanical,
                                   const packing::Interior& interior) {
  const auto out = measures_of(assembly, mechanical, interior);
  if (!out)
    throw InvalidArgument("the window contains no grain that carries load");
  return *out;
}

} // namespace granum::analysis
