// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sizes/contact_means.hpp>

#include <numeric>

#include <granum/sizes/distribution.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::sizes;

namespace {

std::vector<Distribution> unequal() {
  return {Distribution::bidisperse(1.4),    Distribution::uniform(1, 3),   Distribution::lognormal(0.35),
          Distribution::power_law(3.5, 10), Distribution::uniformity(2.5), Distribution::uniformity(4)};
}

double mean_of(const std::vector<double>& radii) {
  return std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
}

void check_same(const ContactMeans& a, const ContactMeans& b, double tolerance) {
  CHECK(a.branch == relative(b.branch, tolerance));
  CHECK(a.branch_square == relative(b.branch_square, tolerance));
  CHECK(a.pair_radius == relative(b.pair_radius, tolerance));
  CHECK(a.grain_volume == relative(b.grain_volume, tolerance));
}

} // namespace

TEST_CASE("equal grains are exactly 1, by every way") {
  const ContactMeans one;
  CHECK(expected_contact_means(Distribution::equal()) == one);
  CHECK(expected_contact_means(Distribution::lognormal(0)) == one);
  CHECK(expected_contact_means(std::vector<double>(7, 0.3e-3)) == one);
  const std::vector<double> radii(5, 0.3e-3);
  const std::vector<TouchingPair> contacts(11, {0.3e-3, 0.3e-3});
  CHECK(counted_contact_means(radii, contacts, 0.3e-3) == one);
}

TEST_CASE("quadrature and a sample of radii agree") {
  for (const Distribution& sizes : unequal()) {
    CAPTURE(sizes.text());
    const std::vector<double> radii = sample_radii(sizes, 20000, 4);
    const double mean = mean_of(radii);
    // Where one grain in 20,000 holds a per cent of the mass, its own size is seen.
    const double tolerance = sizes.size_ratio() > 15 ? 5e-2 : 1e-3;
    check_same(with_reference(expected_contact_means(radii), 1 / mean), expected_contact_means(sizes),
               tolerance);
  }
}

TEST_CASE("contacts drawn according to the theory have the expected means") {
  // 400 radii by classes; every pair counted in proportion to the product of both coordination numbers.
  const Distribution sizes = Distribution::lognormal(0.35);
  const std::vector<double> radii = sample_radii(sizes, 400, 2);
  const double mean = mean_of(radii);
  std::vector<TouchingPair> contacts;
  for (const double a : radii)
    for (const double b : radii) {
      const double often = 4 * relative_contact_number(a / mean) * relative_contact_number(b / mean);
      for (int k = 0; k < static_cast<int>(std::lround(often)); ++k)
        contacts.push_back({a, b});
    }
  check_same(counted_contact_means(radii, contacts, mean), expected_contact_means(radii), 5e-3);
}

TEST_CASE("a grain has as many contacts as mean neighbours find room for") {
  CHECK(relative_contact_number(1) == relative(1, 1e-15));
  const auto share_of_sky = [](double x) { return 1 - std::sqrt(1 - 1 / ((1 + x) * (1 + x))); };
  for (const double x : {0.01, 0.3, 2.0, 5.0})
    CHECK(relative_contact_number(x) == relative(share_of_sky(1) / share_of_sky(x), 1e-13));
  CHECK(relative_contact_number(1e6) == relative(1e12 / (2 * (1 + std::sqrt(0.75))), 1e-5)); // as its surface
  // <r^3 C>/(<C> <r^3>) to second order in x - 1 for a uniform distribution: 1.225 (Shaebani et al.).
  const Distribution sizes = Distribution::uniform(1, 3);
  double contacts = 0, cubes = 0;
  for (const auto& [x, share] : sizes.nodes()) {
    contacts += share * relative_contact_number(x);
    cubes += share * relative_contact_number(x) * x * x * x;
  }
  CHECK(cubes / contacts / sizes.moment(3) == relative(1.225, 2e-3));
}

TEST_CASE("rattlers are the small grains: the share of them is met, and the others are touched more often") {
  // Two sizes: c(x) of a point 1, of the small and of the large grain; k by the share of rattlers.
  const Distribution two = Distribution::bidisperse(2);
  const double small = two.smallest(), large = two.largest(), x0 = 0.25;
  const auto number = [](double x) { return relative_contact_number(x); };
  double below = 0, above = 100;
  for (int step = 0; step < 200; ++step) {
    const double k = (below + above) / 2;
    const auto rattles = [&](double x) { return std::exp(-k * (number(x) - number(0))); };
    ((rattles(small) + rattles(large)) / 2 > x0 ? below : above) = k;
  }
  const auto often = [&](double x) { return number(x) * (1 - std::exp(-below * (number(x) - number(0)))); };
  const double of_large = often(large) / (often(small) + often(large));
  const ContactMeans means = expected_contact_means(two, x0);
  CHECK(means.branch == relative(small + of_large * (large - small), 1e-12));
  const double square = small * small + of_large * (large * large - small * small);
  CHECK(means.branch_square == relative((square + means.branch * means.branch) / 2, 1e-12));
  CHECK(means.grain_volume == expected_contact_means(two).grain_volume); // of all grains
  for (const Distribution& sizes : unequal()) {
    CAPTURE(sizes.text());
    double before = expected_contact_means(sizes).branch;
    check_same(expected_contact_means(sizes, 1e-12), expected_contact_means(sizes), 0.02);
    for (const double share : {0.05, 0.2, 0.4}) {
      const ContactMeans now = expected_contact_means(sizes, share);
      CHECK(now.branch > before);
      before = now.branch;
      const std::vector<double> radii = sample_radii(sizes, 4000, 4);
      if (sizes.size_ratio() < 15)
        CHECK(now.branch == doctest::Approx(expected_contact_means(radii, share).branch).epsilon(2e-3));
    }
  }
  CHECK(expected_contact_means(Distribution::equal(), 0.3) == ContactMeans{});
  CHECK_THROWS_AS((void)expected_contact_means(two, 1), InvalidArgument);
  CHECK_THROWS_AS((void)expected_contact_means(two, -0.1), InvalidArgument);
}

TEST_CASE("by hand: two grains of radius 1 and 2, one contact of each kind") {
  const std::vector<double> radii{1, 2};
  const std::vector<TouchingPair> contacts{{1, 1}, {1, 2}, {2, 2}};
  const ContactMeans means = counted_contact_means(radii, contacts, 1);
  CHECK(means.branch == relative(1.5, 1e-15));
  CHECK(means.branch_square == relative((1 + 2.25 + 4) / 3, 1e-15));
  // k_n l^2 of the three contacts over l^2: R* of 1/2, 2/3 and 1, l of 2, 3 and 4.
  const double root = (4 * std::cbrt(1.0) + 9 * std::cbrt(4.0 / 3) + 16 * std::cbrt(2.0)) / (4 + 9 + 16);
  CHECK(means.pair_radius == relative(root * root * root, 1e-15));
  CHECK(means.grain_volume == relative(4.5, 1e-15));
  check_same(with_reference(means, 2), counted_contact_means(radii, contacts, 2), 1e-15);
  require_valid(means);
}

TEST_CASE("means that no packing can have are refused") {
  for (const ContactMeans& bad :
       {ContactMeans{.branch = 0}, ContactMeans{.branch = 1.2, .branch_square = 1.3},
        ContactMeans{.pair_radius = std::nan("")}, ContactMeans{.grain_volume = -1}})
    CHECK_THROWS_AS(require_valid(bad), InvalidArgument);
  check_threshold(1e-9, [](double below) { // rounding of the mean square
    return refusals([&] { require_valid(ContactMeans{.branch = 1.2, .branch_square = 1.44 * (1 - below)}); });
  });
  const Distribution two = Distribution::bidisperse(2);
  CHECK(expected_contact_means(two, 1 - 2e-9).branch > expected_contact_means(two, 1 - 1e-3).branch);
  CHECK_THROWS_AS((void)expected_contact_means(two, 1 - 5e-10), InvalidArgument);
  const std::vector<double> none, one{1}, with_zero{1, 0};
  const std::vector<TouchingPair> contact{{1, 1}}, negative{{1, -1}};
  CHECK_THROWS_AS((void)counted_contact_means(none, contact, 1), InvalidArgument);
  CHECK_THROWS_AS((void)counted_contact_means(one, {}, 1), InvalidArgument);
  CHECK_THROWS_AS((void)counted_contact_means(one, negative, 1), InvalidArgument);
  for (const std::vector<double>& bad : {none, with_zero})
    CHECK_THROWS_AS((void)expected_contact_means(bad), InvalidArgument);
}
