// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/estimates.hpp>

#include <granum/fabric/orientation.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

TEST_CASE(
    "anisotropy estimates by moments and by likelihood: within their standard errors, which are those of "
    "repeated samples") {
  constexpr int repeats = 300;
  std::uint64_t seed = 1000;
  struct Sums {
    double error = 0, squares = 0, reported = 0;

    void add(double off, double standard_error) {
      error += off / repeats;
      squares += off * off / repeats;
      reported += standard_error / repeats;
    }
    void check() const {
      const double scatter = std::sqrt(squares);
      CHECK(std::abs(error) < 4 * scatter / std::sqrt(repeats)); // bias: four standard errors of the mean
      CHECK(std::abs(scatter / reported - 1) < 4 / std::sqrt(2.0 * repeats)); // four of a scatter
    }
  };
  for (const double a : {-0.8, 0.0, 0.5, 0.85}) {
    CAPTURE(a);
    Sums by_moments, by_likelihood;
    for (int i = 0; i < repeats; ++i) {
      const auto normals = fabric::sample_normals(a, 2000, seed++);
      const auto moments = fabric::estimate_anisotropy(normals);
      by_moments.add(moments.anisotropy - a, moments.standard_error);
      const auto likelihood = fabric::estimate_anisotropy_by_likelihood(normals);
      by_likelihood.add(likelihood.anisotropy - a, likelihood.standard_error);
    }
    by_moments.check();
    by_likelihood.check();
    const double ratio = std::sqrt(by_likelihood.squares / by_moments.squares); // of the same samples
    if (a == 0) {
      CHECK(std::abs(ratio - 1) < 0.02); // at isotropy the two are one to first order
      CHECK(by_moments.reported == doctest::Approx(fabric::isotropic_standard_error(2000)).epsilon(0.01));
    } else if (a == 0.85) {
      CHECK(ratio < 0.97);
    }
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
  for (const double sign : {1, -1})
    check_threshold(1e-6, [=](double off) { // of the length of a normal
      try {
        return fabric::estimate_anisotropy(std::vector<Vec3>{{0, 0, 1 + sign * off}, {1, 0, 0}}).contacts == 2
                   ? 0
                   : 9;
      } catch (const InvalidArgument&) {
        return 1;
      }
    });
  const std::vector<Vec3> none, one{{0, 0, 1}}, longer{{0, 0, 1}, {0, 0, 1.1}},
      undefined{{0, 0, 1}, {std::nan(""), 0, 0}};
  for (const std::vector<Vec3>& bad : {none, one, longer, undefined}) {
    CHECK_THROWS_AS((void)fabric::estimate_anisotropy(bad), InvalidArgument);
    CHECK_THROWS_AS((void)fabric::estimate_anisotropy_by_likelihood(bad), InvalidArgument);
  }
}
