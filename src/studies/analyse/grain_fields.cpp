// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/grain_fields.hpp"

#include <string>
#include <utility>

#include "studies/analyse/rearrangement.hpp"

namespace granum::studies {

io::KnownForces known_forces(const io::ImportedPacking& packing) {
  if (packing.has(io::Finding::forces_unknown))
    return io::KnownForces::none;
  return packing.has(io::Finding::tangential_unknown) ? io::KnownForces::normal : io::KnownForces::all;
}

std::vector<io::GrainField> grain_fields(const io::ImportedPacking& packing,
                                         const network::StrainMotions& motions,
                                         const io::ImportedPacking* before) {
  constexpr const char* strains[] = {"11", "22", "33", "23", "13", "12"};
  const packing::Assembly& assembly = packing.assembly;
  std::vector<io::GrainField> out = io::grain_fields(assembly, known_forces(packing));
  for (std::size_t c = 0; c < motions.size(); ++c) {
    if (motions[c].empty())
      continue;
    io::GrainField field{.name = std::string("nonaffine_") + strains[c], .components = 3};
    for (std::size_t g = 0; g < assembly.grain_count(); ++g) {
      const Vec3& u = motions[c][assembly.body.empty() ? g : assembly.body[g]].displacement;
      field.values.insert(field.values.end(), {u.x, u.y, u.z});
    }
    out.push_back(std::move(field));
  }
  if (before != nullptr)
    out.push_back({.name = "D2min", .values = d2min(*before, packing)});
  return out;
}

} // namespace granum::studies
