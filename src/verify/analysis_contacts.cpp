// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "analysis_parts.hpp"

namespace granum::verify {

namespace {

/// Any vector of a length across a unit vector.
Vec3 across(const Vec3& unit, double length) {
  const Vec3 other = std::abs(unit.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 perpendicular = cross(unit, other);
  return (length / norm(perpendicular)) * perpendicular;
}

/// The contacts of a table as if all were between the same two grains: for what asks for forces alone.
Assembly contacts_of(const io::ContactTable& table) {
  Assembly assembly{.cell = Mat3::identity(), .position = {{}, {1, 0, 0}}, .radius = {1, 1}, .contacts = {}};
  for (std::size_t k = 0; k < table.normal.size(); ++k) {
    const Vec3& n = table.normal[k];
    Contact contact{.i = 0, .j = 1, .branch = n};
    if (!table.force.empty()) {
      contact.normal_force = dot(table.force[k], n);
      contact.tangential_force = table.force[k] + -contact.normal_force * n;
    } else if (!table.normal_force.empty()) {
      contact.normal_force = table.normal_force[k];
      if (!table.tangential_size.empty())
        contact.tangential_force = across(n, table.tangential_size[k]);
    }
    assembly.contacts.push_back(contact);
  }
  return assembly;
}

} // namespace

Analysis analyse_contacts(const io::ContactTable& table, const AnalysisOptions& options) {
  Analysis out;
  out.counts.contacts = table.normal.size();
  if (table.normal.size() >= 2) {
    out.fabric = analyse_fabric(table.normal, options.rose_bins);
    judge_fabric(*out.fabric, out.warnings);
  }
  if (!table.force.empty() || !table.normal_force.empty()) {
    out.forces =
        analyse_forces(contacts_of(table), !table.force.empty() || !table.tangential_size.empty(), options);
    out.forces->unbalance = {};
  }
  out.notes.emplace_back("contacts without grains: no C_n, no stress, no stiffness");
  return out;
}

} // namespace granum::verify
