// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/rearrangement.hpp>

#include <Eigen/Dense>

#include "packing/sample_packings.hpp"
#include "unit.hpp"

using analysis::d2min;

namespace {

packing::Assembly sample() { return samples::random_network({.seed = 3, .repeats = 2}); }

/// A grain in the middle of a box, with neighbours at these branches.
packing::Assembly around(const std::vector<Vec3>& branches) {
  packing::Assembly a{
      .cell = Mat3::diagonal(10, 10, 10), .position = {{5, 5, 5}}, .radius = {1}, .contacts = {}};
  for (const Vec3& branch : branches) {
    a.position.push_back(Vec3{5, 5, 5} + branch);
    a.radius.push_back(1);
    a.contacts.push_back({.i = 0, .j = static_cast<std::uint32_t>(a.contacts.size() + 1), .branch = branch});
  }
  return a;
}

Eigen::Vector3d column_of(const Vec3& v) { return {v.x, v.y, v.z}; }

/// What b^T B^-1 b and the sum of all b are of the neighbours of a grain, B the sum of b b^T.
struct Neighbourhood {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;

  Neighbourhood(const packing::Assembly& a, std::uint32_t grain) {
    for (const packing::Contact& c : a.contacts)
      if (c.i == grain || c.j == grain) {
        const Eigen::Vector3d b = column_of(c.i == grain ? c.branch : -c.branch);
        squares += b * b.transpose();
        sum += b;
        count += 1;
      }
  }
  [[nodiscard]] double explained(const Eigen::Vector3d& b) const { return b.dot(squares.inverse() * b); }
};

} // namespace

TEST_CASE("a uniform deformation, a rotation and grains that cross faces leave no D2min") {
  const packing::Assembly before = sample();
  const Mat3 deformed{{{1.02, 0.03, 0}, {-0.01, 0.97, 0.02}, {0.005, 0, 1.01}}};
  const Mat3 turned{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  const double size = before.radius[0] * before.radius[0];
  for (const Mat3& map : {deformed, turned}) {
    packing::Assembly after = before;
    after.cell = map * before.cell;
    for (std::size_t g = 0; g < after.grain_count(); ++g) {
      after.position[g] = map * before.position[g];
      after.position[g] += (g % 3 == 0 ? 1.0 : 0.0) * column(after.cell, static_cast<int>(g % 2));
    }
    for (const double value : d2min(before, after, before.contacts))
      CHECK(value < 1e-26 * size);
  }
}

TEST_CASE("D2min where one grain moves is what the neighbours cannot explain, at it and at its neighbours") {
  const packing::Assembly before = sample();
  packing::Assembly after = before;
  constexpr std::uint32_t moved = 5;
  const Vec3 u = (0.01 * before.radius[moved]) * Vec3{1, -2, 0.5};
  after.position[moved] += u;
  const auto all = d2min(before, after, before.contacts);
  const Neighbourhood at(before, moved);
  REQUIRE(at.count >= 4);
  CHECK(all[moved] == relative(dot(u, u) * (at.count - at.explained(at.sum)), 1e-10));
  int checked = 0;
  for (const packing::Contact& c : before.contacts) {
    if (c.i != moved && c.j != moved)
      continue;
    const std::uint32_t other = c.i == moved ? c.j : c.i;
    const Neighbourhood beside(before, other);
    if (beside.count < 4)
      continue;
    ++checked;
    CHECK(all[other] == relative(dot(u, u) * (1 - beside.explained(column_of(c.branch))), 1e-10));
  }
  CHECK(checked >= 3);
  for (std::uint32_t g = 0; g < before.grain_count(); ++g) {
    const bool beside = std::any_of(before.contacts.begin(), before.contacts.end(), [&](const auto& c) {
      return (c.i == g && c.j == moved) || (c.i == moved && c.j == g);
    });
    if (g != moved && !beside)
      CHECK(all[g] < 1e-25 * dot(u, u));
  }
}

TEST_CASE("grains with up to three neighbours, and none, have no D2min") {
  const packing::Assembly before = around({{2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  packing::Assembly after = before;
  after.position[1] = {7.3, 5.2, 4.9};
  after.position[2] = {5.1, 6.8, 5};
  for (const double value : d2min(before, after, before.contacts))
    CHECK(value < 1e-28);
  CHECK(d2min(before, after, {}) == std::vector<double>(4, 0.0));
}

TEST_CASE("along an axis with walls a grain that crosses half of the box has moved that far") {
  const packing::Assembly before = around({{2, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, -2, 0}});
  packing::Assembly after = before;
  after.position[1].z += 8;
  // The neighbours at (2, 0, 0) and (-2, 0, 0): z = 4 + 2 x explains half of the square of 8.
  CHECK(d2min(before, after, before.contacts, {true, true, false})[0] == relative(32, 1e-12));
  CHECK(d2min(before, after, before.contacts)[0] == relative(2, 1e-12)); // by 2 through the face
}

TEST_CASE("states of other numbers of grains, and neighbours that are no grains, are refused") {
  const packing::Assembly before = sample();
  packing::Assembly fewer = before;
  fewer.position.pop_back();
  fewer.radius.pop_back();
  fewer.contacts.clear();
  CHECK_THROWS_AS((void)d2min(before, fewer, {}), InvalidArgument);
  const std::vector<packing::Contact> wrong{{.i = 0, .j = 1'000'000, .branch = {1, 0, 0}}};
  CHECK_THROWS_AS((void)d2min(before, before, wrong), InvalidArgument);
}
