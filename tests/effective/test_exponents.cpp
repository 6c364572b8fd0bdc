// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/exponents.hpp>

#include <granum/contact/rough_sphere.hpp>
#include <granum/effective/rungs.hpp>

#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::Modulus;
using effective::StressExponents;

namespace {

const std::vector<Modulus> all_moduli{Modulus::K,   Modulus::G_hh, Modulus::G_vh, Modulus::E_v,
                                      Modulus::E_h, Modulus::C11,  Modulus::C33};

struct Estimator {
  effective::Estimate (*estimate)(const State&);
  StressExponents (*exponents)(const State&, Modulus);
};
const std::vector<Estimator> both{{effective::uniform_strain, effective::uniform_strain_exponents},
                                  {effective::uniform_stress, effective::uniform_stress_exponents}};

/// d ln X/d ln stress of moduli of an estimate, by differences.
template <class Estimate>
double difference_quotient(const Estimate& estimate, const State& s, Modulus which, double State::*stress) {
  return slope_of([&](double step) {
    State moved = s;
    moved.*stress *= std::exp(step);
    return std::log(effective::modulus(estimate(moved).stiffness, which));
  });
}

} // namespace

TEST_CASE("exponents: derivatives of the estimates") {
  for (const double alpha : {1.0, 2.0, 3.3, infinity})
    for (const double a : {-0.6, 0.0, 0.8})
      for (const double ratio : {0.2, 1.0, 4.0})
        for (const Estimator& h : both)
          for (const Modulus which : all_moduli) {
            CAPTURE(int(which));
            const State s = state_of(alpha, a, 0.15, ratio * 1e5, 1e5);
            const StressExponents e = h.exponents(s, which);
            CHECK(std::abs(e.stress_v - difference_quotient(h.estimate, s, which, &State::stress_v)) < 1e-9);
            CHECK(std::abs(e.stress_h - difference_quotient(h.estimate, s, which, &State::stress_h)) < 1e-9);
          }
}

TEST_CASE("exponents: the same at any stress that a double can have") {
  for (const double stress : {1e-300, 1e-160, 1e154, 1e200, 1e300})
    for (const Modulus which : {Modulus::K, Modulus::G_hh, Modulus::G_vh, Modulus::C33}) {
      CAPTURE(stress);
      const StressExponents usual =
          effective::uniform_strain_exponents(state_of(2, 0.2, 0.15, 1e5, 6e4), which);
      const StressExponents far =
          effective::uniform_strain_exponents(state_of(2, 0.2, 0.15, stress, 0.6 * stress), which);
      CHECK(far.stress_v == relative(usual.stress_v, 1e-12));
      CHECK(far.stress_h == relative(usual.stress_h, 1e-12));
    }
}

TEST_CASE("exponents: a shear modulus that is small, not zero, has exponents") {
  State nearly_smooth = state_of(2, 0.1, 0.15, 1.5e5, 1e5);
  const auto exponents_at = [&](double ratio) {
    nearly_smooth.tangential_ratio = ratio;
    return effective::uniform_stress_exponents(nearly_smooth, Modulus::G_vh);
  };
  const StressExponents limit = exponents_at(1e-8);
  for (const double ratio : {1e-12, 1e-14, 1e-100, 1e-300}) {
    CAPTURE(ratio);
    CHECK(std::abs(exponents_at(ratio).stress_v - limit.stress_v) < 1e-7);
    CHECK(std::abs(exponents_at(ratio).stress_h - limit.stress_h) < 1e-7);
  }
}

TEST_CASE("exponents: undefined ones are refused") {
  const State unloaded = state_of(2, 0, 0.15, 0, 0);
  State smooth = state_of(2, 0, 0.15, 1e5, 1e5);
  smooth.tangential_ratio = 0;
  for (const Estimator& h : both)
    CHECK_THROWS_AS((void)h.exponents(unloaded, Modulus::K), InvalidArgument);
  for (const Modulus which : {Modulus::G_hh, Modulus::G_vh, Modulus::E_v, Modulus::E_h})
    CHECK_THROWS_AS((void)effective::uniform_stress_exponents(smooth, which), InvalidArgument);
  CHECK(std::abs(effective::uniform_stress_exponents(smooth, Modulus::K).sum() - 1.0 / 3) < 1e-12);
}

TEST_CASE("exponents: of rough spheres they are local, and derivatives of every rung") {
  for (const double pressure : {1e3, 1e5, 1e7})
    for (const double a : {-0.2, 0.0, 0.15})
      for (const double ratio : {0.6, 1.0, 1.8}) {
        State s = state_of(2, a, 0.15, ratio * pressure, pressure);
        s.law = contact::RoughSphere(s.law.grain(), s.radius, 50e-9);
        s.mechanical_coordination_number = 6.2;
        for (const effective::Rung& rung : effective::closed_forms())
          for (const Modulus which : all_moduli) {
            CAPTURE(rung.key);
            CAPTURE(int(which));
            const StressExponents e = *effective::exponents(rung, s, which);
            const auto estimate = [&](const State& moved) { return effective::answer(rung, moved); };
            CHECK(std::abs(e.stress_v - difference_quotient(estimate, s, which, &State::stress_v)) < 1e-8);
            CHECK(std::abs(e.stress_h - difference_quotient(estimate, s, which, &State::stress_h)) < 1e-8);
            // Where all contacts are alike the sum is b, but for what rung 3 adds as its factor follows b.
            if (rung.key == std::string("0"))
              CHECK(e.sum() == relative(s.law.exponent_at_force(effective::mean_contact_force(s)), 1e-12));
          }
      }
}
