// SPDX-License-Identifier: GPL-3.0-or-later
// The slow exact twin of the cell list: all pairs over all images.
#include <granum/dem/neighbours.hpp>

#include <random>
#include <set>
#include <tuple>

#include <granum/core/stop.hpp>

#include "unit.hpp"

using namespace granum::dem;

namespace {

std::vector<Vec3> random_points(const Mat3& cell, std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < count; ++k) {
    Vec3 s;
    for (int axis = 0; axis < 3; ++axis)
      s[axis] = static_cast<double>(random() >> 11) * 0x1p-53;
    points.push_back(cell * s);
  }
  return points;
}

/// Of grains whose radii sum up with the gap to more than their distance.
std::vector<Pair> all_pairs(const Mat3& cell, const std::vector<Vec3>& x, const std::vector<double>& radius,
                            double gap) {
  const auto shifts = shift_vectors(cell);
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < x.size(); ++i)
    for (std::uint32_t j = i + 1; j < x.size(); ++j)
      for (std::uint32_t image = 0; image < 27; ++image)
        if (norm(x[j] + shifts[image] - x[i]) < radius[i] + radius[j] + gap)
          pairs.push_back({i, j, image});
  return pairs;
}

std::vector<Pair> all_pairs(const Mat3& cell, const std::vector<Vec3>& x, double cutoff) {
  return all_pairs(cell, x, std::vector<double>(x.size()), cutoff);
}

const Mat3 cube = Mat3::diagonal(1, 1, 1);
const Mat3 slab = Mat3::diagonal(0.9, 1.7, 3.1);
const Mat3 skew{{{1.2, 0.3, -0.2}, {0, 1.1, 0.25}, {0.1, 0, 1.3}}};

} // namespace

TEST_CASE("the cell list finds exactly the pairs that a search over all images finds") {
  for (const Mat3& cell : {cube, slab, skew})
    for (const double cutoff : {0.12, 0.2, 0.29, 0.4}) {
      const std::vector<Vec3> x = random_points(cell, 300, 7);
      CHECK(neighbour_pairs(cell, x, cutoff) == all_pairs(cell, x, cutoff));
    }
}

TEST_CASE("the cell list finds the pairs of a nearly empty cell, whose bins are wider than the cutoff") {
  for (const Mat3& cell : {cube, Mat3::diagonal(1, 2, 400)}) {
    std::vector<Vec3> x = random_points(cell, 20, 3);
    for (int k = 0; k < 20; ++k) // a neighbour for each, across the edges of the cell too
      x.push_back(x[static_cast<std::size_t>(k)] + Vec3{2e-3, -3e-3, 4e-3});
    wrap(cell, x);
    const std::vector<Pair> pairs = neighbour_pairs(cell, x, 1e-2);
    CHECK(pairs.size() >= 20);
    CHECK(pairs == all_pairs(cell, x, 1e-2));
    const std::vector<double> radius(x.size(), 4e-3);
    CHECK(neighbour_pairs(cell, x, radius, 2e-3) == pairs);
  }
}

TEST_CASE("with a radius for each grain, the same pairs as a search over all images") {
  for (const Mat3& cell : {cube, slab, skew})
    for (const double ratio : {1.0, 2.0, 5.0, 20.0}) {
      const std::vector<Vec3> x = random_points(cell, 300, 7);
      std::vector<double> radius;
      for (std::size_t g = 0; g < x.size(); ++g)
        radius.push_back(0.2 / ratio * std::pow(ratio, 0.5 + 0.5 * std::sin(static_cast<double>(g))));
      const std::vector<Pair> expected = all_pairs(cell, x, radius, 0.01);
      std::vector<Pair> in_box = expected;
      std::erase_if(in_box, [](const Pair& pair) { return pair.image != 13; });
      CHECK(expected.size() > 50);
      CHECK(neighbour_pairs(cell, x, radius, 0.01) == expected);
      CHECK(neighbour_pairs(cell, x, radius, 0.01, Images::none) == in_box);
    }
  const std::vector<Vec3> two{{0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}};
  CHECK_THROWS_AS((void)neighbour_pairs(cube, two, std::vector<double>{0.1}, 0.0), InvalidArgument);
  CHECK_THROWS_AS((void)neighbour_pairs(cube, two, std::vector<double>{0.1, 0.26}, 0.0), InvalidArgument);
}

TEST_CASE("a search for pairs ends on a stop request") {
  const std::vector<Vec3> x = random_points(cube, 10, 7);
  const StopScope scope([] { return true; });
  CHECK_THROWS_AS((void)neighbour_pairs(cube, x, 0.2), Stopped);
  CHECK_THROWS_AS((void)neighbour_pairs(cube, x, std::vector<double>(x.size(), 0.1), 0.0), Stopped);
}

TEST_CASE("wrapping moves by whole edge vectors into the cell") {
  std::vector<Vec3> x = random_points(skew, 50, 3);
  const std::vector<Vec3> inside = x;
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] += skew * Vec3{static_cast<double>(k % 3) - 1, static_cast<double>(k % 5) - 2, 1};
  wrap(skew, x);
  for (std::size_t k = 0; k < x.size(); ++k)
    CHECK(norm(x[k] - inside[k]) < 1e-14);
}

TEST_CASE("a cell too narrow for the cutoff is refused, for no pair may meet twice") {
  const std::vector<Vec3> x{{0.1, 0.1, 0.1}};
  CHECK_THROWS_AS((void)neighbour_pairs(cube, x, 0.51), InvalidArgument);
  CHECK_THROWS_AS((void)neighbour_pairs(cube, x, 0), InvalidArgument);
  CHECK(neighbour_pairs(cube, x, 0.5).empty());
  CHECK(neighbour_pairs(cube, {}, 0.5).empty());
}
