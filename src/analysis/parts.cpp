// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/parts.hpp>

#include <utility>
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

double share(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

struct Part {
  InteriorMeasures measures; ///< but for the fabric
  std::size_t bearing = 0;   ///< grains inside that carry load
  std::vector<Vec3> normals; ///< of contacts whose middle is inside
};

Part part_of(const packing::Assembly& assembly, const packing::MechanicalCoordination& mechanical,
             const packing::Interior& interior) {
  Part part;
  InteriorMeasures& out = part.measures;
  std::vector<bool> inside(assembly.grain_count());
  std::size_t rattlers = 0;
  double solid = 0;
  for (std::size_t g = 0; g < inside.size(); ++g) {
    solid += interior.part_of_sphere(assembly.position[g], assembly.radius[g]);
    inside[g] = interior.holds(assembly.position[g]);
    out.grains += inside[g];
    rattlers += inside[g] && mechanical.rattler[g];
  }
  part.bearing = out.grains - rattlers;
  out.void_ratio = solid > 0 ? interior.volume() / solid - 1 : 0;
  const auto add_stress = [&](const packing::Contact& c) {
    out.stress +=
        interior.share(assembly.position[c.i], c.branch) / interior.volume() * outer(force(c), c.branch);
  };
  std::size_t ends = 0, bearing_ends = 0, sliding = 0;
  for (const packing::Contact& c : assembly.contacts) {
    const std::size_t here = static_cast<std::size_t>(inside[c.i]) + static_cast<std::size_t>(inside[c.j]);
    ends += here;
    bearing_ends += mechanical.rattler[c.i] || mechanical.rattler[c.j] ? 0 : here;
    add_stress(c);
    if (interior.holds(assembly.position[c.i] + 0.5 * c.branch)) {
      part.normals.push_back(normal(c));
      sliding += c.sliding;
    }
  }
  for (const packing::Contact& c : assembly.wall_contacts)
    add_stress(c);
  out.micro = {.coordination_number = share(ends, out.grains),
               .mechanical_coordination_number = share(bearing_ends, part.bearing),
               .rattler_fraction = share(rattlers, out.grains),
               .sliding_fraction = share(sliding, part.normals.size())};
  return part;
}

/// \throws   InvalidArgument for fewer than 2 contacts
InteriorMeasures with_fabric(Part part) {
  const fabric::AnisotropyEstimate anisotropy = fabric::estimate_anisotropy(part.normals);
  part.measures.micro.fabric_anisotropy = anisotropy.anisotropy;
  part.measures.micro.fabric_anisotropy_error = anisotropy.standard_error;
  return part.measures;
}

} // namespace

InteriorMeasures interior_measures(const packing::Assembly& assembly,
                                   const packing::MechanicalCoordination& mechanical, double layer) {
  Part part = part_of(assembly, mechanical, packing::Interior(assembly.cell, layer));
  if (part.bearing == 0)
    throw InvalidArgument("layer at the walls", layer, "m", "a range that leaves grains which carry load");
  return with_fabric(std::move(part));
}

InteriorMeasures interior_measures(const packing::Assembly& assembly,
                                   const packing::MechanicalCoordination& mechanical,
                                   const packing::Interior& interior) {
  Part part = part_of(assembly, mechanical, interior);
  if (part.bearing == 0)
    throw InvalidArgument("the window contains no grain that carries load");
  return with_fabric(std::move(part));
}

InteriorMeasures part_measures(const packing::Assembly& assembly,
                               const packing::MechanicalCoordination& mechanical,
                               const packing::Interior& interior) {
  Part part = part_of(assembly, mechanical, interior);
  return part.normals.size() < 2 ? part.measures : with_fabric(std::move(part));
}

} // namespace granum::analysis
