// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/coordination.hpp>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>

namespace granum::packing {

double coordination_number(const Assembly& assembly) {
  require_valid(assembly);
  if (assembly.grain_count() == 0)
    throw InvalidArgument("coordination_number: the assembly has no grains");
  return 2 * static_cast<double>(assembly.contacts.size()) / static_cast<double>(assembly.grain_count());
}

MechanicalCoordination mechanical_coordination(const Assembly& assembly, ContactKind kind) {
  require_valid(assembly);
  const std::size_t fewest = kind == ContactKind::frictional ? 2 : 4;
  const std::size_t grains = assembly.grain_count();
  std::vector<std::vector<std::uint32_t>> neighbours(grains);
  for (const Contact& c : assembly.contacts) {
    neighbours[c.i].push_back(c.j);
    neighbours[c.j].push_back(c.i);
  }
  std::vector<std::size_t> degree(grains);
  for (const Contact& c : assembly.wall_contacts)
    ++degree[c.i];
  std::vector<std::size_t> removed;
  MechanicalCoordination result{.rattler = std::vector<bool>(grains, false)};
  for (std::size_t g = 0; g < grains; ++g) {
    stop_point(g);
    degree[g] += neighbours[g].size();
    if (degree[g] < fewest) {
      result.rattler[g] = true;
      removed.push_back(g);
    }
  }
  for (std::size_t head = 0; head < removed.size(); ++head)
    for (const std::uint32_t h : neighbours[removed[head]])
      if (--degree[h] < fewest && !result.rattler[h]) {
        result.rattler[h] = true;
        removed.push_back(h);
      }

  result.rattler_count = removed.size();
  for (const Contact& c : assembly.contacts)
    result.contact_count += !result.rattler[c.i] && !result.rattler[c.j];
  for (const Contact& c : assembly.wall_contacts)
    result.wall_contact_count += !result.rattler[c.i];
  if (grains > 0)
    result.rattler_fraction = static_cast<double>(result.rattler_count) / static_cast<double>(grains);
  if (result.rattler_count < grains)
    result.coordination_number =
        2 * static_cast<double>(result.contact_count) / static_cast<double>(grains - result.rattler_count);
  return result;
}

} // namespace granum::packing
