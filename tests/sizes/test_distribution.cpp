// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sizes/distribution.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::sizes;

namespace {

const std::vector<SievePoint> sand{{0.1e-3, 0}, {0.2e-3, 0.05}, {0.4e-3, 0.5}, {0.6e-3, 0.5}, {1e-3, 1}};

std::vector<Distribution> all_forms() {
  return {Distribution::equal(),
          Distribution::bidisperse(1.4),
          Distribution::bidisperse(5, 0.03),
          Distribution::uniform(1, 3),
          Distribution::lognormal(0.35),
          Distribution::lognormal(0.9, 40),
          Distribution::lognormal(0.05, 100),
          Distribution::power_law(3.5, 10),
          Distribution::power_law(4, 100),
          Distribution::power_law(1, 2),
          Distribution::uniformity(1.5),
          Distribution::uniformity(4),
          Distribution::uniformity(12, 200),
          Distribution::sieve(sand)};
}

double sum(const Distribution& sizes, double k) {
  double total = 0;
  for (const auto& [x, share] : sizes.nodes())
    total += share * std::pow(x, k);
  return total;
}

} // namespace

TEST_CASE(
    "moments are the sums over the nodes, an independent way to them, and relative to the mean by number") {
  for (const Distribution& sizes : all_forms()) {
    CAPTURE(sizes.text());
    for (const double k : {-6.0, -1.5, 0.0, 1.0, 2.0, 3.0, 4.5, 6.0}) {
      CAPTURE(k);
      CHECK(sum(sizes, k) == relative(sizes.moment(k), 1e-12));
    }
    for (const double k : {0.0, 1.0})
      CHECK(sizes.moment(k) == relative(1, 1e-14));
    CHECK(sizes.smallest() <= 1);
    CHECK(sizes.largest() >= 1);
  }
}

TEST_CASE("a share and its quantile undo each other, by number and by mass") {
  for (const Distribution& sizes : all_forms()) {
    if (sizes.nodes().size() < 3)
      continue; // steps have no inverse
    for (const double k : {0.0, 3.0})
      for (const double share : {1e-6, 0.1, 0.49, 0.6, 0.999}) {
        CAPTURE(sizes.text());
        CAPTURE(k);
        CHECK(std::abs(sizes.share_below(sizes.quantile(share, k), k) - share) < 1e-13);
      }
    CHECK(sizes.quantile(0) == sizes.smallest());
    CHECK(sizes.quantile(1) == sizes.largest());
    CHECK(sizes.share_below(0.99 * sizes.smallest(), 3) == 0);
    CHECK(sizes.share_below(1.01 * sizes.largest(), 3) == 1);
  }
}

TEST_CASE("the share of mass below a radius is the sum over the nodes below it") {
  // By the density alone: the trapezium rule over quantiles by number, whose steps hold equal numbers.
  for (const Distribution& sizes : {Distribution::lognormal(0.35), Distribution::power_law(3.5, 10),
                                    Distribution::uniformity(2.5), Distribution::sieve(sand)}) {
    CAPTURE(sizes.text());
    constexpr int steps = 20000;
    double mass = 0;
    const double x = sizes.quantile(0.4);
    for (int k = 0; k < steps; ++k)
      mass += std::pow(sizes.quantile(0.4 * (k + 0.5) / steps), 3) * 0.4 / steps;
    CHECK(mass / sizes.moment(3) == relative(sizes.share_below(x, 3), 1e-6));
  }
}

TEST_CASE("moments known in closed form") {
  // Uniform on [1, 3]: <x^3> = 10 and <x> = 2; uncut lognormal: <x^k> = exp(k (k - 1) sigma^2/2).
  CHECK(Distribution::uniform(1, 3).moment(3) == relative(10.0 / 8, 1e-14));
  CHECK(Distribution::uniform(1, 3).moment(2) == relative(13.0 / 12, 1e-14));
  CHECK(Distribution::power_law(0, 3).moment(5) == relative(Distribution::uniform(1, 3).moment(5), 1e-14));
  CHECK(Distribution::lognormal(0.3, 1e6).moment(3) == relative(std::exp(3 * 0.09), 1e-13));
  CHECK(Distribution::lognormal(0.3, 1e6).moment(6) == relative(std::exp(15 * 0.09), 1e-8)); // cut at 9 sigma
  const Distribution two = Distribution::bidisperse(1.4, 0.25);
  CHECK(two.moment(3) == relative((0.75 + 0.25 * 2.744) / std::pow(0.75 + 0.25 * 1.4, 3), 1e-14));
  CHECK(two.share_below(1, 3) == relative(0.75 / (0.75 + 0.25 * 2.744), 1e-14));
  CHECK(two.size_ratio() == relative(1.4, 1e-15));
}

TEST_CASE("a lognormal has the tails stated in its header") {
  const Distribution cut = Distribution::lognormal(0.35), whole = Distribution::lognormal(0.35, 1e6);
  CHECK(cut.size_ratio() == relative(7.36, 1e-3));
  // Radii are relative to slightly different means.
  const double scale = cut.quantile(0.5) / whole.quantile(0.5 * 0.98 + 0.01);
  CHECK(whole.share_below(cut.smallest() / scale) == doctest::Approx(0.01).epsilon(0.02));
  CHECK(whole.share_below(cut.largest() / scale, 3) == doctest::Approx(0.99).epsilon(0.001));
  CHECK(Distribution::lognormal(0.35, 5).size_ratio() == relative(5, 1e-14));
  // Nothing is beyond nine standard deviations of both medians.
  CHECK(std::log(Distribution::lognormal(0.05, 1e6).size_ratio()) ==
        relative(2 * (9 * 0.05 + 1.5 * 0.05 * 0.05), 1e-13));
}

TEST_CASE("a uniformity is met exactly, also where the tails are cut elsewhere") {
  for (const double C_u : {1.001, 1.5, 2.5, 4.0, 12.0})
    for (const double room : {1.1, 2.0, 10.0}) {
      CAPTURE(C_u);
      CAPTURE(room);
      CHECK(gradation(Distribution::uniformity(C_u), 1).uniformity() == relative(C_u, 1e-10));
      const Distribution cut = Distribution::uniformity(C_u, C_u * C_u * room);
      CHECK(gradation(cut, 1).uniformity() == relative(C_u, 1e-10));
      if (C_u > 1.1)
        CHECK(cut.size_ratio() == relative(C_u * C_u * room, 1e-9));
    }
  CHECK(Distribution::uniformity(2.5).size_ratio() == relative(std::pow(2.5, 2.52), 0.01));
}

TEST_CASE("a sieve curve passes through its points, and has sizes in metres") {
  const Distribution sizes = Distribution::sieve(sand);
  REQUIRE(sizes.mean_radius());
  const double mean = *sizes.mean_radius();
  CHECK(2 * mean * sizes.smallest() == relative(0.1e-3, 1e-14));
  CHECK(2 * mean * sizes.largest() == relative(1e-3, 1e-14));
  for (const auto& [d, passing] : sand)
    CHECK(std::abs(sizes.share_below(d / (2 * mean), 3) - passing) < 1e-13);
  // Straight in log d: a quarter of the way in log d from 5 % to 50 % holds a quarter of the difference.
  CHECK(sizes.share_below(0.2e-3 * std::pow(2, 0.25) / (2 * mean), 3) == relative(0.05 + 0.45 / 4, 1e-13));
  const Gradation g = gradation(sizes, mean);
  CHECK(g.d10 == relative(0.2e-3 * std::pow(2, 0.05 / 0.45), 1e-12));
  CHECK(g.d60 == relative(0.6e-3 * std::pow(1 / 0.6, 0.2), 1e-12));
  CHECK(mean_radius_of(sizes, g.d50) == relative(mean, 1e-12));
  CHECK_FALSE(Distribution::lognormal(0.3).mean_radius());
  const Distribution coarse = Distribution::sieve(std::vector<SievePoint>{{1e-4, 0}, {2e-4, 0}, {4e-4, 1}});
  CHECK(2 * coarse.mean_radius().value() * coarse.smallest() == relative(2e-4, 1e-14));
  // A straight curve is the power law of exponent 4.
  const std::vector<SievePoint> straight{{1e-4, 0}, {1e-3, 1}};
  CHECK(Distribution::sieve(straight).moment(5) == relative(Distribution::power_law(4, 10).moment(5), 1e-13));
}

TEST_CASE("equal grains are the special case of every form, to the bit") {
  for (const Distribution& sizes :
       {Distribution::equal(), Distribution::bidisperse(1, 0.3), Distribution::uniform(2, 2),
        Distribution::lognormal(0), Distribution::power_law(2, 1), Distribution::uniformity(1)}) {
    CHECK(sizes == Distribution::equal());
    CHECK(sizes.is_equal());
    CHECK(sizes.moment(3) == 1);
    CHECK(sizes.quantile(0.1, 3) == 1);
    CHECK(gradation(sizes, 0.5e-3).d50 == 1e-3);
    CHECK(gradation(sizes, 0.5e-3).uniformity() == 1);
  }
  for (const double sigma : {1e-2, 1e-4, 1e-6})
    CHECK(Distribution::lognormal(sigma).moment(3) ==
          doctest::Approx(1 + 3 * sigma * sigma).epsilon(sigma * sigma));
}

TEST_CASE("grains of a sample have the gradation of their distribution") {
  const Distribution sizes = Distribution::lognormal(0.35);
  std::vector<double> radii;
  for (int k = 0; k < 4000; ++k)
    radii.push_back(0.2e-3 * sizes.quantile((k + 0.5) / 4000));
  const Gradation expected = gradation(sizes, 0.2e-3), counted = gradation(radii);
  CHECK(counted.d10 == relative(expected.d10, 2e-3));
  CHECK(counted.d50 == relative(expected.d50, 2e-3));
  CHECK(counted.d60 == relative(expected.d60, 2e-3));
  // By hand: masses 1, 8 and 27 of 36.
  const Gradation three = gradation(std::vector<double>{3, 1, 2});
  CHECK(three.d10 == 4);
  CHECK(three.d50 == 6);
}

TEST_CASE("impossible distributions are refused by name") {
  using D = Distribution;
  CHECK_THROWS_WITH_AS((void)D::bidisperse(0.5), doctest::Contains("ratio = 0.5"), InvalidArgument);
  CHECK_THROWS_WITH_AS((void)D::lognormal(-0.1), doctest::Contains("sigma = -0.1"), InvalidArgument);
  CHECK_THROWS_WITH_AS((void)D::uniformity(4, 10), doctest::Contains("ratio = 10"), InvalidArgument);
  const auto limit = [](double at, const auto& make) {
    check_threshold(at, [&](double x) { return refusals([&] { make(x); }); });
  };
  limit(1e3, [](double ratio) { (void)D::bidisperse(ratio); });
  limit(1e3, [](double ratio) { (void)D::uniform(2, 2 * ratio); });
  limit(1e3, [](double ratio) { (void)D::power_law(3, ratio); });
  for (const double sign : {1, -1})
    limit(10, [=](double exponent) { (void)D::power_law(sign * exponent, 2); });
  limit(1.2, [](double sigma) { (void)D::lognormal(sigma); });
  limit(1e6, [](double ratio) { (void)D::lognormal(0.3, ratio); });
  limit(1e-6, [](double above) { (void)D::lognormal(0.3, 1 + above); });
  limit(20, [](double C_u) { (void)D::uniformity(C_u); });
  limit(1e6, [](double ratio) { (void)D::uniformity(2, ratio); });
  limit(1e-6, [](double above) { (void)D::uniformity(2, 4 * (1 + above)); });
  limit(1e6, [](double ratio) {
    (void)D::sieve(std::vector<SievePoint>{{1e-6, 0}, {1e-5, 0.5}, {1e-6 * ratio, 1}});
  });
  for (const char* text : {"bidisperse:2:1", "uniform:3:1", "uniform:0:1", "lognormal:0.3:0.5",
                           "power-law:3:0.1", "uniformity:0.9"})
    CHECK_THROWS_AS((void)parse_distribution(text), InvalidArgument);
  CHECK_THROWS_AS((void)D::lognormal(std::nan("")), InvalidArgument);
  CHECK_THROWS_AS((void)D::equal().quantile(1.5), InvalidArgument);
  CHECK_THROWS_AS((void)gradation(D::equal(), 0), InvalidArgument);
  for (const std::vector<double>& radii : {std::vector<double>{}, {1, std::nan("")}})
    CHECK_THROWS_AS((void)gradation(radii), InvalidArgument);
  CHECK_THROWS_AS((void)mean_radius_of(D::equal(), -1), InvalidArgument);
}

TEST_CASE("a sieve curve that cannot be is refused at its point") {
  const auto refused = [](const std::vector<SievePoint>& curve, const char* point) {
    CHECK_THROWS_WITH_AS((void)Distribution::sieve(curve), doctest::Contains(point), InvalidArgument);
  };
  refused({{1e-3, 0}}, "1");
  refused({{1e-3, 0}, {1e-3, 1}}, "2");
  refused({{1e-3, 0}, {2e-3, 0.6}, {3e-3, 0.5}, {4e-3, 1}}, "3");
  refused({{1e-3, 0.6}, {2e-3, 0.5}, {4e-3, 1}}, "2");
  refused({{0, 0}, {1e-3, 1}}, "d = 0 m");
  refused({{1e-4, 0}, {1e-3, 60}}, "passing = 60");
  refused({{1e-4, 0}, {1e-3, 1.5}}, "passing = 1.5");
  refused({{1e-10, 0}, {1e-3, 1}}, "2");
  refused({{1e-4, 0.1}, {1e-3, 1}}, "1");
  refused({{1e-4, 0}, {1e-3, 0.9}}, "2");
}
