// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/assembly.hpp>

#include "unit.hpp"

using namespace granum::packing;

namespace {

constexpr double gamma_g = 26e3; // [N/m3]

double weight_of(double radius) { return gamma_g * 4 / 3 * std::numbers::pi * radius * radius * radius; }

/// A column of spheres of three sizes on a floor, each bearing what lies above it; one grain floats beside
/// it.
Assembly column() {
  Assembly a{.cell = Mat3::diagonal(1, 1, 1),
             .position = {{0.5, 0.5, 0.1}, {0.5, 0.5, 0.35}, {0.5, 0.5, 0.55}, {0.1, 0.1, 0.9}},
             .radius = {0.1, 0.15, 0.05, 0.05},
             .contacts = {}};
  const double top = weight_of(0.05), middle = top + weight_of(0.15), all = middle + weight_of(0.1);
  a.contacts = {{.i = 0, .j = 1, .branch = {0, 0, 0.25}, .normal_force = middle},
                {.i = 1, .j = 2, .branch = {0, 0, 0.2}, .normal_force = top}};
  a.wall_contacts = {{.i = 0, .j = 0, .branch = {0, 0, -0.1}, .normal_force = all}};
  return a;
}

} // namespace

TEST_CASE("weight: a column of unequal spheres shows density times gravity") {
  const Weight weight = common_weight(column());
  CHECK(weight.per_volume.x == 0);
  CHECK(weight.per_volume.y == 0);
  CHECK(weight.per_volume.z == relative(-gamma_g, 1e-12));
  CHECK(weight.left_over < 1e-12);
}

TEST_CASE("weight: other unbalance is not weight, and without any there is none") {
  Assembly a = column();
  a.contacts[0].normal_force *= 3;
  CHECK(common_weight(a).left_over > 0.2);
  a.contacts.clear();
  a.wall_contacts.clear();
  CHECK(common_weight(a).left_over == 1);
  Assembly rest{.cell = Mat3::diagonal(1, 1, 1), .position = {{0, 0, 0}}, .radius = {0.1}, .contacts = {}};
  rest.wall_contacts = {{.i = 0, .j = 0, .branch = {0, 0, -0.1}, .normal_force = 2},
                        {.i = 0, .j = 1, .branch = {0, 0, 0.1}, .normal_force = 2}};
  CHECK(common_weight(rest).left_over == 1);
  rest.radius = {-1};
  CHECK_THROWS(static_cast<void>(common_weight(rest)));
}
