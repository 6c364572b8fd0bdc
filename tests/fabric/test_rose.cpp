// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/estimates.hpp>

#include <granum/core/numerics.hpp>
#include <granum/fabric/orientation.hpp>

#include "unit.hpp"

TEST_CASE("rose: expected counts and densities are those of the density over each bin") {
  const std::vector<Vec3> normals(1000, Vec3{0, 0, 1});
  for (const double a : {-1.0, 0.0, 0.7, 1.0})
    for (const auto& bin : fabric::rose(normals, a, 9)) {
      double share = 0, solid_angle = 0; // both hemispheres
      for (const auto& [x, w] : gauss_legendre(16)) {
        const double gamma = (bin.low + bin.high) / 2 + (bin.high - bin.low) / 2 * x;
        const double ring = 4 * std::numbers::pi * std::sin(gamma) * w * (bin.high - bin.low) / 2;
        share += ring * fabric::density(gamma, a);
        solid_angle += ring;
      }
      CHECK(std::abs(bin.expected_count - 1000 * share) < 1e-11);
      CHECK(std::abs(bin.expected_density - share / solid_angle) < 1e-14);
    }
}

TEST_CASE("rose: counts add up, and scatter about the expected ones within their error bars") {
  const auto normals = fabric::sample_normals(0.5, 20000, 12);
  const auto bins = fabric::rose(normals, 0.5, 18);
  REQUIRE(bins.size() == 18);
  std::size_t count = 0;
  double expected = 0, integral = 0, squares = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const auto& bin = bins[i];
    count += bin.count;
    expected += bin.expected_count;
    integral += bin.density * 4 * std::numbers::pi * (std::cos(bin.low) - std::cos(bin.high));
    squares += std::pow(static_cast<double>(bin.count) - bin.expected_count, 2) / bin.expected_count;
    CHECK(bin.count_error == relative(std::sqrt(static_cast<double>(bin.count)), 1e-15));
    CHECK(bin.density_error / bin.density == relative(1 / bin.count_error, 1e-14));
    CHECK(bin.low == (i == 0 ? 0 : bins[i - 1].high));
  }
  CHECK(count == 20000);
  CHECK(expected == relative(20000, 1e-14));
  CHECK(integral == relative(1, 1e-13));
  CHECK(bins.back().high == relative(std::numbers::pi / 2, 1e-15));
  CHECK(std::abs(squares - 17) < 4 * std::sqrt(2 * 17.0)); // chi-square of 17 degrees of freedom
}

TEST_CASE("rose: either sense of a normal, and the ends of the range, fall into their bins") {
  const auto bins = fabric::rose(
      std::vector<Vec3>{
          {0, 0, 1}, {0, 0, -1}, {1e-9, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.8, 0, -0.6}, {0.8, 0, 0.6}},
      0, 2);
  CHECK(bins[0].count == 3);
  CHECK(bins[1].count == 4);
  CHECK(fabric::rose(std::vector<Vec3>{{0, 0, 1}}, 0, 1)[0].density ==
        relative(1 / (4 * std::numbers::pi), 1e-15));
}

TEST_CASE("rose: bins are merged until the bin at the vertical is expected to contain 25 contacts") {
  std::vector<std::size_t> counts(18);
  const auto bins = [&](std::size_t contacts) {
    counts.assign(18, 0);
    counts[17] = contacts;
    return fabric::readable_rose(counts, 0).size();
  };
  // 25/(1 - cos w) contacts for w of 5, 10, 15 degrees: 6570, 1645.6, 733.7.
  for (const auto& [contacts, count] :
       {std::pair(6570, 18), {6569, 9}, {1646, 9}, {1645, 6}, {734, 6}, {733, 3}, {1, 3}})
    CHECK(bins(static_cast<std::size_t>(contacts)) == static_cast<std::size_t>(count));
  CHECK(fabric::readable_rose(std::vector<std::size_t>{1, 1}, 0).size() == 2);

  for (std::size_t k = 0; k < 18; ++k)
    counts[k] = 10 + 5 * k;
  const auto fine = fabric::rose_of_counts(counts, 0.3), few = fabric::readable_rose(counts, 0.3);
  REQUIRE(few.size() == 6);
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK(std::abs(few[k].low - fine[3 * k].low) < 1e-15);
    CHECK(few[k].high == relative(fine[3 * k + 2].high, 1e-14));
    CHECK(few[k].count == fine[3 * k].count + fine[3 * k + 1].count + fine[3 * k + 2].count);
    CHECK(few[k].count_error == std::sqrt(static_cast<double>(few[k].count)));
    CHECK(few[k].expected_count == relative(fine[3 * k].expected_count + fine[3 * k + 1].expected_count +
                                                fine[3 * k + 2].expected_count,
                                            1e-12));
  }
}

TEST_CASE("rose: bad input") {
  CHECK_THROWS_AS((void)fabric::rose_of_counts({}, 0), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::rose_of_counts(std::vector<std::size_t>{0, 0}, 0), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::readable_rose({}, 0), InvalidArgument);
  const std::vector<Vec3> one{{0, 0, 1}}, longer{{0, 0, 1.1}};
  CHECK_THROWS_AS((void)fabric::rose({}, 0, 9), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::rose(longer, 0, 9), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::rose(one, 1.1, 9), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::rose(one, 0, 0), InvalidArgument);
  CHECK(fabric::rose(one, 0, 1000).size() == 1000);
  CHECK_THROWS_AS((void)fabric::rose(one, 0, 1001), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::rose_of_counts(std::vector<std::size_t>(1001, 1), 0), InvalidArgument);
}
