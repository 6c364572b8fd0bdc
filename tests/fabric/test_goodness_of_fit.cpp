// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/estimates.hpp>

#include <granum/fabric/orientation.hpp>

#include "unit.hpp"

namespace {

constexpr int repeats = 400;
constexpr std::size_t contacts = 1000;

/// p-values of repeated samples without anything to find are uniform on [0, 1]: their mean, and the share
/// below 1/10, within four standard errors.
template <class PValue>
void check_uniform(double anisotropy, std::uint64_t seed, PValue p_value) {
  double mean = 0, low = 0;
  for (int i = 0; i < repeats; ++i) {
    const double p = p_value(fabric::sample_normals(anisotropy, contacts, seed++));
    CHECK(p >= 0);
    CHECK(p <= 1);
    mean += p / repeats;
    low += (p < 0.1 ? 1.0 : 0.0) / repeats;
  }
  CHECK(std::abs(mean - 0.5) < 4 * std::sqrt(1.0 / 12 / repeats));
  CHECK(std::abs(low - 0.1) < 4 * std::sqrt(0.1 * 0.9 / repeats));
}

/// The sample with its first axis stretched, then leaned over towards axis 1, at length 1 again.
std::vector<Vec3> deformed(std::vector<Vec3> normals, double stretch, double lean) {
  for (Vec3& n : normals) {
    n.x *= stretch;
    n = {std::cos(lean) * n.x + std::sin(lean) * n.z, n.y, -std::sin(lean) * n.x + std::cos(lean) * n.z};
    n *= 1 / norm(n);
  }
  return normals;
}

} // namespace

TEST_CASE("goodness of fit: p-values are uniform where there is nothing to find") {
  check_uniform(0, 10000, [](const auto& n) { return fabric::test_isotropy(n).p_value; });
  check_uniform(0, 20000, [](const auto& n) { return fabric::test_isotropy(n).likelihood_ratio.p_value; });
  check_uniform(0.5, 30000, [](const auto& n) { return fabric::test_density(n, 0.5).chi_square.p_value; });
  check_uniform(-0.4, 40000, [](const auto& n) { return fabric::test_density(n).chi_square.p_value; });
  for (const double a : {-1.0, 0.5}) {
    check_uniform(a, 50000, [](const auto& n) { return fabric::test_axisymmetry(n).horizontal.p_value; });
    check_uniform(a, 60000, [](const auto& n) { return fabric::test_axisymmetry(n).tilt.p_value; });
    check_uniform(a, 70000, [](const auto& n) { return fabric::test_axisymmetry(n).both.p_value; });
  }
}

TEST_CASE("goodness of fit: existing anisotropy is detected") {
  const auto normals = fabric::sample_normals(0.1, 30000, 3); // ten standard errors
  const fabric::IsotropyTest test = fabric::test_isotropy(normals);
  CHECK(test.z_score > 6);
  CHECK(test.p_value < 1e-8);
  CHECK(test.likelihood_ratio.degrees_of_freedom == 1);
  CHECK(test.likelihood_ratio.p_value < 1e-8);
  // both are a over its standard error, squared once, to first order in a
  CHECK(test.likelihood_ratio.statistic == relative(test.z_score * test.z_score, 0.1));
  CHECK(test.likelihood_ratio.statistic ==
        relative(2 * fabric::estimate_anisotropy_by_likelihood(normals).log_likelihood_gain, 1e-15));
  const auto by_moments = fabric::estimate_anisotropy(normals);
  CHECK(test.z_score == relative((by_moments.F33 - 1.0 / 3) / std::sqrt(4.0 / 45 / 30000), 1e-11));

  const auto opposite = fabric::test_isotropy(fabric::sample_normals(-0.1, 30000, 3));
  CHECK(opposite.z_score < -6);
  CHECK(opposite.p_value < 1e-8);
}

TEST_CASE("goodness of fit: directions of another density, or another a, are found") {
  const auto normals = fabric::sample_normals(0.6, 10000, 4);
  CHECK(fabric::test_density(normals, 0).chi_square.p_value < 1e-8);
  CHECK(fabric::test_density(normals, 0.6).chi_square.p_value > 1e-3);
  // a mixture of much steeper and much flatter contacts has an a, but no E(gamma; a)
  std::vector<Vec3> mixture = fabric::sample_normals(0, 5000, 5);
  for (std::size_t i = 0; i < 2500; ++i)
    mixture[i] = mixture[i].z > 0 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const fabric::DensityTest fitted = fabric::test_density(mixture);
  CHECK(fitted.chi_square.p_value < 1e-8);
  CHECK(fitted.anisotropy == fabric::estimate_anisotropy_by_likelihood(mixture).anisotropy);
  CHECK(fitted.chi_square.degrees_of_freedom == static_cast<int>(fitted.bins) - 2);
}

TEST_CASE("goodness of fit: bins by the count of contacts") {
  const auto bins = [](std::size_t count) {
    return fabric::test_density(fabric::sample_normals(0, count, 6), 0).bins;
  };
  CHECK(bins(20) == 4);      // five contacts in each
  CHECK(bins(32) == 6);      // 32/5; 2 32^0.4 = 8
  CHECK(bins(1024) == 32);   // 2 1024^0.4 = 32 exactly
  CHECK(bins(30000) == 123); // 2 30000^0.4 = 123.6
  const auto test = fabric::test_density(fabric::sample_normals(0, 1024, 6), 0);
  CHECK(test.chi_square.degrees_of_freedom == 31);

  // five contacts in each of four bins but the first, which took one of the second: (1 + 1)/5
  std::vector<Vec3> counted;
  for (const double z : {0.1, 0.3, 0.6, 0.9})
    counted.insert(counted.end(), 5, Vec3{std::sqrt(1 - z * z), 0, z});
  CHECK(fabric::test_density(counted, 0).chi_square.statistic == 0);
  CHECK(fabric::test_density(counted, 0).chi_square.p_value == 1);
  counted[5] = counted[0];
  const auto moved = fabric::test_density(counted, 0).chi_square;
  CHECK(moved.statistic == relative(0.4, 1e-15));
  // three degrees of freedom: Q = erfc(sqrt(x/2)) + sqrt(2x/pi) exp(-x/2)
  CHECK(moved.p_value ==
        relative(std::erfc(std::sqrt(0.2)) + std::sqrt(0.8 / 3.14159265358979) * std::exp(-0.2), 1e-12));
}

TEST_CASE("goodness of fit: a fabric without axisymmetry is found where it is") {
  const auto normals = fabric::sample_normals(0.5, 20000, 8);
  const auto stretched = fabric::test_axisymmetry(deformed(normals, 1.1, 0));
  CHECK(stretched.horizontal.p_value < 1e-8);
  CHECK(stretched.tilt.p_value > 1e-3);
  const auto leaning = fabric::test_axisymmetry(deformed(normals, 1, 0.15));
  CHECK(leaning.tilt.p_value < 1e-8);
  CHECK(leaning.horizontal.p_value > 1e-3);
  CHECK(leaning.both.p_value < 1e-8);
  CHECK(leaning.both.statistic == leaning.tilt.statistic + leaning.horizontal.statistic);
  CHECK(leaning.both.degrees_of_freedom == 4);
  // two degrees of freedom: p = exp(-x/2)
  CHECK(stretched.tilt.p_value == relative(std::exp(-stretched.tilt.statistic / 2), 1e-12));
  // the statistic does not change when the sample is turned about axis 3
  std::vector<Vec3> turned = deformed(normals, 1.1, 0.15);
  const auto before = fabric::test_axisymmetry(turned);
  for (Vec3& n : turned)
    n = {0.6 * n.x - 0.8 * n.y, 0.8 * n.x + 0.6 * n.y, n.z};
  const auto after = fabric::test_axisymmetry(turned);
  CHECK(after.horizontal.statistic == relative(before.horizontal.statistic, 1e-10));
  CHECK(after.tilt.statistic == relative(before.tilt.statistic, 1e-10));
}

TEST_CASE("goodness of fit: components that cannot vary are not counted") {
  const auto vertical = fabric::test_axisymmetry(std::vector<Vec3>(20, Vec3{0, 0, 1}));
  CHECK(vertical.both.degrees_of_freedom == 0);
  CHECK(vertical.both.p_value == 1);
  const auto flat = fabric::test_axisymmetry(std::vector<Vec3>(20, Vec3{1, 0, 0}));
  CHECK(flat.tilt.degrees_of_freedom == 0);
  CHECK(flat.both.degrees_of_freedom == 2);
  CHECK(flat.horizontal.statistic == relative(20 * 2, 1e-15)); // all along one line: N (1/2)^2/(1/8)
}

TEST_CASE("goodness of fit: bad input") {
  const std::vector<Vec3> few(19, Vec3{0, 0, 1}), one(1, Vec3{0, 0, 1}), longer(20, Vec3{0, 0, 1.1});
  CHECK_THROWS_AS((void)fabric::test_density(few), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::test_density(few, 0), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::test_axisymmetry(few), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::test_isotropy(one), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::test_axisymmetry(longer), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::test_density(fabric::sample_normals(0, 20, 1), 1.1), InvalidArgument);
}
