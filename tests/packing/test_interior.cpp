// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a sphere lies in the interior of a box.
#include <granum/packing/interior.hpp>

#include "sample_packings.hpp"
#include "unit.hpp"

namespace {

constexpr double ball = 4.0 / 3 * std::numbers::pi;

/// The part of a sphere of radius R about x inside the box [0, edges].
double part(const Vec3& edges, const Vec3& x, double radius = 1) {
  return packing::Interior(Mat3::diagonal(edges.x, edges.y, edges.z), 0).part_of_sphere(x, radius);
}

} // namespace

TEST_CASE("a sphere whole, outside, and cut by the faces of one axis: closed form") {
  CHECK(part({9, 9, 9}, {4, 5, 3}) == relative(ball, 1e-15));
  for (const double z : {-1.0, 10.5})
    CHECK(part({9, 9, 9}, {4, 5, z}) == 0);
  CHECK(part({9, 9, 9}, {4, 0, 3}) == relative(ball / 2, 1e-15));
  // Cap of height h: pi h^2 (1 - h/3).
  CHECK(part({9, 9, 9}, {-0.7, 5, 5}) == relative(std::numbers::pi * 0.09 * 0.9, 1e-13));
  CHECK(part({9, 0.6, 9}, {4, 0.3, 5}) ==
        relative(ball - 2 * std::numbers::pi * 0.49 * (1 - 0.7 / 3), 1e-14));
  CHECK(part({9e-3, 9e-3, 9e-3}, {4e-3, 0, 3e-3}, 1e-3) == relative(ball / 2 * 1e-9, 1e-13));
  CHECK_THROWS_AS((void)part({9, 9, 9}, {4, 0, 3}, 0), InvalidArgument);
}

TEST_CASE("a sphere at edges and corners: symmetry, additivity, and a small box that it fills") {
  CHECK(part({9, 9, 9}, {4, 0, 0}) == relative(ball / 4, 1e-13));
  CHECK(part({9, 9, 9}, {9, 9, 0}) == relative(ball / 8, 1e-13));
  CHECK(part({0.5, 0.6, 0.7}, {0.2, 0.3, 0.4}) == relative(0.21, 1e-13));
  samples::Uniform uniform(3);
  for (int trial = 0; trial < 200; ++trial) {
    // Eight corners of space meet in a point: their parts of the sphere add up to all of it.
    Vec3 at = uniform.vector(1.1);
    if (trial % 10 == 0)
      at.y = at.x; // heights that coincide
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 x;
      for (int k = 0; k < 3; ++k)
        x[k] = (corner >> k & 1) ? 9 + at[k] : at[k];
      sum += part({9, 9, 9}, x);
    }
    CHECK(sum == relative(ball, 1e-10));
    // Sections across any axis, in a box that cuts the sphere from all sides.
    const Vec3 edges{uniform(0.1, 2.5), uniform(0.1, 2.5), uniform(0.1, 2.5)};
    const double whole = part(edges, at);
    CHECK(std::abs(part({edges.y, edges.z, edges.x}, {at.y, at.z, at.x}) - whole) < 1e-10);
    CHECK(std::abs(part({edges.z, edges.x, edges.y}, {at.z, at.x, at.y}) - whole) < 1e-10);
  }
}

TEST_CASE(
    "a lattice cut anywhere by faces a whole number of edges apart: the solid fraction of the lattice") {
  const Mat3 box = Mat3::diagonal(8, 8, 8);
  for (const Vec3& shift : {Vec3{0, 0, 0}, Vec3{0.2, 0.1, 0.35}, Vec3{-0.5, 0.5, 0.4}})
    for (const double layer : {1.5, 2.0, 2.5}) {
      const packing::Interior interior(box, layer);
      double solid = 0;
      for (int p = -1; p < 9; ++p)
        for (int q = -1; q < 9; ++q)
          for (int r = -1; r < 9; ++r)
            solid += interior.part_of_sphere(
                shift + Vec3{static_cast<double>(p), static_cast<double>(q), static_cast<double>(r)}, 0.5);
      CHECK(solid / interior.volume() == relative(std::numbers::pi / 6, 1e-11));
    }
}

TEST_CASE("the interior of a box: volume, members, and shares of a branch") {
  Mat3 cell = Mat3::diagonal(10, 10, 10);
  const packing::Interior inside(cell, 2);
  CHECK(inside.volume() == relative(216, 1e-14));
  CHECK(inside.holds({5, 5, 2.1}));
  CHECK_FALSE(inside.holds({5, 5, 1.9}));
  CHECK_FALSE(inside.holds({8.1, 5, 5}));
  CHECK(inside.share({5, 5, 5}, {1, 0, 0}) == 1);
  CHECK(inside.share({1, 5, 5}, {4, 0, 0}) == relative(0.75, 1e-14));
  CHECK(inside.share({1, 5, 5}, {8, 0, 0}) == relative(0.75, 1e-14));
  CHECK(inside.share({1, 1, 5}, {0.5, 8, 0}) == 0);
  CHECK(inside.share({9, 5, 5}, {-4, 0, 0}) == relative(0.75, 1e-14));
  // A window holds what lies in it, also through the faces of the cell.
  const packing::Interior window(cell, {1, 2, 3}, {4, 6, 11});
  for (const Vec3& x :
       {Vec3{2, 5, 8}, Vec3{12, 5, 0.5}, Vec3{-8, -5, 8}, Vec3{1.1, 2.1, 3.1}, Vec3{3.9, 5.9, 10.9}})
    CHECK(window.holds(x));
  for (const double image :
       {0.0, 10.0, -20.0}) { // of one on its lower face, and a branch that leaves it halfway
    CHECK(window.part_of_sphere({1 + image, 4 - image, 7}, 0.5) == relative(ball / 16, 1e-13));
    CHECK(window.share({2 + image, 4, 7 - image}, {4, 0, 0}) == relative(0.5, 1e-13));
  }
  for (const Vec3& x : {Vec3{0.9, 5, 8}, Vec3{4.1, 5, 8}, Vec3{2, 6.1, 8}, Vec3{2, 5, 2.9}, Vec3{2, 5, 1.1}})
    CHECK_FALSE(window.holds(x));
  CHECK_THROWS_AS(packing::Interior(cell, 5), InvalidArgument);
  CHECK_THROWS_AS(packing::Interior(cell, -1), InvalidArgument);
}
