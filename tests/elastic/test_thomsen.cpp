// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/waves.hpp>

#include <random>

#include <granum/elastic/isotropic.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

constexpr double density = 1650; // of a dry sand [kg/m3]

double p_speed(const TransverselyIsotropic& c, double angle) {
  return plane_waves(c, density, {std::sin(angle), 0, std::cos(angle)}).quasi_p.speed;
}

/// A material with C11, C33 > C44, so that the faster wave in the plane is the P wave, and C13 + C44 > 0.
TransverselyIsotropic with_fast_p(std::mt19937_64& random) {
  TransverselyIsotropic c = random_layered(random, 0, 0.99);
  c.C44 = std::min({c.C44, 0.9 * c.C33, 0.9 * c.C11});
  return c;
}

} // namespace

TEST_CASE("Thomsen: the parameters agree with the wave speeds") {
  std::mt19937_64 random(1986);
  for (int i = 0; i < 100; ++i) {
    const TransverselyIsotropic c = with_fast_p(random);
    const ThomsenParameters t = thomsen_parameters(c);
    const double V0 = p_speed(c, 0), V90 = p_speed(c, std::numbers::pi / 2);
    CHECK(std::abs(t.epsilon - (V90 * V90 / (V0 * V0) - 1) / 2) < 1e-14);
    const double H0 = plane_waves(c, density, {0, 0, 1}).pure_s.speed;
    const double H90 = plane_waves(c, density, {1, 0, 0}).pure_s.speed;
    CHECK(std::abs(t.gamma - (H90 * H90 / (H0 * H0) - 1) / 2) < 1e-13 * (1 + t.gamma));
    // V_p = V_p0 (1 + delta angle^2 + ...): the next term by Richardson's rule
    const auto slope = [&](double angle) { return (p_speed(c, angle) / V0 - 1) / (angle * angle); };
    const double step = 2e-3 * (1 - c.C44 / c.C33); // the series runs in angle^2/(1 - C44/C33)
    const double delta = (4 * slope(step / 2) - slope(step)) / 3;
    CHECK(std::abs(t.delta - delta) < 1e-6 + 1e-15 * 10 / (step * step));
  }
}

TEST_CASE("Thomsen: closed parameters are right to 8 ulp, near isotropy too") {
  std::mt19937_64 random(2);
  double worst = 0;
  const auto compare = [&worst](const TransverselyIsotropic& c) {
    const long double C11 = c.C11, C33 = c.C33, C12 = c.C12, C13 = c.C13, C44 = c.C44;
    const ThomsenParameters t = thomsen_parameters(c), weak = weak_thomsen_parameters(c);
    const long double excess = C13 + 2 * C44 - C33; // sums of three doubles of one size: exact
    worst = std::max({worst, ulps(t.epsilon, (C11 - C33) / (2 * C33)),
                      ulps(t.delta, excess * (C13 + C33) / (2 * C33 * (C33 - C44))),
                      ulps(t.gamma, (C11 - C12 - 2 * C44) / (4 * C44)), ulps(weak.delta, excess / C33)});
    CHECK(weak.epsilon == t.epsilon);
    CHECK(weak.gamma == t.gamma);
  };
  for (int i = 0; i < 1000; ++i) {
    compare(with_fast_p(random));
    TransverselyIsotropic nearly{.C11 = 3e8, .C33 = 3e8, .C12 = 1e8, .C13 = 1e8, .C44 = 1e8};
    const double spread = std::pow(10, uniform(random, -14, -1));
    for (double* entry : {&nearly.C11, &nearly.C33, &nearly.C12, &nearly.C13, &nearly.C44})
      *entry *= 1 + spread * uniform(random, -1, 1);
    if (nearly.C11 != nearly.C33) // else epsilon is an exact zero, without a last place
      compare(nearly);
  }
  CAPTURE(worst);
  CHECK(worst < 8);
}

TEST_CASE("Thomsen: stiffness to parameters and back is the identity") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {
    const TransverselyIsotropic c = with_fast_p(random);
    const ThomsenSolid solid = thomsen_solid(c, density);
    CHECK(solid.bulk_density == density);
    CHECK(solid.anisotropy == thomsen_parameters(c));
    // a delta near its smallest, -(1 - C44/C33)/2, magnifies its rounding in the root for C13
    const Matrix6 back = voigt(transversely_isotropic(solid)).matrix;
    CHECK((back - voigt(c).matrix).cwiseAbs().maxCoeff() < 2e-14 * std::max(c.C11, c.C33));
    CHECK(back(3, 3) == relative(c.C44, 2e-14));
  }
}

TEST_CASE("Thomsen: stiffnesses without parameters, or of no solid, are refused") {
  TransverselyIsotropic c = layered_sample();
  CHECK_THROWS_AS((void)thomsen_solid(c, 0), InvalidArgument);
  c.C44 = 500e6; // above C33
  CHECK_THROWS_AS((void)thomsen_parameters(c), InvalidArgument);
  CHECK_NOTHROW((void)weak_thomsen_parameters(c));
  c.C44 = 0;
  CHECK_THROWS_AS((void)weak_thomsen_parameters(c), InvalidArgument);
  const ThomsenSolid good{.bulk_density = 1650, .vertical_p_speed = 400, .vertical_s_speed = 250};
  CHECK_NOTHROW((void)transversely_isotropic(good));
  const auto spoilt = [&good](auto change) {
    ThomsenSolid solid = good;
    change(solid);
    CHECK_THROWS_AS((void)transversely_isotropic(solid), InvalidArgument);
  };
  spoilt([](ThomsenSolid& s) { s.bulk_density = 0; });
  spoilt([](ThomsenSolid& s) { s.vertical_s_speed = 400; });
  spoilt([](ThomsenSolid& s) { s.vertical_p_speed = std::nan(""); });
  spoilt([](ThomsenSolid& s) { s.anisotropy.delta = -0.4; });
  spoilt([](ThomsenSolid& s) { s.anisotropy.delta = 3; }); // C13 too large for C33 (C11+C12)
  spoilt([](ThomsenSolid& s) { s.anisotropy.gamma = -0.6; });
  spoilt([](ThomsenSolid& s) { s.anisotropy.epsilon = std::nan(""); });
}
