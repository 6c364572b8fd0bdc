// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/stiffness.hpp>

#include <algorithm>

#include <granum/contact/pair.hpp>

namespace granum::packing {

namespace {

void assign(Contact& c, const contact::PowerLaw& law, double ratio, StiffnessFrom from) {
  c.normal_stiffness = from == StiffnessFrom::overlap ? law.stiffness_at_overlap(std::max(c.overlap, 0.0))
                                                      : law.stiffness_at_force(std::max(c.normal_force, 0.0));
  c.tangential_stiffness = ratio * c.normal_stiffness;
}

/// A rigid plane, at which a grain stands as before its mirror image: F(2 d), with the derivative 2 F'(2 d).
void assign_wall(Contact& c, const contact::PowerLaw& law, double ratio, StiffnessFrom from) {
  Contact mirrored = c;
  mirrored.overlap = 2 * c.overlap;
  assign(mirrored, law, ratio, from);
  c.normal_stiffness = 2 * mirrored.normal_stiffness;
  c.tangential_stiffness = ratio * c.normal_stiffness;
}

} // namespace

void assign_stiffness(Assembly& assembly, const contact::PowerLaw& law, double ratio, StiffnessFrom from) {
  require_valid(assembly);
  const double checked_ratio = contact::given_stiffness_ratio(ratio);
  for (Contact& c : assembly.contacts)
    assign(c, law, checked_ratio, from);
  for (Contact& c : assembly.wall_contacts)
    assign_wall(c, law, checked_ratio, from);
}

void assign_hertz_stiffness(Assembly& assembly, const contact::GrainMaterial& grain, double ratio,
                            StiffnessFrom from) {
  require_valid(assembly);
  const double checked_ratio = contact::given_stiffness_ratio(ratio);
  for (Contact& c : assembly.contacts) {
    const double radius = contact::pair_radius(assembly.radius[c.i], assembly.radius[c.j]);
    assign(c, contact::PowerLaw::sphere(grain, radius), checked_ratio, from);
  }
  for (Contact& c : assembly.wall_contacts)
    assign_wall(c, contact::PowerLaw::sphere(grain, assembly.radius[c.i]), checked_ratio, from);
}

} // namespace granum::packing
