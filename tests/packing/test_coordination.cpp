// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/coordination.hpp>

#include "sample_packings.hpp"
#include "unit.hpp"

namespace {

/// A complete graph on `held` grains, then `chain` grains hanging on the last of them, one after the other.
packing::Assembly clique_with_tail(std::uint32_t held, std::uint32_t chain) {
  packing::Assembly a;
  a.cell = {{{9, 0, 0}, {0, 9, 0}, {0, 0, 9}}};
  a.position.resize(held + chain);
  a.radius.assign(held + chain, 0.5);
  const auto join = [&](std::uint32_t i, std::uint32_t j) {
    a.contacts.push_back(
        {.i = i, .j = j, .branch = {1, 0, 0}, .tangential_force = {}, .normal_stiffness = 1});
  };
  for (std::uint32_t i = 0; i < held; ++i) {
    for (std::uint32_t j = i + 1; j < held; ++j)
      join(i, j);
    if (i + 1 == held)
      join(i, held);
  }
  for (std::uint32_t k = held; k + 1 < held + chain; ++k)
    join(k, k + 1);
  return a;
}

} // namespace

TEST_CASE("contacts with walls support grains, but do not count as contacts between grains") {
  packing::Assembly a = clique_with_tail(5, 3);
  a.wall_contacts = {{.i = 7, .j = 2, .branch = {0.5, 0, 0}, .tangential_force = {}, .normal_stiffness = 1},
                     {.i = 6, .j = 2, .branch = {0.5, 0, 0}, .tangential_force = {}, .normal_stiffness = 1}};
  CHECK(coordination_number(a) == 2 * 13 / 8.0);
  // With friction two contacts hold the end of the tail, and so the rest of it.
  const auto held = mechanical_coordination(a, packing::ContactKind::frictional);
  CHECK(held.rattler_count == 0);
  CHECK(held.contact_count == 13);
  CHECK(held.wall_contact_count == 2);
  CHECK(held.coordination_number == 2 * 13 / 8.0);
  const auto loose = mechanical_coordination(a, packing::ContactKind::frictionless);
  CHECK(loose.rattler_count == 3);
  CHECK(loose.wall_contact_count == 0);
  a.wall_contacts[0].i = 8;
  CHECK_THROWS_AS((void)mechanical_coordination(a, packing::ContactKind::frictional), InvalidArgument);
}

TEST_CASE("rattlers go one after the other") {
  const packing::Assembly a = clique_with_tail(5, 3); // 10 contacts in the clique, 3 in the tail
  for (const auto kind : {packing::ContactKind::frictional, packing::ContactKind::frictionless}) {
    const auto m = mechanical_coordination(a, kind);
    CHECK(m.rattler == std::vector<bool>{false, false, false, false, false, true, true, true});
    CHECK(m.rattler_fraction == 3 / 8.0);
    CHECK(m.contact_count == 10);
    CHECK(m.coordination_number == 4);
  }
  // A ring of four fully joined grains holds with friction (3 contacts each) and falls without.
  const packing::Assembly b = clique_with_tail(4, 1);
  CHECK(mechanical_coordination(b, packing::ContactKind::frictional).coordination_number == 3);
  const auto none = mechanical_coordination(b, packing::ContactKind::frictionless);
  CHECK(none.rattler_fraction == 1);
  CHECK(none.coordination_number == 0);
  CHECK(none.contact_count == 0);
}

TEST_CASE("two grains joined by two contacts through the periodic cell support each other with friction") {
  packing::Assembly a = clique_with_tail(2, 0);
  a.contacts = {a.contacts[0], a.contacts[0]};
  a.contacts[1].branch = {-1, 0, 0};
  CHECK(mechanical_coordination(a, packing::ContactKind::frictional).coordination_number == 2);
}

TEST_CASE("a lattice, one grain and no grains") {
  const packing::Assembly lattice = samples::lattice(samples::hexagonal, {});
  CHECK(coordination_number(lattice) == 12);
  const auto whole = mechanical_coordination(lattice, packing::ContactKind::frictionless);
  CHECK(whole.coordination_number == 12);
  CHECK(whole.contact_count == lattice.contacts.size());
  packing::Assembly a;
  a.cell = Mat3::identity();
  CHECK_THROWS_AS(static_cast<void>(coordination_number(a)), InvalidArgument);
  CHECK(mechanical_coordination(a, packing::ContactKind::frictional).rattler_fraction == 0);
  a.position = {{0.5, 0.5, 0.5}};
  a.radius = {0.1};
  CHECK(coordination_number(a) == 0);
  const auto one = mechanical_coordination(a, packing::ContactKind::frictional);
  CHECK(one.rattler_fraction == 1);
  CHECK(one.coordination_number == 0);
}
