// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/estimates.hpp>

#include <random>

#include <granum/fabric/orientation.hpp>

#include "unit.hpp"

namespace {

/// A number in [0, 1) from the generator's own bits, the same with every standard library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// Unit vectors distributed as E(gamma; a), by rejection.
std::vector<Vec3> sample(double anisotropy, std::size_t count, std::mt19937_64& random) {
  const double top = 1 + std::abs(anisotropy);
  std::vector<Vec3> normals;
  while (normals.size() < count) {
    const double z = 2 * uniform(random) - 1;
    const double phi = 2 * std::numbers::pi * uniform(random);
    if (uniform(random) * top > 1 + anisotropy * (2 * z * z - 1))
      continue;
    const double s = std::sqrt(1 - z * z);
    normals.push_back({s * std::cos(phi), s * std::sin(phi), z});
  }
  return normals;
}

} // namespace

TEST_CASE(
    "anisotropy estimate: recovers a within its own standard error, which is that of repeated samples") {
  std::mt19937_64 random(20140213);
  constexpr int repeats = 400;
  for (const double a : {-0.8, 0.0, 0.5, 1.0}) {
    CAPTURE(a);
    double sum = 0, squares = 0, reported = 0;
    for (int i = 0; i < repeats; ++i) {
      const auto estimate = fabric::estimate_anisotropy(sample(a, 2000, random));
      sum += estimate.anisotropy - a;
      squares += (estimate.anisotropy - a) * (estimate.anisotropy - a);
      reported += estimate.standard_error / repeats;
    }
    const double scatter = std::sqrt(squares / repeats);
    CHECK(std::abs(sum / repeats) <
          4 * scatter / std::sqrt(repeats)); // bias: four standard errors of the mean
    CHECK(std::abs(scatter / reported - 1) <
          4 / std::sqrt(2.0 * repeats)); // four standard errors of a scatter
    if (a == 0)
      CHECK(reported == doctest::Approx(fabric::isotropic_standard_error(2000)).epsilon(0.01));
  }
}

TEST_CASE("anisotropy estimate: isotropic scatter") {
  CHECK(fabric::isotropic_standard_error(1) == doctest::Approx(5.625 * std::sqrt(4.0 / 45)).epsilon(1e-15));
  CHECK(fabric::isotropic_standard_error(29000) == doctest::Approx(0.00985).epsilon(1e-3));
  CHECK_THROWS_AS((void)fabric::isotropic_standard_error(0), InvalidArgument);
}

TEST_CASE("anisotropy estimate: known directions") {
  // Faces of a cube: F33 = 1/3 exactly. n3^2 is 0, 0, 1: sample variance 1/3, error of F33 = 1/3.
  const std::vector<Vec3> cube{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto isotropic = fabric::estimate_anisotropy(cube);
  CHECK(std::abs(isotropic.anisotropy) < 1e-15);
  CHECK(isotropic.standard_error == doctest::Approx(5.625 / 3).epsilon(1e-14));
  CHECK(isotropic.contacts == 3);
  CHECK(isotropic.validity.ok());

  const std::vector<Vec3> vertical{{0, 0, 1}, {0, 0, -1}};
  const auto extreme = fabric::estimate_anisotropy(vertical);
  CHECK(extreme.anisotropy == doctest::Approx(5.0 / 3).epsilon(1e-15));
  CHECK(extreme.standard_error == 0);
  CHECK(extreme.validity.notes.size() == 1);

  const std::vector<Vec3> flat{{1, 0, 0}, {0, 1, 0}};
  CHECK(fabric::estimate_anisotropy(flat).anisotropy == -5);
  CHECK_FALSE(fabric::estimate_anisotropy(flat).validity.ok());
}

TEST_CASE("anisotropy estimate: bad input") {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)fabric::estimate_anisotropy({}), InvalidArgument);
  const std::vector<Vec3> one{{0, 0, 1}}, long_one{{0, 0, 1}, {0, 0, 1.1}},
      bad{{0, 0, 1}, {not_a_number, 0, 0}};
  CHECK_THROWS_AS((void)fabric::estimate_anisotropy(one), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::estimate_anisotropy(long_one), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::estimate_anisotropy(bad), InvalidArgument);
}
