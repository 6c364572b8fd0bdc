// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 3 of packings whose contacts resist rolling.
#include <granum/effective/relaxation.hpp>

#include <granum/effective/exponents.hpp>
#include <granum/effective/uniform_field.hpp>

#include "effective/rolling_coefficients.hpp"
#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::relaxed;
using effective::RelaxedEstimate;

namespace {

State rolling(State s, double k_r) {
  s.rolling = k_r;
  return s;
}

} // namespace

TEST_CASE("rolling resistance: the coupling of the network without spins, as theory.md prints it") {
  // z* = 5 and r = 0.6 in spheres: x = 1.046, s = 1/(1 + (x/2.399)^2.5), and the numbers of the page.
  const double z = 5, r = 0.6, b = 1.0 / 3, k_r = 0.2;
  State s = state_of(2, 0, 0.15, 1e5, 1e5);
  s.tangential_ratio = r;
  const effective::Relaxation without = effective::relaxation(z, r, b);
  const double g = without.shear.value * (1 + 1.5 * r), g0 = -0.36899 / (1 + 0.20828),
               t = g * (g - g0) / r; // from g^2 - g_0 g = r t
  const double near = 1 / (1 + std::pow((z - 3.9538) / 2.3988, 2.5)),
               spinless = near * 5.412 * (1 - 0.2352 * b) + (1 - near) * 4.057,
               u = 0.8043 * std::pow(k_r / r, 0.6908), held = t + (spinless - t) * u / (1 + u);
  const double G = (g0 + std::sqrt(g0 * g0 + 4 * r * held)) / 2 / g;
  const RelaxedEstimate before = relaxed(s, z), after = relaxed(rolling(s, k_r), z);
  CHECK(after.stiffness.G_vh() / before.stiffness.G_vh() == relative(G, 1e-4));
  const double lost = 1 / without.bulk.value - 1, x = z - 3.9538,
               left = 1 / (1 + 1.436 * std::pow(k_r, 0.3868) * std::pow(1 + x / 2, -3.899));
  CHECK(after.stiffness.bulk_modulus() / before.stiffness.bulk_modulus() ==
        relative((1 + lost) / (1 + lost * left), 1e-4));
}

TEST_CASE(
    "rolling resistance: nothing at k_r = 0 to the bit, more with k_r, never more than uniform strain") {
  for (const double alpha : {0.5, 1.0, 2.0, infinity})
    for (const double r : {1e-310, 1e-3, 0.05, 0.1, 0.3, 0.6, 0.92, 1.0, 1.4, 20.0, 100.0})
      for (const double z : {4.0, 4.3, 5.0, 5.7, 6.0, 6.4, 7.5, 8.7, 12.0, 40.0, 1e6}) {
        State s = state_of(alpha, 0, 0.15, 1e5, 1e5);
        s.tangential_ratio = r;
        CAPTURE(alpha);
        CAPTURE(r);
        CAPTURE(z);
        const RelaxedEstimate without = relaxed(s, z), least = relaxed(rolling(s, 1e-300), z);
        if (r > 1e-9) { // else k_r/r is large
          CHECK(least.stiffness == without.stiffness);
          CHECK(least.relative_error.G_vh == without.relative_error.G_vh);
        }
        const elastic::TransverselyIsotropic strained = effective::uniform_strain(s).stiffness;
        double G = without.stiffness.G_vh(), K = without.stiffness.bulk_modulus();
        for (const double k_r : {1e-6, 1e-3, 0.01, 0.1, 0.5, 1.0}) {
          const RelaxedEstimate with = relaxed(rolling(s, k_r), z);
          CHECK(with.stiffness.G_vh() >= G * (1 - 1e-14));
          CHECK(with.stiffness.bulk_modulus() >= K * (1 - 1e-14));
          G = with.stiffness.G_vh();
          K = with.stiffness.bulk_modulus();
        }
        CHECK(G <= strained.G_vh() * (1 + 1e-12));
        CHECK(K <= strained.bulk_modulus() * (1 + 1e-12));
        if (z < 7 && r < 2 && r > 1e-9)
          CHECK(G > 1.005 * without.stiffness.G_vh());
      }
  // More contacts are stiffer at any k_r.
  for (const double alpha : {1.0, infinity})
    for (const double r : {1e-3, 0.1, 0.6, 1.0, 3.0})
      for (const double k_r : {0.003, 0.1, 1.0}) {
        State s = rolling(state_of(alpha, 0, 0.15, 1e5, 1e5), k_r);
        s.tangential_ratio = r;
        double G = 0, K = 0;
        for (double z = 3.96; z < 12; z += 0.02) {
          CAPTURE(z);
          CAPTURE(r);
          CAPTURE(k_r);
          const elastic::TransverselyIsotropic c = relaxed(s, z).stiffness;
          CHECK(c.G_vh() >= G);
          CHECK(c.bulk_modulus() >= K);
          G = c.G_vh();
          K = c.bulk_modulus();
        }
      }
  // Without tangential stiffness no spin matters, and below the isostatic point nothing is known.
  State s = state_of(2, 0, 0.15, 1e5, 1e5);
  CHECK(relaxed(rolling(s, 1), 3.9).stiffness.G_vh() == 0);
  CHECK_FALSE(relaxed(rolling(s, 1), 3.9).validity.ok());
  s.tangential_ratio = 0;
  CHECK(relaxed(rolling(s, 1), 6.5).stiffness == relaxed(s, 6.5).stiffness);
}

TEST_CASE("rolling resistance: what is gained has an error of its own") {
  const State s = state_of(2, 0, 0.15, 1e5, 1e5);
  const RelaxedEstimate loose = relaxed(rolling(s, 0.1), 4.6), dense = relaxed(rolling(s, 0.1), 6.2);
  CHECK(loose.stiffness.G_vh() / relaxed(s, 4.6).stiffness.G_vh() == doctest::Approx(1.37).epsilon(0.01));
  CHECK(dense.stiffness.G_vh() / relaxed(s, 6.2).stiffness.G_vh() == doctest::Approx(1.05).epsilon(0.01));
  for (const double z : {4.6, 6.2})
    for (const double k_r : {0.003, 0.1, 1.0}) {
      const RelaxedEstimate without = relaxed(s, z), with = relaxed(rolling(s, k_r), z);
      const auto part = [](double error, double before, double after) {
        return error * std::sqrt(1 - before / after);
      };
      const auto [of_G, of_K] = effective::kernel::rolling_errors;
      const double G = part(of_G, without.stiffness.G_vh(), with.stiffness.G_vh()),
                   K = part(of_K, without.stiffness.bulk_modulus(), with.stiffness.bulk_modulus());
      // Beside it is what remains of the error without: less, as the number of contacts matters less.
      CHECK(with.relative_error.G_vh > G);
      CHECK(with.relative_error.G_vh < std::hypot(without.relative_error.G_vh, G));
      CHECK(with.relative_error.bulk_modulus > K);
      CHECK(with.relative_error.bulk_modulus < std::hypot(without.relative_error.bulk_modulus, K));
      CHECK(G > (k_r > 0.05 ? 0.01 : 0.001));
    }
  // The number of contacts matters less where spins are held.
  CHECK(relaxed(rolling(s, 1), 4.6).stiffness.G_vh() / relaxed(rolling(s, 1), 5.6).stiffness.G_vh() >
        relaxed(s, 4.6).stiffness.G_vh() / relaxed(s, 5.6).stiffness.G_vh());
}

TEST_CASE(
    "rolling resistance: added contacts matter less, so that s is smaller, refused below 0 and above 1") {
  const effective::Growth growth{
      .coordination_number = 0.05, .mechanical_coordination_number = 0.2, .void_ratio = -0.003};
  const State s = state_of(2, 0, 0.15, 1e5, 1e5);
  CHECK(effective::relaxed_exponents(rolling(s, 0.3), 4.6, growth, effective::Modulus::G_vh).sum() <
        effective::relaxed_exponents(s, 4.6, growth, effective::Modulus::G_vh).sum());
  for (const double k_r : {-1e-9, 1.001, double(NAN), infinity})
    CHECK_THROWS_WITH_AS((void)relaxed(rolling(state_of(2, 0, 0.15, 1e5, 1e5), k_r), 5),
                         doctest::Contains("rolling"), InvalidArgument);
}
