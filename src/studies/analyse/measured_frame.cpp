// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/measured_frame.hpp"

#include <algorithm>
#include <cmath>

#include <granum/contact/power_law.hpp>
#include <granum/core/text.hpp>

#include "frame_warnings.hpp"

namespace granum::studies {

namespace {

/// Any vector of a length across a unit vector.
Vec3 across(const Vec3& unit, double length) {
  const Vec3 other = std::abs(unit.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 perpendicular = cross(unit, other);
  return (length / norm(perpendicular)) * perpendicular;
}

/// The contacts of a table as if all were between the same two grains: for functions that use only forces.
packing::Assembly contacts_of(const io::ContactTable& table) {
  packing::Assembly assembly{
      .cell = Mat3::identity(), .position = {{}, {1, 0, 0}}, .radius = {1, 1}, .contacts = {}};
  for (std::size_t k = 0; k < table.normal.size(); ++k) {
    const Vec3& n = table.normal[k];
    packing::Contact contact{.i = 0, .j = 1, .branch = n};
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

/// Whether the forces show linear springs, and neither the files nor the user gives their k_t.
bool assumes_tangential_ratio(const packing::Assembly& assembly, const analysis::Given& given,
                              const analysis::Measurement& measured) {
  const auto stiff = [](const packing::Contact& c) { return c.tangential_stiffness > 0; };
  const contact::PowerLaw* const power = measured.law ? measured.law->power_law() : nullptr;
  return given.law_assumed && !given.law && !given.tangential_ratio && given.materials.empty() &&
         power != nullptr && std::isinf(power->alpha()) && std::ranges::none_of(assembly.contacts, stiff);
}

/// With what the reader found.
analysis::Given completed(analysis::Given given, const io::ImportedPacking& packing) {
  using io::Finding;
  given.normal_forces = !packing.has(Finding::forces_unknown);
  given.tangential_forces = !packing.has(Finding::tangential_unknown);
  given.contact_moments = packing.has(Finding::contact_moments);
  given.force_rounding = unbalance_by_rounding(packing);
  given.overlap_rounding = packing.rounding.overlap;
  given.type = packing.type;
  return given;
}

} // namespace

packing::Assembly stiffened(const io::ImportedPacking& packing, const analysis::Given& given) {
  return analysis::stiffened(packing.assembly, completed(given, packing));
}

MeasuredFrame measure_frame(const io::ImportedPacking& packing, analysis::Given given,
                            const analysis::Wanted& wanted) {
  using io::Finding;
  given = completed(std::move(given), packing);
  const bool by_overlaps = packing.has(Finding::contacts_from_overlaps);
  analysis::Wanted measured = wanted;
  measured.law_check = wanted.law_check && !by_overlaps; // forces by the law would agree with it
  if (measured.network)
    measured.network->force_terms = given.normal_forces && packing.assembly.wall_contacts.empty();
  MeasuredFrame out{.step = packing.step,
                    .time = packing.time,
                    .materials_given = !given.materials.empty(),
                    .adhesion_given = given.adhesion.has_value(),
                    .contacts_known = by_overlaps || !packing.has(Finding::contacts_unknown),
                    .packing = analysis::measure(packing.assembly, given, measured)};
  add_warnings(packing, out);
  if (assumes_tangential_ratio(packing.assembly, given, out.packing))
    out.warnings.push_back("linear springs, and k_t is not in the files: k_t/k_n = " +
                           short_text(out.packing.state
                                          ? out.packing.state->tangential_ratio
                                          : contact::mindlin_stiffness_ratio(given.grain_poisson_ratio)) +
                           " is assumed, where LAMMPS' gran/hooke has 2/7 by default; G of the network grows "
                           "with it: give --tangential-ratio");
  return out;
}

MeasuredFrame measure_frame(const io::ContactTable& table, analysis::Given given,
                            const analysis::Wanted& wanted) {
  MeasuredFrame out;
  out.packing.counts.contacts = table.normal.size();
  if (table.normal.size() >= 2) {
    out.packing.fabric = analysis::measure_fabric(table.normal, wanted);
    judge_fabric(*out.packing.fabric, out.warnings);
  }
  if (wanted.force_bins && (!table.force.empty() || !table.normal_force.empty())) {
    given.tangential_forces = !table.force.empty() || !table.tangential_size.empty();
    out.packing.forces = analysis::measure_forces(contacts_of(table), given, *wanted.force_bins);
    out.packing.forces->unbalance.reset();
    out.packing.forces->weight.reset();
  }
  out.packing.notes.emplace_back("contacts without grains: no C_n, no stress, no stiffness");
  return out;
}

} // namespace granum::studies
