// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/materials.hpp"

#include <string>

#include <granum/core/error.hpp>

namespace granum::studies {

std::vector<contact::GrainMaterial> materials_of(const io::ImportedPacking& packing,
                                                 const MaterialsByType& materials) {
  std::vector<contact::GrainMaterial> out;
  if (materials.empty())
    return out;
  if (packing.type.size() != packing.assembly.grain_count())
    throw InvalidArgument("--material needs the types of grains, which these files do not contain");
  for (const long type : packing.type) {
    const auto found = materials.find(type);
    if (found == materials.end())
      throw InvalidArgument("grains have type " + std::to_string(type) +
                            ", for which no --material is given");
    out.push_back(found->second);
  }
  return out;
}

} // namespace granum::studies
