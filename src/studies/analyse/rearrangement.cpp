// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/rearrangement.hpp"

#include <unordered_map>
#include <utility>

#include <granum/analysis/rearrangement.hpp>
#include <granum/core/error.hpp>

#include "studies/analyse/overlaps.hpp"

namespace granum::studies {

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

} // namespace granum::studies
