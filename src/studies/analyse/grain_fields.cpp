// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/grain_fields.hpp"

#include <string>
#include <unordered_map>
#include <utility>

#include <granum/analysis/rearrangement.hpp>
#include <granum/core/error.hpp>

#include "studies/analyse/overlaps.hpp"

namespace granum::studies {

io::KnownForces known_forces(const io::ImportedPacking& packing) {
  if (packing.has(io::Finding::forces_unknown))
    return io::KnownForces::none;
  return packing.has(io::Finding::tangential_unknown) ? io::KnownForces::normal : io::KnownForces::all;
}

namespace {

packing::Assembly grains_of(const packing::Assembly& all, const std::vector<std::size_t>& chosen) {
  packing::Assembly out{.cell = all.cell, .position = {}, .radius = {}, .contacts = {}};
  for (const std::size_t g : chosen) {
    out.position.push_back(all.position[g]);
    out.radius.push_back(all.radius[g]);
  }
  return out;
}

/// Grains of both, by their ids, in the order of those after.
std::pair<std::vector<std::size_t>, std::vector<std::size_t>> common(const std::vector<long>& before,
                                                                     const std::vector<long>& after) {
  std::unordered_map<long, std::size_t> place;
  for (std::size_t g = 0; g < before.size(); ++g)
    place.emplace(before[g], g);
  std::pair<std::vector<std::size_t>, std::vector<std::size_t>> out;
  for (std::size_t g = 0; g < after.size(); ++g)
    if (const auto found = place.find(after[g]); found != place.end()) {
      out.first.push_back(found->second);
      out.second.push_back(g);
    }
  return out;
}

} // namespace

std::vector<double> d2min(const io::ImportedPacking& before, const io::ImportedPacking& after, double reach) {
  constexpr double widest = 5;
  require_closed("reach", reach, 1, widest);
  const auto [was, is] = common(before.id, after.id);
  std::vector<double> out(after.assembly.grain_count(), 0.0);
  if (was.empty())
    return out;
  const packing::Assembly start = grains_of(before.assembly, was), end = grains_of(after.assembly, is);
  packing::Assembly wide = start;
  for (double& radius : wide.radius)
    radius *= reach;
  const auto values = analysis::d2min(start, end, overlapping_pairs(wide, before.periodic), before.periodic);
  for (std::size_t k = 0; k < values.size(); ++k)
    out[is[k]] = values[k];
  return out;
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
