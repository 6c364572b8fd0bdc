// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/assembly.hpp>

#include <granum/packing/coordination.hpp>
#include <granum/packing/forces.hpp>

#include "unit.hpp"

using packing::Assembly;

namespace {

/// Two dimers along x, the second of which lies across a face, and a single grain on top of one.
Assembly dimers() {
  Assembly a{
      .cell = Mat3::diagonal(10, 10, 10),
      .position = {{1, 5, 5}, {2, 5, 5}, {9.5, 5, 5}, {0.2, 5, 5}, {2, 5, 7}},
      .radius = {1, 1, 1, 1, 1},
      .contacts = {{.i = 0, .j = 1, .branch = {1, 0, 0}, .normal_force = 50},
                   {.i = 0, .j = 3, .branch = {-0.8, 0, 0}, .normal_force = 7, .tangential_force = {0, 2, 0}},
                   {.i = 1, .j = 4, .branch = {0, 0, 2}, .normal_force = 3}},
      .body = {0, 0, 1, 1, 2}};
  return a;
}

} // namespace

TEST_CASE("bodies have their members' centre, and the contacts between them") {
  const packing::Bodies b = packing::bodies(dimers());
  REQUIRE(b.assembly.grain_count() == 3);
  CHECK(b.assembly.position[0].x == doctest::Approx(1.5));
  CHECK(b.assembly.position[1].x == doctest::Approx(9.85)); // through the face
  CHECK(b.offset[3].x == doctest::Approx(0.35));
  REQUIRE(b.assembly.contacts.size() == 2);
  CHECK(b.contact == std::vector<std::size_t>{1, 2});
  // from 1.5 to 9.85 - 10
  CHECK(b.assembly.contacts[0].branch.x == doctest::Approx(-1.65));
  CHECK(norm(force(b.assembly.contacts[0]) - Vec3{-7, 2, 0}) < 1e-14);
  CHECK(coordination_number(b.assembly) == doctest::Approx(4.0 / 3));
}

TEST_CASE("the stress of bodies is that of forces on branches from body to body") {
  const packing::ContactStress stress = contact_stress(packing::bodies(dimers()).assembly);
  CHECK(stress.tensor(0, 0) == doctest::Approx(7 * 1.65 / 1000));
  CHECK(stress.tensor(2, 2) == doctest::Approx(3 * 2.0 / 1000));
  CHECK(stress.tensor(2, 0) == doctest::Approx(3 * 0.5 / 1000)); // branch from 1.5 to 2
}

TEST_CASE("unbalanced forces and moments of bodies are about their centres, walls included") {
  Assembly a = dimers();
  a.wall_contacts = {{.i = 0, .j = 0, .branch = {0, -1, 0}, .normal_force = 4}};
  const packing::Bodies b = packing::bodies(a);
  CHECK(norm(b.assembly.wall_contacts[0].branch - Vec3{-0.5, -1, 0}) < 1e-14);
  CHECK(norm(force(b.assembly.wall_contacts[0]) - Vec3{0, -4, 0}) < 1e-14);
  // The first: (7, -2, 0) at (-0.9, 0, 0), (0, 0, -3) at (0.5, 0, 1) and (0, 4, 0) at (-0.5, -1, 0).
  // The second: (-7, 2, 0) at (0.75, 0, 0). The third: (0, 0, 3) below its centre.
  const double mean = (50 + std::sqrt(53) + 3 + 4) / 4;
  double radius = 0;
  for (const double of_body : b.assembly.radius)
    radius += of_body / 3;
  const packing::Unbalance found = unbalance(a);
  CHECK(found.force_ratio == doctest::Approx((std::sqrt(62) + std::sqrt(53) + 3) / 3 / mean).epsilon(1e-13));
  CHECK(found.moment_ratio ==
        doctest::Approx((std::hypot(1.5, 1.8 - 2) + 1.5) / 3 / (mean * radius)).epsilon(1e-13));
}

TEST_CASE("bodies without gaps, and none that touches its own image") {
  Assembly a = dimers();
  a.body[4] = 3;
  CHECK_THROWS_AS(require_valid(a), InvalidArgument);
  a = dimers();
  a.contacts[0].branch = {-9, 0, 0}; // members of one body, the long way round
  CHECK_THROWS_AS(static_cast<void>(packing::bodies(a)), InvalidArgument);
  a.body.clear();
  CHECK(packing::bodies(a).assembly.contacts == a.contacts);
}
