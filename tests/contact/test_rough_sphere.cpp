// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/rough_sphere.hpp>

#include <variant>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <granum/contact/grains.hpp>
#include <granum/contact/laws.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::contact;

namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

constexpr GrainMaterial quartz{.shear_modulus = 44e9, .poisson_ratio = 0.074};
constexpr double R = 0.1e-3, u0 = 20e-9;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

Exact hertz_stiffness(const Exact& f) {
  const Exact M = Exact(quartz.shear_modulus) / (1 - Exact(quartz.poisson_ratio));
  return cbrt(3 * M * M * Exact(R) * f);
}

/// k_n as the class writes it, in 50 digits.
Exact stiffness(const Exact& f) {
  const Exact k = hertz_stiffness(f), X = Exact(u0) * k / f;
  const Exact q = pow(Exact(0.834395) * X, Exact(1.090329));
  const Exact two_thirds_pi = 8 * atan(Exact(1)) / 3;
  const Exact h = 1 + X * (Exact(1.316734) + two_thirds_pi * q) / (1 + q);
  return 1 / (Exact(u0) / f + 1 / (k * sqrt(h)));
}

/// d ln k_n/d ln f in 50 digits, by differences: errors of 1e-24 and 1e-26.
Exact exponent(const Exact& f) {
  const Exact step("1e-12");
  return (log(stiffness(f * exp(step))) - log(stiffness(f * exp(-step)))) / (2 * step);
}

template <class Test>
void each_force(const RoughSphere& law, const Test& test) {
  for (int k = -100; k <= 160; ++k) { // of f_1: from the onset to X = 1e-10
    const double f = law.transition_force() * std::exp2(0.25 * k) * 1.01;
    CAPTURE(f);
    test(f);
  }
}

} // namespace

TEST_CASE("rough spheres: k_n is the formula to four units in the last place, b to 1e-9") {
  const RoughSphere law(quartz, R, u0);
  double worst = 0, worst_exponent = 0, worst_slope = 0;
  each_force(law, [&](double f) {
    const Exact k = stiffness(f);
    worst = std::max(worst, static_cast<double>(abs(law.stiffness_at_force(f) - k) / k));
    worst_exponent =
        std::max(worst_exponent, std::abs(law.exponent_at_force(f) - static_cast<double>(exponent(f))));
    const Exact step("1e-8");
    const Exact slope = (exponent(f * exp(step)) - exponent(f * exp(-step))) / (2 * step);
    worst_slope =
        std::max(worst_slope, std::abs(law.exponent_slope_at_force(f) - static_cast<double>(slope)));
  });
  CHECK(worst < 4 * epsilon);
  CHECK(worst_exponent < 1e-14);
  CHECK(worst_slope < 1e-14);
}

TEST_CASE("rough spheres: force, overlap and energy are integrals of 1/k_n and of the force") {
  const RoughSphere law(quartz, R, u0);
  const double first = RoughSphereKernel::onset * law.transition_force();
  CHECK(law.overlap(first) == relative(u0, 1e-14));
  CHECK(law.energy(u0) == relative(first * u0 / 2, 1e-14));
  // Simpson's rule for dd = (f/k_n) d ln f and dU = f dd in steps of 2^(1/64), from the onset on.
  double d = u0, energy = first * u0 / 2;
  const auto per_log = [&](double f) { return f / law.stiffness_at_force(f); };
  double f = first * (1 + 1e-12);
  const double step = std::log(2) / 64;
  for (int k = 0; k < 64 * 45; ++k) {
    const double middle = f * std::exp(step / 2), end = f * std::exp(step);
    d += step / 6 * (per_log(f) + 4 * per_log(middle) + per_log(end));
    energy += step / 6 * (f * per_log(f) + 4 * middle * per_log(middle) + end * per_log(end));
    f = end;
    if (k % 97 == 0) {
      CAPTURE(f / law.transition_force());
      CHECK(law.overlap(f) == relative(d, 1e-9));
      CHECK(law.energy(d) == relative(energy, 3e-9));
      CHECK(law.force(law.overlap(f)) == relative(f, 1e-13));
      CHECK(law.stiffness_at_overlap(law.overlap(f)) == relative(law.stiffness_at_force(f), 1e-13));
    }
  }
}

TEST_CASE("rough spheres: the kernel for sweeps is the law, from the onset to overlaps of 2^31 u0") {
  const RoughSphere law(quartz, R, u0);
  const auto kernel = std::get<RoughSphereKernel>(law.kernel());
  double worst = 0, worst_slope = 0, before = 0;
  for (int k = 1; k < 31 * 997; ++k) {
    const double d = u0 * std::exp2(k / 997.0);
    const NormalResponse response = kernel(d);
    worst = std::max(worst, std::abs(response.force / law.force(d) - 1));
    worst_slope = std::max(worst_slope, std::abs(response.stiffness / law.stiffness_at_overlap(d) - 1));
    CHECK(response.force > before);
    before = response.force;
  }
  CHECK(worst < 1e-9);
  CHECK(worst_slope < 1e-7);
  check_threshold(0x1p-30 * R, [](double roughness) { // below, sweeps take smooth spheres
    return std::holds_alternative<SphereKernel>(RoughSphere(quartz, R, roughness).kernel()) ? 1 : 0;
  });
  CHECK(kernel(0).force == 0);
  CHECK(kernel(u0 / 2).force == relative(law.force(u0 / 2), 1e-14));
}

TEST_CASE("rough spheres: without roughness they are Hertz', to the bit") {
  const RoughSphere law(quartz, R, 0);
  const PowerLaw hertz = PowerLaw::sphere(quartz, R);
  for (const double x : {0.0, 1e-9, 1e-7, 1e-3, 1.0}) {
    CHECK(law.force(x) == hertz.force(x));
    CHECK(law.overlap(x) == hertz.overlap(x));
    CHECK(law.stiffness_at_overlap(x) == hertz.stiffness_at_overlap(x));
    CHECK(law.stiffness_at_force(x) == hertz.stiffness_at_force(x));
    CHECK(law.exponent_at_force(x) == hertz.exponent_at_force(x));
    CHECK(law.exponent_slope_at_force(x) == 0);
    CHECK(law.energy(x) == hertz.energy(x));
  }
  CHECK(std::get<SphereKernel>(law.kernel()).coefficient == hertz.coefficient());
  CHECK(*law.constant_exponent() == *hertz.constant_exponent());
  CHECK(*NormalLaw(law).power_law() == hertz);
  CHECK(NormalLaw(RoughSphere(quartz, R, u0)).power_law() == nullptr);
}

TEST_CASE("rough spheres: b falls from 1 to 1/3, and X is 1 at the force of transition") {
  const RoughSphere law(quartz, R, u0);
  double last = 1;
  each_force(law, [&](double f) {
    const double b = law.exponent_at_force(f);
    CHECK(b < last);
    CHECK(b >= 1.0 / 3);
    last = b;
  });
  CHECK(law.exponent_at_force(law.transition_force() * 1e-7) == relative(1, 1e-4));
  CHECK(last == relative(1.0 / 3, 1e-8)); // X is 1e-8 there
  const double f1 = law.transition_force(), G = quartz.shear_modulus, nu = quartz.poisson_ratio;
  CHECK(f1 == relative(std::sqrt(3 * R) * std::pow(u0, 1.5) * G / (1 - nu), 8 * epsilon));
  CHECK(u0 * law.closing_law().stiffness_at_force(f1) / f1 == relative(1, 1e-14));
  // Little force: the interface alone is as soft as f/u0; much force: Hertz, with 1 - X/3 to first order.
  CHECK(law.stiffness_at_force(1e-6 * f1) == relative(1e-6 * f1 / u0, 1e-5));
  const double X = rough_stiffness(1e-3).ratio;
  CHECK(X == relative(1 - 1e-3 / 3, 2e-5));
}

TEST_CASE("rough spheres: numbers far out of the ordinary end in no NaN") {
  for (const double roughness : {1e-300, 1e-30, 1e-12, 1e-8, 10e-6})
    for (const double f : {0.0, 1e-300, 1e-30, 1e-3, 1e3, 1e30, 1e300}) {
      const RoughSphere law(quartz, R, roughness);
      CAPTURE(roughness);
      CAPTURE(f);
      const double d = law.overlap(f);
      CHECK(d >= 0);
      CHECK(law.stiffness_at_force(f) >= 0);
      CHECK(law.exponent_at_force(f) >= 0);
      CHECK(law.exponent_at_force(f) <= 1);
      if (d < 1e100)
        CHECK(law.energy(d) >= 0);
      const PowerLaw smooth = PowerLaw::sphere(quartz, R); // but for less than rounding
      if (f > 0 && roughness * smooth.stiffness_at_force(f) / f < 0x1p-61)
        CHECK((d == smooth.overlap(f) && law.energy(d) == smooth.energy(d)));
    }
  check_threshold(10e-6, [](double roughness) {
    try {
      return RoughSphere::of_numbers(quartz, {2, 1e9, roughness}).roughness() > 0 ? 0 : 9;
    } catch (const InvalidArgument&) {
      return 1;
    }
  });
  for (const double alpha : {1.0, 3.0})
    CHECK_THROWS_AS((void)RoughSphere::of_numbers(quartz, {alpha, 1e9, 1e-9}), InvalidArgument);
  for (const auto& [radius, roughness] : {std::pair(R, -1e-9), {-R, 1e-9}, {R, 10.1e-6}, {1e-6, 1.1e-6}})
    CHECK_THROWS_AS(RoughSphere(quartz, radius, roughness), InvalidArgument);
  CHECK(RoughSphere(quartz, 1e-6, 1e-6).roughness() == 1e-6);
}
