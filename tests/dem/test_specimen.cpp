// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/specimen.hpp>

#include "lattice_state.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

namespace {

/// Three spheres in a bent chain, R = 0.5 mm, G = 30 GPa, nu = 0.15, overlaps 1e-7 m and 2e-7 m: LAMMPS,
/// LIGGGHTS and YADE all print the forces below for it.
dem::Specimen chain() {
  dem::Specimen state;
  state.radius = 0.5e-3;
  state.cell = Mat3::diagonal(4e-3, 4e-3, 4e-3);
  state.position = {{1.0e-3, 2e-3, 2e-3}, {1.9999e-3, 2e-3, 2e-3}, {1.9999e-3, 2e-3, 2.9998e-3}};
  return state;
}

} // namespace

TEST_CASE("forces of a three-sphere chain are those that three other codes print") {
  const packing::Assembly assembly = dem::contact_network(chain(), test::quartz(0.5e-3, 0.5));
  REQUIRE(assembly.contacts.size() == 2);
  const packing::Contact& ab = assembly.contacts[0];
  const packing::Contact& bc = assembly.contacts[1];
  // Printed to 9 digits, half of the last one is 2.2e-9 of it; the overlaps themselves are differences of
  // lengths 1e4 times as large.
  CHECK(ab.normal_force == relative(0.0235294118, 2.2e-9));
  CHECK(bc.normal_force == relative(0.0665512265, 2.2e-9));
  CHECK(bc.overlap == relative(2e-7, 1e-10));
  CHECK(bc.branch.z == relative(0.9998e-3, 1e-14));
  CHECK(bc.normal_stiffness == relative(1.5 * bc.normal_force / bc.overlap, 1e-14));
  CHECK(bc.tangential_stiffness / bc.normal_stiffness == relative(2 * 0.85 / 1.85, 1e-15));
  require_valid(assembly);
}

TEST_CASE("a frozen state includes tangential forces and sliding contacts") {
  dem::Specimen state = chain();
  const dem::Material material = test::quartz(0.5e-3, 0.5);
  state.history = {{0, 1, {0, 0.5 * 0.0235294118 * 1.1, 0}, 1.0}, {1, 2, {1e-3, 0, 0}, 1.0}};
  const packing::Assembly assembly = dem::contact_network(state, material);
  CHECK(assembly.contacts[0].sliding);
  CHECK_FALSE(assembly.contacts[1].sliding);
  CHECK(assembly.contacts[1].tangential_force == Vec3{1e-3, 0, 0});
  const double limit = 0.5 * assembly.contacts[0].normal_force;
  check_threshold(1e-9, [&](double below) { // rounding of the limit
    state.history = {{0, 1, {0, (1 - below) * limit, 0}, 1.0}};
    return dem::contact_network(state, material).contacts[0].sliding ? 1 : 0;
  });
  state.history = {{0, 1, {0, 1.1 * limit, 0}, 1.0}};
  dem::Material sticking = material;
  sticking.friction_coefficient = std::numeric_limits<double>::infinity();
  CHECK_FALSE(dem::contact_network(state, sticking).contacts[0].sliding);
}
