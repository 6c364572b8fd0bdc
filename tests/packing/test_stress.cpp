// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/forces.hpp>

#include "sample_packings.hpp"
#include "sphere_chain.hpp"
#include "unit.hpp"

TEST_CASE("contact forces of lattices under isotropic pressure") {
  const double radius = 0.5e-3, p = 1e5;
  const auto check = [&](const samples::Lattice& kind, double force) {
    const packing::Assembly a = samples::lattice(kind, {.radius = radius, .normal_force = force});
    const auto stress = contact_stress(a);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        CHECK(std::abs(stress.symmetric(i, j) - (i == j ? p : 0)) < 1e-12 * p);
    CHECK(stress.mean() == doctest::Approx(p).epsilon(1e-13));
    CHECK(stress.asymmetry < 1e-13);
    CHECK(unbalance(a).force_ratio < 1e-12);
    CHECK(unbalance(a).moment_ratio < 1e-12);
  };
  check(samples::simple_cubic, 4 * radius * radius * p);
  check(samples::body_centred, 4 * radius * radius * p / std::sqrt(3));
  check(samples::face_centred, std::sqrt(2) * radius * radius * p);
}

TEST_CASE("the chain of three spheres: stress and unbalanced forces") {
  const packing::Assembly a = samples::sphere_chain();
  const double fa = samples::chain_force_ab, fb = samples::chain_force_bc;
  const auto stress = contact_stress(a);
  CHECK(stress.symmetric(0, 0) == doctest::Approx(fa * 0.9999e-3 / 64e-9).epsilon(1e-14));
  CHECK(stress.symmetric(1, 1) == 0);
  CHECK(stress.symmetric(2, 2) == doctest::Approx(fb * 0.9998e-3 / 64e-9).epsilon(1e-14));
  CHECK(stress.asymmetry == 0);
  const auto grains = residuals(a);
  CHECK(grains[0].force == Vec3{-fa, 0, 0}); // pushed away from its neighbour
  CHECK(grains[1].force == Vec3{fa, 0, -fb});
  CHECK(grains[2].force == Vec3{0, 0, fb});
  CHECK(grains[1].moment == Vec3{0, 0, 0});
  const double expected = (fa + std::hypot(fa, fb) + fb) / 3 / ((fa + fb) / 2);
  CHECK(unbalance(a).force_ratio == doctest::Approx(expected).epsilon(1e-14));
}

TEST_CASE("a tangential force turns both grains and makes the stress asymmetric") {
  packing::Assembly a = samples::sphere_chain();
  a.radius = {0.25e-3, 0.75e-3, 0.5e-3};
  a.contacts.resize(1);
  a.contacts[0].normal_force = 0;
  a.contacts[0].tangential_force = {0, 2e-12, 0};
  CHECK(contact_stress(a).asymmetry == doctest::Approx(1).epsilon(1e-14)); // of little stress as well
  a.contacts[0].tangential_force.y = 2;
  const auto stress = contact_stress(a);
  CHECK(stress.symmetric(0, 1) == doctest::Approx(0.9999e-3 / 64e-9).epsilon(1e-14)); // half of f l/V
  CHECK(stress.asymmetry == doctest::Approx(1).epsilon(1e-14));
  const auto grains = residuals(a);
  CHECK(grains[0].moment.z == doctest::Approx(-0.25 * 0.9999e-3 * 2).epsilon(1e-14));
  CHECK(grains[1].moment.z == doctest::Approx(-0.75 * 0.9999e-3 * 2).epsilon(1e-14));
  const double mean_moment = 0.9999e-3 * 2 / 3;
  CHECK(unbalance(a).moment_ratio == doctest::Approx(mean_moment / (2 * 0.5e-3)).epsilon(1e-14));
}

TEST_CASE("nothing to balance") {
  packing::Assembly none;
  none.cell = Mat3::identity();
  for (const packing::Assembly& a : {none, samples::lattice(samples::simple_cubic, {})}) {
    CHECK(contact_stress(a).mean() == 0);
    CHECK(contact_stress(a).asymmetry == 0);
    CHECK(unbalance(a).force_ratio == 0);
    CHECK(unbalance(a).moment_ratio == 0);
  }
}

TEST_CASE("stresses of the grains, by their volumes, are the stress of the packing") {
  packing::Assembly a = samples::random_network({.seed = 3});
  a.wall_contacts = {{.i = 2,
                      .j = 1,
                      .branch = {0, 0, -a.radius[2]},
                      .normal_force = 2,
                      .tangential_force = {0.3, -0.1, 0}}};
  const std::vector<Mat3> stress = packing::grain_stresses(a);
  REQUIRE(stress.size() == a.grain_count());
  const Mat3 whole = contact_stress(a).tensor;
  Mat3 sum;
  for (std::size_t g = 0; g < stress.size(); ++g)
    sum += (4 * std::numbers::pi * std::pow(a.radius[g], 3) / (3 * a.volume())) * stress[g];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(std::abs(sum(i, j) - whole(i, j)) < 1e-12 * trace(whole));
  // of a grain alone: forces times the way to its contact points
  packing::Assembly chain = samples::sphere_chain();
  chain.radius[0] = 0.3e-3;
  chain.radius[1] = 0.6e-3;
  const double volume = 4 * std::numbers::pi / 3 * std::pow(chain.radius[0], 3);
  CHECK(packing::grain_stresses(chain)[0](0, 0) ==
        doctest::Approx(samples::chain_force_ab * 0.9999e-3 / 3 / volume).epsilon(1e-13));
  CHECK(packing::grain_stresses(
            {.cell = Mat3::identity(), .position = {{}}, .radius = {1}, .contacts = {}})[0] == Mat3{});
}
