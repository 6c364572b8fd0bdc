// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of the closed forms at every packing, tried at random ones.
#include <doctest/doctest.h>

#include "states.hpp"

#include <cstdlib>
#include <sstream>

#include <granum/effective/exponents.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/stiffness.hpp>

namespace {

using namespace granum;
using effective::State;
using elastic::TransverselyIsotropic;

/// The same packings in every run, unless RC_PARAMS says otherwise.
const bool seeded = setenv("RC_PARAMS", "seed=1 max_success=500", 0) == 0;

/// Runs a property on random packings and says which one broke it.
template <class Property>
bool holds(const char* name, Property property) {
  REQUIRE(seeded);
  return rc::check(name, [&] {
    const State state = test::any_state();
    std::ostringstream text;
    test::describe(text, state);
    RC_LOG() << text.str() << '\n';
    property(state);
  });
}

elastic::Matrix6 mandel_matrix(const TransverselyIsotropic& c) {
  return elastic::mandel(elastic::voigt(c)).matrix;
}

double distance(const TransverselyIsotropic& a, const TransverselyIsotropic& b) {
  return elastic::relative_distance(elastic::mandel(elastic::voigt(a)), elastic::mandel(elastic::voigt(b)));
}

} // namespace

TEST_CASE("property: the stiffness under uniform stress is never above that under uniform strain") {
  CHECK(holds("stress below strain", [](const State& state) {
    const elastic::Matrix6 upper = mandel_matrix(uniform_strain(state).stiffness);
    const elastic::Matrix6 lower = mandel_matrix(uniform_stress(state).stiffness);
    RC_ASSERT(elastic::eigen_system(upper - lower).values[0] >= -1e-13 * upper.norm());
  }));
}

TEST_CASE("property: every stiffness under uniform strain is positive semidefinite, and finite") {
  CHECK(holds("positive", [](const State& state) {
    const elastic::Matrix6 C = mandel_matrix(uniform_strain(state).stiffness);
    RC_ASSERT(C.allFinite());
    RC_ASSERT(elastic::positive_semidefinite(elastic::MandelStiffness{C}, 1e-13));
  }));
}

TEST_CASE("property: stress times a power of two scales the moduli by one") {
  CHECK(holds("scaling", [](State state) {
    // The exponent of the modulus, times 6, is whole for cones (1/2), spheres (1/3) and punches (0).
    const double b = state.law.constant_exponent().value();
    RC_PRE(b == 0 || state.law.power_law()->alpha() == 1 || state.law.power_law()->alpha() == 2);
    const TransverselyIsotropic before = uniform_strain(state).stiffness;
    state.stress_v *= 64;
    state.stress_h *= 64;
    const double factor = b == 0 ? 1 : state.law.power_law()->alpha() == 1 ? 8 : 4;
    // Only the cube root of the C library is not scaled exactly: by one unit in the last place, and two
    // products round after it.
    const TransverselyIsotropic after = uniform_strain(state).stiffness;
    const TransverselyIsotropic expected{.C11 = factor * before.C11,
                                         .C33 = factor * before.C33,
                                         .C12 = factor * before.C12,
                                         .C13 = factor * before.C13,
                                         .C44 = factor * before.C44};
    RC_ASSERT(distance(expected, after) <= 1e-15);
  }));
}

TEST_CASE("property: the exponents of stress add up to that of the contact law") {
  CHECK(holds("s = 1/(1+alpha)", [](const State& state) {
    for (const auto which : {effective::Modulus::K, effective::Modulus::G_hh, effective::Modulus::G_vh,
                             effective::Modulus::C11, effective::Modulus::C33}) {
      const double s = uniform_strain_exponents(state, which).sum();
      RC_ASSERT(std::abs(s - state.law.constant_exponent().value()) < 1e-12);
    }
  }));
}

TEST_CASE("property: more contacts or more stress never make a packing softer") {
  CHECK(holds("monotonic", [](const State& state) {
    const double factor = test::between(1.001, 3);
    const bool stiffens = std::isfinite(state.law.power_law()->alpha());
    const TransverselyIsotropic before = uniform_strain(state).stiffness;
    State more = state;
    *more.coordination_number *= factor;
    const TransverselyIsotropic denser = uniform_strain(more).stiffness;
    RC_ASSERT(denser.bulk_modulus() > before.bulk_modulus());
    RC_ASSERT(denser.G_vh() > before.G_vh());
    more = state;
    more.stress_v *= factor;
    more.stress_h *= factor;
    const TransverselyIsotropic loaded = uniform_strain(more).stiffness;
    RC_ASSERT(!stiffens || loaded.bulk_modulus() > before.bulk_modulus());
    RC_ASSERT(!stiffens || loaded.G_hh() > before.G_hh() || state.fabric_anisotropy > 0.99);
  }));
}

TEST_CASE("property: a half turn about any axis does not change a transversely isotropic stiffness") {
  CHECK(holds("half turns", [](const State& state) {
    const auto C = elastic::mandel(elastic::voigt(uniform_strain(state).stiffness));
    const double angle = test::between(0, 6.28);
    const Mat3 about_axis{
        {{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}}};
    const Mat3 upside_down{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    RC_ASSERT(elastic::relative_distance(C, elastic::rotate(C, about_axis)) < 1e-14);
    RC_ASSERT(elastic::relative_distance(C, elastic::rotate(C, upside_down)) < 1e-14);
  }));
}
