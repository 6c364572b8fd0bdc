// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/state.hpp>

#include <granum/contact/rough_sphere.hpp>

#include "support.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::test;

namespace {

const State sample = state_of(2, 0.2, 0.15, 150e3, 90e3);

/// The name that a changed state is refused by; none if it is not.
template <class Change>
std::string refusal(Change change) {
  State state = sample;
  change(state);
  try {
    (void)effective::require_valid(state);
  } catch (const InvalidArgument& error) {
    const std::string text = error.what();
    return text.substr(0, text.find_first_of(" :"));
  }
  return "";
}

} // namespace

TEST_CASE("state: the static field balances the stress and has the closed mean force") {
  for (const double a : {-1.0, -0.3, 0.0, 0.5, 1.0})
    for (const double ratio : {0.1, 0.6, 1.0, 3.0, 10.0}) {
      CAPTURE(a);
      CAPTURE(ratio);
      const State s = state_of(2, a, 0.15, ratio * 1e5, 1e5);
      const effective::StaticForceField field = effective::static_force_field(s);
      double mean = 0, deviator = 0;
      for (const auto& [n, share, k_n, k_t] : directions_of(s, 32)) {
        const double x = n.z(), sine = std::sqrt(1 - x * x);
        const double f_n = field.normal_force(x);
        const double f_t = (x < 0 ? -1 : 1) * field.tangential_force(std::abs(x)); // odd about the equator
        mean += share * f_n;
        deviator += share * (f_n * (1.5 * x * x - 0.5) - 0.75 * f_t * 2 * sine * x);
      }
      const double per_volume = contact_density(s) / (2 * s.radius); // N_c l/V
      CHECK(close(effective::mean_contact_force(s), mean, 1e-13));
      CHECK(close(per_volume / 3 * mean, (ratio + 2) / 3 * 1e5, 1e-13));
      CHECK(std::abs(per_volume * deviator - (ratio - 1) * 1e5) < 1e-13 * 1e6);
      CHECK(close(effective::prefactor(s), contact_density(s), 1e-15));
    }
}

TEST_CASE("state: mobilised friction is the largest ratio over directions") {
  for (const double ratio : {0.1, 0.5, 1.0, 2.6125, 10.0}) {
    const auto field = effective::static_force_field(state_of(2, -0.4, 0.15, ratio * 1e5, 1e5));
    double largest = 0;
    for (double x = 0.0005; x < 1; x += 0.0005)
      largest = std::max(largest, std::abs(field.tangential_force(x)) / field.normal_force(x));
    CHECK(field.mobilised_friction() >= largest * (1 - 1e-14));
    CHECK(field.mobilised_friction() <= largest * (1 + 1e-4)); // curvature at the maximum, step 5e-4
  }
  // Isotropic fabric slips at stress ratio (sqrt(1+mu^2)+mu)^2.
  const double mu = 0.4986, slip = std::pow(std::sqrt(1 + mu * mu) + mu, 2);
  const auto field = effective::static_force_field(state_of(2, 0, 0.15, slip * 1e5, 1e5));
  CHECK(close(field.mobilised_friction(), mu, 1e-14));
  CHECK(effective::static_force_field(state_of(2, 0, 0.15, 0, 0)).mobilised_friction() == 0);
}

TEST_CASE("state: every impossible member is refused by name") {
  CHECK(refusal([](State&) {}) == "");
  const std::pair<const char*, double State::*> members[] = {{"tangential_ratio", &State::tangential_ratio},
                                                             {"radius", &State::radius},
                                                             {"void_ratio", &State::void_ratio},
                                                             {"stress_v", &State::stress_v},
                                                             {"stress_h", &State::stress_h}};
  for (const double bad : {-1.0, double(NAN), infinity}) {
    for (const auto& row : members)
      CHECK(refusal([&](State& s) { s.*row.second = bad; }) == row.first);
    CHECK(refusal([&](State& s) { s.coordination_number = bad; }) == "coordination_number");
  }
  CHECK(refusal([](State& s) { s.tangential_ratio = 1e20; }) == "tangential_ratio");
  CHECK(refusal([](State& s) { s.void_ratio = 0; }) == "void_ratio");
  CHECK(refusal([](State& s) { s.fabric_anisotropy = 1.4; }) == "fabric_anisotropy");
  CHECK(refusal([](State& s) { s.stress_h = 0; }) == "stress_h");
  CHECK(refusal([](State& s) { s.stress_v = 0; }) == "stress_v");
  CHECK(refusal([](State& s) { s.stress_v = 1e6 * s.stress_h; }) != "");
  const State forgotten{.law = sample.law, .radius = 5e-4};
  CHECK_THROWS_AS((void)effective::require_valid(forgotten), InvalidArgument);
  CHECK_THROWS_AS((void)effective::prefactor(forgotten), InvalidArgument);
  CHECK_THROWS_AS((void)effective::mean_contact_force(forgotten), InvalidArgument);
  CHECK_THROWS_AS((void)effective::static_force_field(forgotten), InvalidArgument);
}

TEST_CASE("state: possible values outside the derivation are noted") {
  CHECK(effective::require_valid(sample).notes.empty());
  const auto threshold = [](double at, auto change) {
    check_threshold(at, [&](double value) {
      State s = sample;
      change(s, value);
      return effective::require_valid(s).notes.size();
    });
  };
  for (const double a : {-1.0, 1.0})
    threshold(a, [](State& s, double x) { s.fabric_anisotropy = x; });
  threshold(12, [](State& s, double x) { s.coordination_number = x; });
  // The largest contact radius a = k_n (1 - nu)/(2 G) is a tenth of R; a ~ p^(1/3).
  const auto field = effective::static_force_field(sample);
  const double a = sample.law.stiffness_at_force(std::max(field.vertical, field.horizontal)) *
                   (1 - sample.law.grain().poisson_ratio) / (2 * sample.law.grain().shear_modulus);
  threshold(std::pow(0.1 * sample.radius / a, 3), [](State& s, double x) {
    s.stress_v *= x;
    s.stress_h *= x;
  });
}

TEST_CASE("state: without contacts moduli are the limit 0, and forces do not exist") {
  State none = sample;
  none.coordination_number = 0;
  CHECK(effective::require_valid(none).notes.size() == 1);
  CHECK(effective::prefactor(none) == 0);
  CHECK_THROWS_AS((void)effective::mean_contact_force(none), InvalidArgument);
  CHECK_THROWS_AS((void)effective::static_force_field(none), InvalidArgument);
  CHECK_THROWS_AS((void)effective::uniform_contacts(none), InvalidArgument);
  for (const auto estimate : {effective::uniform_strain, effective::free_spin, effective::uniform_stress})
    for (const double stress : {0.0, 1e5}) {
      none.stress_v = none.stress_h = stress;
      CHECK(estimate(none).stiffness == elastic::TransverselyIsotropic{});
    }
  State few = sample; // K ~ C_n^(alpha/(1+alpha))
  *few.coordination_number *= 0x1p-12;
  CHECK(close(effective::uniform_strain(few).stiffness.C11 * 256,
              effective::uniform_strain(sample).stiffness.C11, 1e-14));
}

TEST_CASE("state: stresses at the end of the range of doubles") {
  const State base = state_of(2, 0.3, 0.15, 2e5, 1e5);
  const auto reference = effective::uniform_strain(base).stiffness;
  for (const int lift : {-1050, -1026, -990, 100}) { // subnormal stresses first
    State s = base;
    s.stress_v = std::ldexp(s.stress_v, lift);
    s.stress_h = std::ldexp(s.stress_h, lift);
    CAPTURE(lift);
    // 2e5 2^-1050 keeps 41 binary digits of the stress.
    const double tolerance = lift < -1026 ? 1e-12 : 2e-14;
    CHECK(
        close(effective::uniform_strain(s).stiffness.C33, std::exp2(lift / 3.0) * reference.C33, tolerance));
  }
  State tiny = base;
  tiny.stress_v = tiny.stress_h = 5e-324;
  CHECK(all_finite(effective::uniform_strain(tiny).stiffness));
  State huge = base;
  huge.stress_v = huge.stress_h = 1e307;
  CHECK(all_finite(effective::uniform_strain(huge).stiffness));
}

TEST_CASE("b of a state is that of its law at the mean force") {
  for (const double alpha : {1.0, 1.5, 2.0, infinity}) {
    State s = state_of(alpha, 0.2, 0.15, 1.8e5, 1e5);
    CHECK(effective::contact_exponent(s) == s.law.exponent_at_force(effective::mean_contact_force(s)));
    CHECK(std::abs(effective::contact_exponent(s) - 1 / (1 + alpha)) < 1e-15);
    State few = s;
    few.law = contact::RoughSphere(s.law.grain(), s.radius, 50e-9);
    few.coordination_number = 0.5;
    CHECK(effective::contact_exponent(few) == few.law.exponent_at_force(effective::mean_contact_force(few)));
    s.coordination_number = 0;
    CHECK(effective::contact_exponent(s) == s.law.exponent_at_force(0));
    s.void_ratio = -1;
    CHECK_THROWS_AS((void)effective::contact_exponent(s), InvalidArgument);
  }
}
