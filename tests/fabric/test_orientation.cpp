// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/orientation.hpp>

#include <granum/core/numerics.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

namespace {

/// Mean over the sphere of g(n1, n2, n3) weighted by E(gamma; a); exact for the polynomials below (16 points
/// along the axis, 16 around it).
template <class Function>
double mean(double anisotropy, Function g) {
  const std::vector<QuadratureNode> rule = gauss_legendre(16);
  constexpr int around = 16;
  double sum = 0;
  for (const auto& [x, w] : rule)
    for (int i = 0; i < around; ++i) {
      const double phi = 2 * std::numbers::pi * (i + 0.5) / around;
      const double s = std::sqrt(1 - x * x);
      sum += w * 2 * std::numbers::pi / around * fabric::density(std::acos(x), anisotropy) *
             g(s * std::cos(phi), s * std::sin(phi), x);
    }
  return sum;
}

doctest::Approx approx(double value) { return doctest::Approx(value).epsilon(1e-14).scale(1); }

} // namespace

TEST_CASE("orientation: closed moments are the means over the density") {
  const fabric::SecondMoments even, of_none = fabric::second_moments(0);
  const fabric::FourthMoments even_4, of_none_4 = fabric::fourth_moments(0);
  for (const auto& [stated, found] : {std::pair(even.F11, of_none.F11),
                                      {even.F33, of_none.F33},
                                      {even_4.n1111, of_none_4.n1111},
                                      {even_4.n3333, of_none_4.n3333},
                                      {even_4.n1122, of_none_4.n1122},
                                      {even_4.n1133, of_none_4.n1133},
                                      {fabric::FabricMeasures{}.F11, even.F11},
                                      {fabric::FabricMeasures{}.F33, even.F33},
                                      {fabric::FabricMeasures{}.mean_cos_2gamma, 2 * even.F33 - 1}})
    CHECK(stated == approx(found));
  for (double a = -1; a <= 1; a += 0.125) {
    CAPTURE(a);
    const auto F = fabric::second_moments(a);
    const auto F4 = fabric::fourth_moments(a);
    CHECK(mean(a, [](double, double, double) { return 1.0; }) == approx(1));
    CHECK(mean(a, [](double x, double, double) { return x * x; }) == approx(F.F11));
    CHECK(mean(a, [](double, double, double z) { return z * z; }) == approx(F.F33));
    CHECK(mean(a, [](double x, double, double) { return x * x * x * x; }) == approx(F4.n1111));
    CHECK(mean(a, [](double, double, double z) { return z * z * z * z; }) == approx(F4.n3333));
    CHECK(mean(a, [](double x, double y, double) { return x * x * y * y; }) == approx(F4.n1122));
    CHECK(mean(a, [](double x, double, double z) { return x * x * z * z; }) == approx(F4.n1133));
    CHECK(2 * F.F11 + F.F33 == approx(1));
    CHECK(F4.n1111 + F4.n1122 + F4.n1133 == approx(F.F11));
    CHECK(2 * F4.n1133 + F4.n3333 == approx(F.F33));
  }
}

TEST_CASE("orientation: F33 and a convert into each other over the whole range of F33") {
  // da/dF33 = 40/(5 F33 + 1)^2 is 40 at F33 = 0: rounding of F33 is magnified at most that much.
  for (double a = -5; a <= 5.0 / 3; a += 0.05)
    CHECK(std::abs(fabric::anisotropy_from_F33(fabric::second_moments(a).F33) - a) < 2e-15 * (1 + a * a));
  CHECK(std::abs(fabric::anisotropy_from_F33(1.0 / 3)) < 1e-15);
  CHECK(fabric::anisotropy_from_F33(0) == -5);
}

TEST_CASE("orientation: bad input") {
  const double undefined = std::nan("");
  CHECK_THROWS_AS((void)fabric::density(undefined, 0), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::density(0, 1.01), InvalidArgument);
  const auto limit = [](double end, const auto& moments) {
    check_threshold(end, [&](double a) { return refusals([&] { (void)moments(a); }); });
  };
  for (const double end : {-5.0, 5.0 / 3})
    limit(end, fabric::second_moments);
  for (const double end : {-7.0 / 3, 7.0 / 5})
    limit(end, fabric::fourth_moments);
  for (const double bad : {3.0, undefined})
    CHECK_THROWS_AS((void)fabric::second_moments(bad), InvalidArgument);
  for (const double bad : {1.5, -2.5})
    CHECK_THROWS_AS((void)fabric::fourth_moments(bad), InvalidArgument);
  for (const double bad : {-0.1, 1.1})
    CHECK_THROWS_AS((void)fabric::anisotropy_from_F33(bad), InvalidArgument);
}
