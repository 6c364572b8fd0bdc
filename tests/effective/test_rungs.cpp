// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/rungs.hpp>

#include <cmath>
#include <set>
#include <string>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <granum/effective/ladder.hpp>
#include <granum/effective/uniform_field.hpp>

#include "relative.hpp"
#include "support.hpp"

using namespace granum;
using namespace granum::test;
using effective::closed_forms;
using effective::Input;
using effective::Modulus;
using effective::Rung;
using effective::RungInputs;
using effective::RungName;
using effective::StressExponents;

namespace {

constexpr Modulus all_moduli[] = {Modulus::K,   Modulus::G_hh, Modulus::G_vh, Modulus::E_v, Modulus::E_h,
                                  Modulus::C11, Modulus::C33,  Modulus::C12,  Modulus::C13};

RungInputs packing(double alpha = 2) { return {state_of(alpha, 0.12, 0.15, 1.4e5, 1e5), 6.3}; }

double value_of(const Rung& rung, const RungInputs& at, Modulus which) {
  return effective::modulus(effective::answer(rung, at).stiffness, which);
}

/// dX/dx by differences of fourth order, x moved by `move(inputs, step)`.
template <class Move>
double slope(const Rung& rung, Modulus which, Move move, double h) {
  const auto f = [&](double step) {
    RungInputs at = packing();
    move(at, step);
    return value_of(rung, at, which);
  };
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

} // namespace

TEST_CASE("rungs: one row a name, and names that a table can tell apart") {
  std::set<RungName> names;
  std::set<std::string> keys, columns;
  for (const Rung& rung : effective::rungs()) {
    CHECK(&effective::rung(rung.name) == &rung);
    names.insert(rung.name);
    keys.insert(rung.key);
    columns.insert(rung.column);
    CHECK(rung.typical_time > 0);
    if (rung.number)
      CHECK(effective::label(rung) == "rung " + std::to_string(*rung.number));
  }
  CHECK(names.size() == 7);
  CHECK(keys.size() == 7);
  CHECK(columns.size() == 7);
  CHECK(closed_forms().size() == 5);
  for (const Rung& rung : closed_forms())
    CHECK_FALSE(rung.needs_packing);
}

TEST_CASE("rungs: each says what its formula says") {
  const RungInputs p = packing();
  const State& s = p.state;
  const auto answer = [&](RungName name) { return effective::answer(effective::rung(name), p).stiffness; };
  State no_fabric = s;
  no_fabric.fabric_anisotropy = 0;
  CHECK(answer(RungName::isotropic) ==
        effective::uniform_strain_stiffness(effective::uniform_contacts(no_fabric)));
  CHECK(answer(RungName::fabric) == effective::uniform_strain_stiffness(effective::uniform_contacts(s)));
  CHECK(answer(RungName::directional) == effective::uniform_strain(s).stiffness);
  CHECK(answer(RungName::relaxed) == effective::relaxed(s, 6.3).stiffness);
  CHECK(answer(RungName::uniform_stress) == effective::uniform_stress(s).stiffness);
  const auto isotropic = effective::uniform_strain_moduli({.law = s.law,
                                                           .tangential_ratio = s.tangential_ratio,
                                                           .radius = s.radius,
                                                           .void_ratio = s.void_ratio,
                                                           .coordination_number = s.coordination_number,
                                                           .pressure = (s.stress_v + 2 * s.stress_h) / 3});
  CHECK(answer(RungName::isotropic).bulk_modulus() == relative(isotropic.bulk_modulus, 1e-14));
  CHECK(answer(RungName::isotropic).G_vh() == relative(isotropic.shear_modulus, 1e-14));
}

TEST_CASE("rungs: exponents and gradients are slopes of what the rung says") {
  for (const Rung& rung : closed_forms())
    for (const Modulus which : all_moduli) {
      CAPTURE(rung.key);
      CAPTURE(int(which));
      const double X = value_of(rung, packing(), which);
      const auto g = effective::gradient(rung, packing(), which).gradient;
      CHECK(g.value == relative(X, 1e-12));
      const auto by_v = [](RungInputs& at, double step) { at.state.stress_v *= std::exp(step); };
      const auto by_h = [](RungInputs& at, double step) { at.state.stress_h *= std::exp(step); };
      const auto e = effective::exponents(rung, packing(), which);
      REQUIRE(e.has_value());
      CHECK(std::abs(e->stress_v - slope(rung, which, by_v, 2e-3) / X) < 1e-9);
      CHECK(std::abs(e->stress_h - slope(rung, which, by_h, 2e-3) / X) < 1e-9);
      CHECK(std::abs(g[Input::stress_v] * 1.4e5 / X - e->stress_v) < 1e-10);
      const auto by_a = [](RungInputs& at, double step) { at.state.fabric_anisotropy += step; };
      CHECK(std::abs(g[Input::fabric_anisotropy] - slope(rung, which, by_a, 1e-3)) < 1e-8 * std::abs(X));
      const auto by_z = [](RungInputs& at, double step) { *at.mechanical_coordination_number += step; };
      CHECK(std::abs(g[Input::mechanical_coordination_number] - slope(rung, which, by_z, 1e-3)) <
            1e-8 * std::abs(X));
    }
}

TEST_CASE("rungs: a modulus that vanishes has no exponents, and the others go on") {
  for (const double ratio : {0.0, 1.0})
    for (const double a : {-1.0, 0.0, 1.0})
      for (const double alpha : {1.0, 2.0, infinity})
        for (const double stress : {0.0, 1e5})
          for (const Rung& rung : closed_forms())
            for (const Modulus which : all_moduli) {
              RungInputs at = packing(alpha);
              at.state.tangential_ratio = ratio;
              at.state.fabric_anisotropy = a;
              at.state.stress_v = at.state.stress_h = stress;
              CAPTURE(ratio);
              CAPTURE(rung.key);
              CAPTURE(int(which));
              const bool by_strain = rung.name != RungName::uniform_stress;
              const bool shear = which == Modulus::G_hh || which == Modulus::G_vh || which == Modulus::E_v ||
                                 which == Modulus::E_h;
              const bool lateral = which == Modulus::C12 || which == Modulus::C13;
              const bool gone =
                  by_strain ? ratio == 1 && lateral && rung.name != RungName::relaxed : ratio == 0 && shear;
              // C12 of uniform stress at k_t = k_n crosses zero at a = 0, where the packing is isotropic
              if (!by_strain && ratio == 1 && lateral)
                continue;
              const auto e = effective::exponents(rung, at, which);
              CHECK(e.has_value() == !gone);
              if (e)
                CHECK(std::abs(e->sum() - at.state.law.constant_exponent().value()) < 1e-11);
            }
}

TEST_CASE("rungs: no contacts, no stiffness and no exponents; what is missing is said") {
  RungInputs none = packing();
  none.state.coordination_number = 0;
  for (const Rung& rung : closed_forms()) {
    const auto answer = effective::answer_with_exponents(rung, none);
    CHECK(answer.stiffness == elastic::TransverselyIsotropic{});
    CHECK_FALSE(answer.exponents.has_value());
  }
  const RungInputs without_z{packing().state};
  for (const Rung& rung : effective::rungs()) {
    const bool there = rung.name != RungName::relaxed && !rung.needs_packing;
    CHECK(effective::has_inputs(without_z, rung) == there);
    if (!there) {
      CHECK_THROWS_AS((void)effective::answer(rung, without_z), InvalidArgument);
      CHECK_THROWS_AS((void)effective::exponents(rung, without_z, Modulus::K), InvalidArgument);
      CHECK_THROWS_AS((void)effective::gradient(rung, without_z, Modulus::K), InvalidArgument);
    }
  }
  RungInputs huge = packing(infinity); // P k_n = 4e313 Pa
  huge.state.law = law_of(infinity, 0.15, 5e-4, 1e307);
  huge.state.radius = 5e-12;
  for (const Rung& rung : closed_forms())
    CHECK_THROWS_AS((void)effective::answer(rung, huge), InvalidArgument);
}

TEST_CASE("rungs: the ladder says of each rung what the table says") {
  const RungInputs p = packing();
  const auto ladder = effective::estimate(
      {.state = p.state, .mechanical_coordination_number = Measured{*p.mechanical_coordination_number, 0}},
      0.05);
  for (const Rung& rung : effective::rungs()) {
    if (!rung.number)
      continue;
    const auto& assessment = ladder.rungs[static_cast<std::size_t>(*rung.number)];
    CHECK(assessment.title == rung.title);
    CHECK(assessment.typical_time == rung.typical_time);
    CHECK(assessment.stiffness.has_value() == !rung.needs_packing);
    if (assessment.stiffness)
      CHECK(*assessment.stiffness == effective::answer(rung, p).stiffness);
  }
}
