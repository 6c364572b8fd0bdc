// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/imported_packing.hpp>

#include <granum/io/arrays/packing.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;

namespace {

constexpr double edge = 2e-3;

/// One grain, in contact with its images along x, y and z with forces 1, 2, 3.
ImportedPacking one_grain() {
  const std::vector<Vec3> position{{0, 0, 0}};
  const std::vector<double> radius{edge / 2 * (1 + 1e-6)};
  const std::vector<std::array<long, 2>> pairs{{0, 0}, {0, 0}, {0, 0}};
  const std::vector<Vec3> branch{{edge, 0, 0}, {0, -edge, 0}, {0, 0, edge}};
  const std::vector<double> force{1, 2, 3}, k_n{10, 10, 10}, k_t{8, 8, 8};
  return packing_of({.position = position,
                     .radius = radius,
                     .cell = Mat3::diagonal(edge, edge, edge),
                     .contacts = ContactArrays{.grains = pairs,
                                               .branch = branch,
                                               .normal_force = force,
                                               .normal_stiffness = k_n,
                                               .tangential_stiffness = k_t}});
}

} // namespace

TEST_CASE("a grain in contact with its own image is replicated as often as needed") {
  const ImportedPacking p = one_grain();
  CHECK(p.has(Finding::own_image));
  CHECK(p.assembly.grain_count() == 8);
  CHECK(packing::coordination_number(p.assembly) == doctest::Approx(6));
  const Mat3 stress = packing::contact_stress(p.assembly).symmetric;
  for (int k = 0; k < 3; ++k)
    CHECK(stress(k, k) == doctest::Approx((k + 1) / (edge * edge)));
  // the simple cubic lattice: C_11 = k_n/l
  const auto response = network::linear_response(p.assembly);
  CHECK(response.relaxed().matrix(0, 0) == doctest::Approx(10 / edge));
}

TEST_CASE("a packing twice has the stress, C_n and stiffness of one") {
  ImportedPacking p;
  p.periodic = {true, true, true};
  p.id = {3, 7};
  p.type = {1, 2};
  p.assembly = {.cell = Mat3::diagonal(2, 3, 4),
                .position = {{0.1, 0.5, 0.5}, {1.1, 0.5, 0.5}},
                .radius = {0.51, 0.51},
                .contacts = {{.i = 0, .j = 1, .branch = {-1, 0, 0}, .normal_force = 2, .normal_stiffness = 5},
                             {.i = 0, .j = 1, .branch = {1, 0, 0}, .normal_force = 2, .normal_stiffness = 5}},
                .wall_contacts = {{.i = 1, .j = 4, .branch = {0, -0.5, 0}, .normal_force = 1}},
                .body = {0, 1}};
  const ImportedPacking two = doubled(p, 0);
  require_valid(two.assembly);
  CHECK(two.id == std::vector<long>{3, 7, 8, 12});
  CHECK(two.type == std::vector<long>{1, 2, 1, 2});
  CHECK(two.assembly.body == std::vector<std::uint32_t>{0, 1, 2, 3});
  REQUIRE(two.assembly.wall_contacts.size() == 2);
  CHECK((two.assembly.wall_contacts[1].i == 3 && two.assembly.wall_contacts[1].j == 4));
  CHECK(two.assembly.contacts.size() == 4);
  CHECK(packing::contact_stress(two.assembly).symmetric(0, 0) ==
        doctest::Approx(packing::contact_stress(p.assembly).symmetric(0, 0)));
  CHECK(network::linear_response(two.assembly).affine().matrix(0, 0) ==
        doctest::Approx(network::linear_response(p.assembly).affine().matrix(0, 0)));
  // branches lead from centre to centre, by whole edges of the new cell
  const Mat3 parts = inverse_of(two.assembly.cell);
  for (const packing::Contact& c : two.assembly.contacts) {
    const Vec3 off = parts * (two.assembly.position[c.i] + c.branch - two.assembly.position[c.j]);
    for (int k = 0; k < 3; ++k)
      CHECK(std::abs(off[k] - std::round(off[k])) < 1e-12);
  }
}

TEST_CASE("without contacts, the largest grain is doubled along the edges where it reaches its own image") {
  const auto cell_of = [](const Mat3& cell, const std::array<bool, 3>& periodic = {true, true, true}) {
    ImportedPacking p;
    p.periodic = periodic;
    p.assembly = {.cell = cell, .position = {{0, 0, 0}, {0, 0, 1}}, .radius = {0.5, 0.2}, .contacts = {}};
    const ImportedPacking out = without_own_images(p);
    CHECK(out.assembly.volume() ==
          relative(p.assembly.volume() / 2 * static_cast<double>(out.assembly.grain_count()), 1e-12));
    CHECK(out.has(Finding::own_image) == (out.assembly.grain_count() > 2));
    return out.assembly.cell;
  };
  for (int k = 0; k < 3; ++k)
    for (const double length : {0.995, 1.005}) {
      Mat3 cell = Mat3::diagonal(3, 4, 5);
      cell(k, k) = length;
      CHECK(cell_of(cell)(k, k) == (length < 1 ? 2 : 1) * length);
      CHECK(cell_of(cell, {k != 0, k != 1, k != 2}) == cell);
    }
  CHECK(cell_of(Mat3::diagonal(0.9, 0.4, 3)) == Mat3::diagonal(1.8, 1.6, 3));
  CHECK(cell_of({{{2, 1.4, 0}, {0, 0.6, 0}, {0, 0, 3}}}) == Mat3{{{4, 1.4, 0}, {0, 0.6, 0}, {0, 0, 3}}});
}
