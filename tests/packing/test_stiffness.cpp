// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/stiffness.hpp>

#include "sphere_chain.hpp"
#include "unit.hpp"

namespace {

constexpr contact::GrainMaterial glass{30e9, 0.15};
using samples::chain_force_ab, samples::chain_force_bc;

} // namespace

TEST_CASE("stiffness without a material is 1.5 f/d, and of one material twice that of one") {
  packing::Assembly a = samples::sphere_chain();
  packing::assign_stiffness_of_ratio(a, 0.5);
  CHECK(a.contacts[0].normal_stiffness == relative(1.5 * chain_force_ab / 1e-7, 1e-15));
  CHECK(a.contacts[1].tangential_stiffness == relative(0.75 * chain_force_bc / 2e-7, 1e-15));
  a.contacts[0].overlap = 0;
  packing::assign_stiffness_of_ratio(a, 0.5);
  CHECK(a.contacts[0].normal_stiffness == 0);
  CHECK_THROWS_AS(packing::assign_stiffness_of_ratio(a, -1), InvalidArgument);

  packing::Assembly one = samples::sphere_chain(), many = one;
  const std::vector<contact::GrainMaterial> same(3, glass);
  assign_hertz_stiffness(one, glass, contact::mindlin_stiffness_ratio(glass.poisson_ratio));
  assign_hertz_stiffness(many, same, std::nullopt);
  CHECK(one == many);
  CHECK_THROWS_AS(assign_hertz_stiffness(many, std::vector(2, glass), std::nullopt), InvalidArgument);
}

TEST_CASE("stiffnesses by overlap and by force are those of Hertz and Mindlin, at a wall that of F(2 d)") {
  const double ratio = contact::mindlin_stiffness_ratio(glass.poisson_ratio), d = 1e-7;
  const auto law = contact::PowerLaw::sphere(glass, 0.5e-3);
  const double slope = (law.force(2 * d * 1.0001) - law.force(2 * d * 0.9999)) / (2e-4 * d);
  for (const packing::StiffnessFrom from : {packing::StiffnessFrom::overlap, packing::StiffnessFrom::force}) {
    packing::Assembly a = samples::sphere_chain();
    a.wall_contacts = {
        {.i = 1, .j = 0, .branch = {0, -0.4999e-3, 0}, .overlap = d, .normal_force = law.force(2 * d)}};
    packing::Assembly b = a;
    assign_stiffness(a, law, ratio, from);
    CHECK(a.contacts[0].normal_stiffness == relative(1.5 * chain_force_ab / 1e-7, 1e-8));
    CHECK(a.contacts[1].normal_stiffness == relative(1.5 * chain_force_bc / 2e-7, 1e-8));
    CHECK(a.contacts[1].tangential_stiffness ==
          relative(0.918918918918919 * 1.5 * chain_force_bc / 2e-7, 1e-8));
    CHECK(a.wall_contacts[0].normal_stiffness == relative(slope, 1e-7)); // a central difference
    CHECK(a.wall_contacts[0].tangential_stiffness == relative(ratio * slope, 1e-7));
    assign_hertz_stiffness(b, glass, ratio, from);
    CHECK(b.contacts[0].normal_stiffness == relative(a.contacts[0].normal_stiffness, 1e-14));
    CHECK(b.wall_contacts[0].normal_stiffness == relative(a.wall_contacts[0].normal_stiffness, 1e-14));
  }
  packing::Assembly two_sizes = samples::sphere_chain();
  two_sizes.radius[0] = 1.5e-3; // 1/R* = 1/1.5 + 1/0.5 per mm: that of two spheres of 0.75 mm
  assign_hertz_stiffness(two_sizes, glass, 0);
  CHECK(two_sizes.contacts[0].normal_stiffness ==
        relative(contact::PowerLaw::sphere(glass, 0.75e-3).stiffness_at_overlap(d), 1e-14));
  CHECK(two_sizes.contacts[0].tangential_stiffness == 0);
}

TEST_CASE("a contact that does not press has no Hertz stiffness, and a bad ratio is refused") {
  packing::Assembly a = samples::sphere_chain();
  a.contacts[0].overlap = -1e-9;
  a.contacts[1].normal_force = -1;
  assign_stiffness(a, contact::PowerLaw::sphere(glass, 0.5e-3), 1);
  CHECK(a.contacts[0].normal_stiffness == 0);
  assign_stiffness(a, contact::PowerLaw::sphere(glass, 0.5e-3), 1, packing::StiffnessFrom::force);
  CHECK(a.contacts[1].normal_stiffness == 0);
  CHECK_THROWS_AS(assign_stiffness(a, contact::PowerLaw::sphere(glass, 0.5e-3), -1), InvalidArgument);
  CHECK_THROWS_AS(assign_hertz_stiffness(a, glass, -1), InvalidArgument);
}

TEST_CASE("grains with adhesion have its k_n, Mindlin's k_t of the contact area, and a wall that of the "
          "mirror image") {
  const std::vector<contact::GrainMaterial> same(3, glass);
  for (const auto model : {contact::AdhesionModel::jkr, contact::AdhesionModel::dmt}) {
    const contact::Adhesion adhesion{model, 0.4}, none{model, 0};
    packing::Assembly a = samples::sphere_chain(), hertz = a;
    a.wall_contacts = hertz.wall_contacts = {
        {.i = 1, .j = 0, .branch = {0, -0.4999e-3, 0}, .overlap = 1e-7, .normal_force = chain_force_bc}};
    assign_hertz_stiffness(hertz, same, std::nullopt);
    packing::Assembly without = a;
    assign_adhesive_stiffness(without, none, same, std::nullopt);
    const auto check_same = [](const packing::Contact& one, const packing::Contact& other) {
      CHECK(one.normal_stiffness == relative(other.normal_stiffness, 1e-13));
      CHECK(one.tangential_stiffness == relative(other.tangential_stiffness, 1e-13));
    };
    for (std::size_t k = 0; k < 2; ++k)
      check_same(without.contacts[k], hertz.contacts[k]);
    check_same(without.wall_contacts[0], hertz.wall_contacts[0]);

    assign_adhesive_stiffness(a, adhesion, same, 0.5);
    const auto state = adhesive_contact_at_overlap(adhesion, glass, 0.5e-3, 2e-7);
    CHECK(a.contacts[1].normal_stiffness == state.stiffness);
    CHECK(a.contacts[1].tangential_stiffness == 0.5 * state.hertz_stiffness);
    CHECK(a.wall_contacts[0].normal_stiffness == 2 * state.stiffness); // F(2 d)
    CHECK(a.wall_contacts[0].tangential_stiffness == state.hertz_stiffness);
    packing::Assembly by_force = a;
    by_force.contacts[1].normal_force = state.force;
    assign_adhesive_stiffness(by_force, adhesion, same, 0.5, packing::StiffnessFrom::force);
    CHECK(by_force.contacts[1].normal_stiffness == relative(state.stiffness, 1e-12));
    CHECK_THROWS_AS(assign_adhesive_stiffness(a, adhesion, same, 0.5, packing::StiffnessFrom::ratio),
                    InvalidArgument);
    CHECK_THROWS_AS(assign_adhesive_stiffness(a, {model, -1}, same, 0.5), InvalidArgument);
  }
}

TEST_CASE("resistance to rolling as codes state it") {
  packing::Assembly a = samples::sphere_chain();
  a.radius[0] = 1.5e-3;
  assign_hertz_stiffness(a, glass, 0.8);
  const packing::Contact& c = a.contacts[0];
  const double reduced = 1.5e-3 * 0.5e-3 / 2e-3;
  using Of = packing::TurningSpring::Of;
  assign_rolling_stiffness(a, {.value = 2e4, .of = Of::displacement});
  CHECK(c.rolling_stiffness == relative(2e4 * reduced * reduced, 1e-14));
  assign_rolling_stiffness(a, {.value = 3, .of = Of::angle});
  CHECK(c.rolling_stiffness == 3);
  assign_rolling_stiffness(a, {.value = 0.1, .of = Of::normal});
  CHECK(c.rolling_stiffness == relative(0.1 * c.normal_stiffness * reduced * reduced, 1e-14));
  assign_twisting_stiffness(a, {.of = Of::marshall}); // k_t a^2/2, a^2 = R* d
  CHECK(c.twisting_stiffness == relative(c.tangential_stiffness * reduced * c.overlap / 2, 1e-14));
  CHECK_THROWS_AS(assign_rolling_stiffness(a, {.value = -1}), InvalidArgument);
}
