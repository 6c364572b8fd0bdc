// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/arrays/packing.hpp>

#include <granum/packing/forces.hpp>

#include "unit.hpp"

namespace {

/// Three grains of radius 0.5 in a cube of edge 4; the third touches the first through a face.
struct Row {
  std::vector<Vec3> position{{0.2, 1, 1}, {1.1, 1, 1}, {3.3, 1, 1}};
  std::vector<double> radius{0.5, 0.5, 0.5};
  std::vector<std::array<long, 2>> pairs{{2, 0}, {1, 0}};
  std::vector<Vec3> force{{3, 0.5, 0}, {-2, 0, 0}}, branch = {};
  std::vector<double> normal = {};
  Vec3 edges{4, 4, 4};

  [[nodiscard]] io::PackingArrays arrays() const {
    return {.position = position,
            .radius = radius,
            .cell = Mat3::diagonal(edges.x, edges.y, edges.z),
            .contacts =
                io::ContactArrays{.grains = pairs, .branch = branch, .force = force, .normal_force = normal}};
  }
};

std::string arrays_refusal(const io::PackingArrays& arrays) {
  try {
    (void)io::packing_of(arrays);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("bodies of arrays have any numbers") {
  const std::vector<long> body{1, 0, 1};
  Row row;
  io::PackingArrays arrays = row.arrays();
  arrays.body = body;
  const std::vector<std::uint32_t> joined = io::packing_of(arrays).assembly.body;
  REQUIRE(joined.size() == 3);
  CHECK((joined[0] == joined[2] && joined[0] != joined[1]));
}

TEST_CASE("contacts of arrays are turned, sorted and joined through the faces") {
  const io::ImportedPacking packing = io::packing_of(Row{}.arrays());
  const auto& contacts = packing.assembly.contacts;
  REQUIRE(contacts.size() == 2);
  CHECK((contacts[0].i == 0 && contacts[0].j == 1));
  CHECK((contacts[1].i == 0 && contacts[1].j == 2));
  CHECK(contacts[0].branch.x == doctest::Approx(0.9));
  CHECK(contacts[1].branch.x == doctest::Approx(-0.9)); // 3.3 - 4 is nearer than 3.3
  CHECK(contacts[1].overlap == doctest::Approx(0.1));
  // Grain 1 pushes grain 0 by -2 along x, so grain 0 pushes 1 by +2; grain 2 pushes 0 by +3.
  CHECK(contacts[0].normal_force == doctest::Approx(2));
  CHECK(contacts[1].normal_force == doctest::Approx(3));
  CHECK(contacts[1].tangential_force.y == doctest::Approx(-0.5));
  CHECK(packing::contact_stress(packing.assembly).tensor(0, 0) == doctest::Approx((2 + 3) * 0.9 / 64));
  CHECK(packing.has(io::Finding::unsorted));
  CHECK(packing.has(io::Finding::through_faces));
  CHECK_FALSE(packing.has(io::Finding::forces_unknown));
}

TEST_CASE("arrays report missing data") {
  Row row;
  io::PackingArrays arrays = row.arrays();
  arrays.contacts->force = {};
  CHECK(io::packing_of(arrays).has(io::Finding::forces_unknown));
  const std::vector<double> normal{3, 2};
  arrays.contacts->normal_force = normal;
  CHECK(io::packing_of(arrays).has(io::Finding::tangential_unknown));
  CHECK(io::packing_of(arrays).has(io::Finding::stiffness_unknown));
  arrays.contacts->normal_stiffness = normal;
  CHECK_FALSE(io::packing_of(arrays).has(io::Finding::stiffness_unknown));
  arrays.contacts.reset();
  CHECK(io::packing_of(arrays).has(io::Finding::contacts_unknown));
  arrays.cell.reset();
  CHECK(io::packing_of(arrays).has(io::Finding::cell_unknown));
}

TEST_CASE("arrays that are no packing are refused with their element") {
  const std::pair<const char*, void (*)(Row&)> wrong[] = {{"contacts[1]:",
                                                           [](Row& row) {
                                                             row.pairs[1] = {1, 3};
                                                           }},
                                                          {"contacts[1]:",
                                                           [](Row& row) {
                                                             row.pairs[1] = {1, 1};
                                                           }},
                                                          {"contacts[1]:",
                                                           [](Row& row) {
                                                             row.branch = {{0.9, 0, 0}, {-1.8, 0, 0}};
                                                           }},
                                                          {"grains[0]:", [](Row& row) { row.radius[0] = 0; }},
                                                          {"grains[2]:", [](Row& row) { row.radius[2] = 0; }},
                                                          {"grains:", [](Row& row) { row.edges.z = 0; }},
                                                          {"radius", [](Row& row) { row.radius.pop_back(); }},
                                                          {"force", [](Row& row) { row.force.pop_back(); }},
                                                          {"force", [](Row& row) {
                                                             row.normal = {1, 2};
                                                           }}};
  for (const auto& [element, change] : wrong) {
    Row row;
    change(row);
    const std::string said = arrays_refusal(row.arrays());
    CAPTURE(said);
    CHECK(said.starts_with(element));
  }
}

TEST_CASE("a grain between two walls: a second number below 0 is a wall") {
  const std::vector<Vec3> position{{1, 1, 0.48}};
  const std::vector<double> radius{0.5};
  const std::vector<std::array<long, 2>> pairs{{0, -1}, {0, -3}};
  const std::vector<Vec3> branch{{0, 0, -0.48}, {0, 0, 0.49}};
  const std::vector<Vec3> force{{0.5, 0, -3}, {0, 0, 3}};
  const io::PackingArrays arrays{.position = position,
                                 .radius = radius,
                                 .cell = Mat3::diagonal(2, 2, 1),
                                 .periodic = {false, false, false},
                                 .contacts =
                                     io::ContactArrays{.grains = pairs, .branch = branch, .force = force}};
  const packing::Assembly assembly = io::packing_of(arrays).assembly;
  CHECK(assembly.contacts.empty());
  REQUIRE(assembly.wall_contacts.size() == 2);
  const packing::Contact& floor = assembly.wall_contacts[0];
  CHECK((floor.i == 0 && floor.j == 0));
  CHECK(assembly.wall_contacts[1].j == 2);
  CHECK(floor.overlap == doctest::Approx(0.02));
  CHECK(floor.normal_force == doctest::Approx(3));
  CHECK(floor.tangential_force.x == doctest::Approx(0.5));
  // 3 N through the grain, from wall to wall 0.97 apart, in a box of volume 4
  CHECK(packing::contact_stress(assembly).tensor(2, 2) == doctest::Approx(3 * 0.97 / 4));

  io::PackingArrays without_branch = arrays;
  without_branch.contacts->branch = {};
  CHECK(arrays_refusal(without_branch).starts_with("contacts[0]"));
}

TEST_CASE("arrays: left-handed and leaning cells are those of the same lattice") {
  const std::vector<Vec3> position{{0.25, 0.25, 0.25}, {0.75, 0.25, 0.25}};
  const std::vector<double> radius{0.26, 0.26};
  const std::vector<std::array<long, 2>> pairs{{0, 1}};
  const std::vector<double> force{1};
  const auto read = [&](const Mat3& cell) {
    return io::packing_of({.position = position,
                           .radius = radius,
                           .cell = cell,
                           .contacts = io::ContactArrays{.grains = pairs, .normal_force = force}});
  };
  const io::ImportedPacking left = read({{{0, 2, 0}, {2, 0, 0}, {0, 0, 2}}});
  CHECK(left.has(io::Finding::cell_turned));
  CHECK(left.assembly.volume() == doctest::Approx(8));
  const io::ImportedPacking leaning = read({{{2, 12.4, 0}, {0, 2, 0}, {0, 0, 2}}}); // leans by 6.2 edges
  CHECK(leaning.has(io::Finding::cell_turned));
  CHECK(leaning.assembly.cell(0, 1) == doctest::Approx(0.4));
  CHECK(leaning.assembly.volume() == doctest::Approx(8));
  CHECK_FALSE(read({{{2, 1, 0}, {0, 2, 0}, {0, 0, 2}}}).has(io::Finding::cell_turned));
}
