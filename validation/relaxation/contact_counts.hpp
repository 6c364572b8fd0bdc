// SPDX-License-Identifier: GPL-3.0-or-later
// What validation/relaxation records of the contacts of a packing that the library does not count.
#pragma once

#include <vector>

#include <granum/packing/assembly.hpp>
#include <granum/packing/coordination.hpp>

namespace relaxation {

using namespace granum;

/// Whether grains hold one another. A specimen that ran out of steps before its grains met is at rest too.
inline bool is_jammed(const packing::Assembly& assembly) {
  return mechanical_coordination(assembly, packing::ContactKind::frictional).contact_count > 0;
}

inline double mean_tangential_share(const packing::Assembly& assembly) {
  double normal_sum = 0, tangential_sum = 0;
  for (const packing::Contact& c : assembly.contacts) {
    normal_sum += c.normal_force;
    tangential_sum += norm(c.tangential_force);
  }
  return tangential_sum / normal_sum;
}

/// Grains of two contacts over all that are not rattlers: each spins freely about the line through both.
inline double two_contact_share(const packing::Assembly& assembly, const std::vector<bool>& rattler) {
  std::vector<int> contacts(rattler.size());
  for (const packing::Contact& c : assembly.contacts)
    if (!rattler[c.i] && !rattler[c.j])
      ++contacts[c.i], ++contacts[c.j];
  double grains = 0, of_two = 0;
  for (std::size_t g = 0; g < rattler.size(); ++g) {
    grains += !rattler[g];
    of_two += !rattler[g] && contacts[g] == 2;
  }
  return of_two / grains;
}

/// <f l>/(<f> <l>) of normal forces and branches: how much more long branches bear.
inline double force_by_branch(const packing::Assembly& assembly) {
  double force = 0, length = 0, both = 0;
  for (const packing::Contact& c : assembly.contacts) {
    const double l = norm(c.branch);
    force += c.normal_force;
    length += l;
    both += c.normal_force * l;
  }
  return both * static_cast<double>(assembly.contacts.size()) / (force * length);
}

} // namespace relaxation
