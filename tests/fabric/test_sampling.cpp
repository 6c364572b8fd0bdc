// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/orientation.hpp>

#include "unit.hpp"

namespace {

constexpr std::size_t many = 100000;

/// Mean of a quantity over the sample, in standard errors from what it should be.
template <class Quantity>
double deviation(const std::vector<Vec3>& normals, double expected, Quantity quantity) {
  double sum = 0, squares = 0;
  for (const Vec3& n : normals) {
    const double value = quantity(n) - expected;
    sum += value;
    squares += value * value;
  }
  return sum / std::sqrt(squares);
}

} // namespace

TEST_CASE("sampling: the whole distribution of the polar cosine and of the azimuth") {
  for (const double a : {-1.0, 0.4, 1.0}) {
    std::vector<double> shares, azimuths;
    for (const Vec3& n : fabric::sample_normals(a, many, 99)) {
      shares.push_back(fabric::cumulative_probability(std::abs(n.z), a));
      azimuths.push_back(std::atan2(n.y, n.x) / (2 * std::numbers::pi) + 0.5);
    }
    for (auto* values : {&shares, &azimuths}) { // uniform on [0, 1]: Kolmogorov's largest distance
      std::sort(values->begin(), values->end());
      double distance = 0;
      for (std::size_t i = 0; i < many; ++i)
        distance = std::max(distance, std::abs((*values)[i] - (static_cast<double>(i) + 0.5) / many));
      CHECK(distance * std::sqrt(many) < 2.2); // exceeded once in 8,000 samples
    }
  }
}

TEST_CASE("sampling: one seed, one sample, and a longer one begins with it") {
  const auto first = fabric::sample_normals(0.5, 100, 7), again = fabric::sample_normals(0.5, 100, 7);
  const auto longer = fabric::sample_normals(0.5, 150, 7), other = fabric::sample_normals(0.5, 100, 8);
  CHECK(first == again);
  CHECK(std::equal(first.begin(), first.end(), longer.begin()));
  CHECK(first != other);
  CHECK(fabric::sample_normals(0.5, 0, 7).empty());
  for (const double no_density : {1.01, std::nan("")})
    CHECK_THROWS_AS((void)fabric::sample_normals(no_density, 10, 1), InvalidArgument);
}
