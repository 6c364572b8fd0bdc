// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/parts.hpp>

#include <granum/analysis/measure.hpp>
#include <granum/contact/power_law.hpp>
#include <granum/contact/rough_sphere.hpp>
#include <granum/packing/coordination.hpp>

#include "packing/sample_packings.hpp"
#include "unit.hpp"

using namespace granum::analysis;

namespace {

constexpr double grain_radius = 0.5e-3;
constexpr contact::GrainMaterial quartz{30e9, 0.15};

contact::NormalLaw rough(double roughness) { return contact::RoughSphere(quartz, grain_radius, roughness); }

/// A lattice whose every fifth contact carries this share of the force of the others [N].
packing::Assembly with_light_contacts(double share, double force) {
  packing::Assembly assembly = samples::lattice(samples::face_centred, {.radius = grain_radius});
  for (std::size_t k = 0; k < assembly.contacts.size(); ++k)
    assembly.contacts[k].normal_force = k % 5 == 0 ? share * force : force;
  return assembly;
}

double total_force(const packing::Assembly& assembly) {
  double sum = 0;
  for (const packing::Contact& c : assembly.contacts)
    sum += c.normal_force;
  return sum;
}

} // namespace

TEST_CASE(
    "contacts of very rough grains count from 5 % of the mean force on: they are as stiff as it is large") {
  constexpr double force = 1e-3;              // of 1 um: k_n = f/u0 but for 1e-4
  for (const double share : {0.039, 0.042}) { // the mean is 0.81 times the force
    const packing::Assembly packing = with_light_contacts(share, force);
    const std::size_t all = packing.contacts.size();
    const packing::Assembly counted = counted_part(packing, rough(1e-6));
    CHECK(counted.contacts.size() == (share < 0.0404 ? all - (all + 4) / 5 : all));
    if (counted.contacts.size() < all)
      for (const packing::Contact& c : counted.contacts)
        CHECK(c.normal_force == force);
  }
  // The smoother the grains, the lighter a contact may be.
  const packing::Assembly packing = with_light_contacts(0.01, force);
  CHECK(counted_part(packing, rough(1e-6)).contacts.size() < packing.contacts.size());
  CHECK(counted_part(packing, rough(1e-9)).contacts.size() == packing.contacts.size());
}

TEST_CASE(
    "contacts that pull do not count between rough grains, all do where b is the same or none presses") {
  packing::Assembly packing = with_light_contacts(-0.01, 1);
  const std::size_t all = packing.contacts.size();
  CHECK(counted_part(packing, rough(1e-8)).contacts.size() == all - (all + 4) / 5);
  for (packing::Contact& c : packing.contacts)
    c.normal_force = 0;
  CHECK(counted_part(packing, rough(1e-8)).contacts.size() == all);
  const packing::Assembly light = with_light_contacts(1e-6, 1);
  CHECK(counted_part(light, contact::PowerLaw::sphere(quartz, grain_radius)).contacts.size() == all);
  CHECK(counted_part(light, contact::PowerLaw::cone(quartz, 0.4)).contacts.size() == all);
  CHECK(counted_part(light, rough(0)).contacts.size() == all);
}

TEST_CASE("measure() counts that part, the contacts that are left out carry almost no stress") {
  const contact::NormalLaw law = rough(1e-6);
  const packing::Assembly packing = with_light_contacts(0.03, 1e-3), counted = counted_part(packing, law);
  REQUIRE(counted.contacts.size() < packing.contacts.size());
  const Counts counts = measure(packing, {.law = law}).counts;
  CHECK(counts.contacts == counted.contacts.size());
  CHECK(counts.coordination_number == coordination_number(counted));
  CHECK(counts.mechanical.coordination_number ==
        mechanical_coordination(counted, packing::ContactKind::frictional).coordination_number);
  CHECK(total_force(counted) == relative(total_force(packing), 0.01));
  // The same law by its family and the material.
  const LawFamily family = [](const contact::GrainMaterial& grain, double radius) {
    return contact::NormalLaw(contact::RoughSphere(grain, radius, 1e-6));
  };
  const Given given{.law_family = family, .grain_shear_modulus = quartz.shear_modulus};
  CHECK(measure(packing, given).counts.contacts == counted.contacts.size());
}
