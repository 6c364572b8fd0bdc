// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/grains.hpp>
#include <granum/packing/forces.hpp>

#include "dem/lattice_state.hpp"
#include "unit.hpp"

TEST_CASE("work of the cell and contact forces give one pressure, for every contact shape, with sliding "
          "forces too") {
  const contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double radius = 0.5e-3;
  for (const contact::PowerLaw& law :
       {contact::PowerLaw::sphere(quartz, radius), contact::PowerLaw::cone(quartz, 0.4),
        contact::PowerLaw::flat(quartz, 5.7e-6), contact::PowerLaw::general(quartz, 1.5, 180)}) {
    for (const double spread : {0.0, 0.3}) {
      const dem::Material material{.law = law, .tangential_ratio = 0.9, .friction_coefficient = 0.5};
      dem::Specimen state = test::fcc(radius, 2, 4e-7);
      for (std::size_t g = 0; spread > 0 && g < state.grain_count(); ++g)
        state.size.push_back(1 + spread * std::abs(std::sin(static_cast<double>(g))));
      // Unequal overlaps and tangential forces: the identity needs neither symmetry nor equilibrium.
      for (std::size_t g = 0; g < state.grain_count(); ++g)
        state.position[g] += 1e-7 * test::scatter(g);
      packing::Assembly assembly = dem::contact_network(state, material);
      for (packing::Contact& c : assembly.contacts)
        c.tangential_force = 0.3 * c.normal_force * (1 / norm(c.branch)) * cross(c.branch, Vec3{0.6, 0, 0.8});
      for (std::uint32_t g = 0; g < 4; ++g) { // and walls, on which grains press as on their images
        const double size = state.size.empty() ? 1 : state.size[g], overlap = (2 + g) * 1e-7;
        assembly.wall_contacts.push_back({.i = g,
                                          .j = 0,
                                          .branch = {0, 0, size * radius - overlap},
                                          .overlap = overlap,
                                          .normal_force = of_sizes(law, size, size).force(2 * overlap)});
      }
      const double by_contacts = contact_stress(assembly).mean();
      REQUIRE(by_contacts > 0);
      CHECK(std::abs(pressure_by_cell_work(assembly, law, radius) / by_contacts - 1) < 1e-8);
    }
  }
}

TEST_CASE("contacts that barely touch spoil no digits of the cell's work, and none have none") {
  const double radius = 0.5e-3;
  const contact::PowerLaw law =
      contact::PowerLaw::flat({.shear_modulus = 30e9, .poisson_ratio = 0.15}, 5.7e-6);
  dem::Specimen state = test::fcc(radius, 2, 4e-7);
  state.position[0] += Vec3{std::sqrt(2.0) * (1 - 2.2e-4) * 4e-7, 0, 0}; // off four of its neighbours
  packing::Assembly assembly = dem::contact_network(state, {.law = law});
  const auto by_overlap = [](const packing::Contact& a, const packing::Contact& b) {
    return a.overlap < b.overlap;
  };
  REQUIRE(std::min_element(assembly.contacts.begin(), assembly.contacts.end(), by_overlap)->overlap <
          1e-4 * 4e-7); // or nothing is tested
  CHECK(std::abs(pressure_by_cell_work(assembly, law, radius) / contact_stress(assembly).mean() - 1) < 2e-8);
  assembly.contacts.clear();
  CHECK(pressure_by_cell_work(assembly, law, radius) == 0);
}
