// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/power_law.hpp>

#include <granum/core/numerics.hpp>

#include "unit.hpp"

using contact::GrainMaterial;
using contact::PowerLaw;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr GrainMaterial glass{.shear_modulus = 30e9, .poisson_ratio = 0.15};

bool close(double a, double b, double relative) { return std::abs(a - b) <= relative * std::abs(b); }

/// One law of every kind, with contacts of some micrometres at forces of about a newton.
std::vector<PowerLaw> laws() {
  return {PowerLaw::general(glass, 0.5, 0.01), PowerLaw::general(glass, 0.8, 0.1),
          PowerLaw::cone(glass, 0.4),          PowerLaw::general(glass, 1.25, 20),
          PowerLaw::general(glass, 1.5, 180),  PowerLaw::sphere(glass, 0.5e-3),
          PowerLaw::general(glass, 2.7, 1e6),  PowerLaw::general(glass, 8, 1e38),
          PowerLaw::general(glass, 40, 1e200), PowerLaw::flat(glass, 5.7e-6)};
}

/// Integral of g over [0, 1] for g analytic there.
template <class Function>
double unit_integral(Function g) {
  static const std::vector<QuadratureNode> rule = gauss_legendre(64);
  double sum = 0;
  for (const auto& [x, w] : rule)
    sum += w / 2 * g((1 + x) / 2);
  return sum;
}

} // namespace

TEST_CASE(
    "power law: Galin's and Sneddon's integrals over the profile give the same force and contact radius") {
  // Rigid profile A r^alpha on a half-space, delta(a) = a int_0^a z'(x)/sqrt(a^2-x^2) dx and
  // F(a) = 2 E* int_0^a (delta(a) - delta(x)) dx. Two grains: half the overlap each, E* = 2 G/(1-nu) for
  // each.
  struct Case {
    double alpha, constant;
  };
  for (const auto& [alpha, A] : {Case{0.5, 0.01}, Case{1, 0.4}, Case{1.3, 3}, Case{1.5, 180}, Case{2, 1000},
                                 Case{2.7, 1e6}, Case{5, 1e18}, Case{8, 1e38}}) {
    const double exponent = alpha;
    CAPTURE(exponent);
    const double a = 3e-6;
    // x = a sin t: z'(x)/sqrt(a^2-x^2) dx = alpha A x^(alpha-1) dt; t = u^8 pi/2 smooths the power at 0.
    const auto approach = [&, alpha = alpha, A = A](double radius) {
      return radius * unit_integral([&](double u) {
               const double t = std::numbers::pi / 2 * std::pow(u, 8);
               const double dt = std::numbers::pi / 2 * 8 * std::pow(u, 7);
               return alpha * A * std::pow(radius * std::sin(t), alpha - 1) * dt;
             });
    };
    const double plane_modulus = 2 * glass.shear_modulus / (1 - glass.poisson_ratio);
    const double half = approach(a);
    const double force = 2 * plane_modulus * a * unit_integral([&](double u) {
                           return (half - approach(a * std::pow(u, 4))) * 4 * std::pow(u, 3);
                         });
    const PowerLaw law = PowerLaw::general(glass, alpha, A);
    CHECK(close(law.force(2 * half), force, 1e-11));
    CHECK(close(law.contact_radius(2 * half), a, 1e-11));
  }
}

TEST_CASE("power law: the sphere is Hertz's textbook contact") {
  // F = 4/3 E* sqrt(R*) d^1.5 with 1/E* = 2 (1-nu^2)/E and R* = R/2.
  for (const double nu : {-0.9, 0.0, 0.15, 0.3, 0.5})
    for (const double R : {1e-5, 0.5e-3, 0.02}) {
      const double G = 30e9, E = 2 * G * (1 + nu), d = 1e-4 * R;
      const double E_star = E / (2 * (1 - nu * nu)), R_star = R / 2;
      const PowerLaw law = PowerLaw::sphere({G, nu}, R);
      CHECK(close(law.force(d), 4.0 / 3 * E_star * std::sqrt(R_star) * std::pow(d, 1.5), 2e-15));
      CHECK(close(law.stiffness_at_overlap(d), 2 * E_star * std::sqrt(R_star * d), 2e-15));
    }
}

TEST_CASE("power law: force and overlap, and both stiffnesses, are inverse to each other") {
  for (const PowerLaw& law : laws())
    for (const double d : {1e-12, 3e-8, 1e-4}) {
      CAPTURE(law.alpha());
      CHECK(close(law.overlap(law.force(d)), d, 1e-14)); // log(f/c) ~ 30 spends some 5 bits
      CHECK(close(law.stiffness_at_force(law.force(d)), law.stiffness_at_overlap(d), 1e-14));
      CHECK(close(law.stiffness_at_overlap(d), 2 * 30e9 / 0.85 * law.contact_radius(d), 1e-14));
      const double unloaded = std::isinf(law.alpha()) ? law.coefficient() : 0;
      CHECK(law.stiffness_at_overlap(0) == unloaded);
      CHECK(law.stiffness_at_force(0) == unloaded);
      CHECK(law.force(0) + law.overlap(0) + law.energy(0) == 0);
    }
}

TEST_CASE("power law: the general constructor meets cone and sphere") {
  for (const double slope : {0.01, 0.4, 3.0})
    CHECK(close(PowerLaw::general(glass, 1, slope).coefficient(), PowerLaw::cone(glass, slope).coefficient(),
                1e-15));
  for (const double R : {1e-5, 0.5e-3, 0.7})
    CHECK(close(PowerLaw::general(glass, 2, 1 / (2 * R)).coefficient(),
                PowerLaw::sphere(glass, R).coefficient(), 1e-15));
}

TEST_CASE("power law: the exponent may be huge") {
  const double limit = PowerLaw::flat(glass, 1).coefficient();
  // c/limit = alpha/(alpha+1) (Gamma ratio/(2 sqrt(pi) A))^(1/alpha); with A = 1 and Stirling's series in
  // long double.
  const auto reference = [](long double alpha) {
    const long double z = (alpha + 1) / 2;
    const long double y = 1 / z;
    const long double series = y / 8 + y * y / 128 - 5 * y * y * y / 1024 - 21 * y * y * y * y / 32768;
    const long double log_ratio = std::log1p(series) - std::log(z) / 2;
    const long double log_root =
        (log_ratio - std::log(2 * std::sqrt(std::numbers::pi_v<long double>))) / alpha;
    return static_cast<double>(alpha / (alpha + 1) * std::exp(log_root));
  };
  for (const double alpha : {339.0, 341.0, 343.0, 1e4, 1e6, 9.9e7, 1.1e8, 1e15, 1e300, 1.7e308}) {
    CAPTURE(alpha);
    const PowerLaw law = PowerLaw::general(glass, alpha, 1);
    CHECK(close(law.coefficient() / limit, reference(alpha), 2e-15));
    const double d = 1e-6;
    CHECK(std::isfinite(law.force(d)));
    CHECK(close(law.overlap(law.force(d)), d, 1e-14));
    CHECK(close(law.stiffness_at_force(law.force(d)), law.stiffness_at_overlap(d), 1e-14));
    // Distance to the punch: (ln d)/alpha of stiffness, (ln 2 sqrt(pi alpha/2))/alpha of the coefficient.
    if (alpha >= 1e6)
      CHECK(close(law.stiffness_at_overlap(d), limit, 30 / alpha + 3e-15));
  }
  // The family of constants with A^(-1/alpha) = a tends to the punch of radius a; alpha = 50 is 7.4 % short.
  CHECK(close(PowerLaw::general(glass, 50, std::pow(5.7e-6, -50.0)).coefficient(),
              PowerLaw::flat(glass, 5.7e-6).coefficient(), 0.1));
}

TEST_CASE("power law: bad input") {
  for (const GrainMaterial& bad :
       {GrainMaterial{30e9, 0.6}, GrainMaterial{30e9, -1}, GrainMaterial{0, 0.2}, {not_a_number, 0.2}})
    CHECK_THROWS_AS((void)PowerLaw::sphere(bad, 1e-3), InvalidArgument);
  for (const double bad : {0.0, -0.4, inf, not_a_number}) {
    CHECK_THROWS_AS((void)PowerLaw::sphere(glass, bad), InvalidArgument);
    CHECK_THROWS_AS((void)PowerLaw::cone(glass, bad), InvalidArgument);
    CHECK_THROWS_AS((void)PowerLaw::flat(glass, bad), InvalidArgument);
    CHECK_THROWS_AS((void)PowerLaw::general(glass, bad, 1), InvalidArgument);
    CHECK_THROWS_AS((void)PowerLaw::general(glass, 2, bad), InvalidArgument);
  }
  for (const PowerLaw& law : laws())
    for (const double bad : {-1e-9, not_a_number, inf})
      CHECK_THROWS_AS((void)law.contact_radius(bad), InvalidArgument);
}

TEST_CASE("tangential stiffness ratio") {
  CHECK(contact::mindlin_stiffness_ratio(0) == 1);
  CHECK(contact::mindlin_stiffness_ratio(0.15) == doctest::Approx(1.7 / 1.85).epsilon(1e-15));
  CHECK(contact::mindlin_stiffness_ratio(0.5) == doctest::Approx(2.0 / 3).epsilon(1e-15));
  CHECK(contact::mindlin_stiffness_ratio(-0.999999) == doctest::Approx(4.0 / 3).epsilon(1e-6));
  CHECK_THROWS_AS((void)contact::mindlin_stiffness_ratio(-1), InvalidArgument);
  CHECK_THROWS_AS((void)contact::mindlin_stiffness_ratio(0.51), InvalidArgument);
  CHECK(contact::given_stiffness_ratio(2.5) == 2.5);
  CHECK_THROWS_AS((void)contact::given_stiffness_ratio(-0.1), InvalidArgument);
  CHECK_THROWS_AS((void)contact::given_stiffness_ratio(inf), InvalidArgument);
}

TEST_CASE("power law: the profile constant comes back from the coefficient") {
  // Within 1e-15 alpha, alpha the power that the contact's radius is raised to.
  CHECK(close(PowerLaw::cone(glass, 0.4).profile_constant(), 0.4, 2e-15));
  CHECK(close(PowerLaw::sphere(glass, 0.5e-3).profile_constant(), 1 / (2 * 0.5e-3), 2e-15));
  for (const double alpha : {1.0, 1.5, 2.0, 8.0, 40.0}) {
    const double A = std::pow(10, 4.8 * alpha);
    CHECK(close(PowerLaw::general(glass, alpha, A).profile_constant(), A, 2e-15 * alpha));
  }
}

TEST_CASE("power law: the same profile of another solid") {
  const GrainMaterial steel{.shear_modulus = 80e9, .poisson_ratio = 0.3};
  for (const auto& [here, there] :
       {std::pair(PowerLaw::cone(glass, 0.4), PowerLaw::cone(steel, 0.4)),
        {PowerLaw::sphere(glass, 5e-4), PowerLaw::sphere(steel, 5e-4)},
        {PowerLaw::flat(glass, 5.7e-6), PowerLaw::flat(steel, 5.7e-6)},
        {PowerLaw::general(glass, 1.5, 180), PowerLaw::general(steel, 1.5, 180)}}) {
    const PowerLaw moved = here.of_grain(steel);
    CHECK(moved.alpha() == there.alpha());
    CHECK(moved.grain() == steel);
    CHECK(close(moved.stiffness_at_force(0.3), there.stiffness_at_force(0.3), 2e-15));
  }
  CHECK_THROWS_AS((void)PowerLaw::sphere(glass, 5e-4).of_grain({.shear_modulus = 0}), InvalidArgument);
}
