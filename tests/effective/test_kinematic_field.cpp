// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/uniform_field.hpp>

#include <tuple>

#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::KinematicForceField;

namespace {

/// Directions of the packing with the stiffnesses that a field gives them.
std::vector<Direction> directions_in(const State& s, const KinematicForceField& field, int along = 200) {
  auto directions = directions_of(s, along);
  for (Direction& d : directions) {
    d.k_n = field.law.stiffness_at_overlap(field.overlap(d.normal.z()));
    d.k_t = field.tangential_ratio * d.k_n;
  }
  return directions;
}

/// sum f_i n_j l/V of the field's forces, vertical and horizontal.
std::pair<double, double> mean_stress(const State& s, const KinematicForceField& field) {
  double v = 0, h = 0;
  for (const Direction& d : directions_of(s, 200)) {
    const double x = d.normal.z(), sine = std::sqrt((1 - x) * (1 + x));
    const double f_n = field.normal_force(x);
    const double f_t = field.tangential_force(std::abs(x));
    v += d.share * (f_n * x * x - f_t * std::abs(x) * sine);
    h += d.share * (f_n * sine * sine + f_t * std::abs(x) * sine) / 2;
  }
  const double density = contact_density(s) / (2 * s.radius);
  return {density * v, density * h};
}

} // namespace

TEST_CASE("kinematic field: its forces balance the stress, its contacts give the stiffness") {
  for (const double alpha : {1.0, 1.7, 2.0, 30.0, infinity})
    for (const double a : {-0.8, 0.0, 0.5})
      for (const double ratio : {0.5, 1.0, 2.5})
        for (const double r : {0.0, 0.5, 0.919, 1.3}) {
          CAPTURE(alpha);
          CAPTURE(a);
          CAPTURE(ratio);
          CAPTURE(r);
          State s = state_of(alpha, a, 0.15, ratio * 1e5, 1e5);
          s.tangential_ratio = r;
          KinematicForceField field{.law = *s.law.power_law()};
          try {
            field = effective::kinematic_force_field(s);
          } catch (const InvalidArgument&) {
            CHECK(r == 0); // smooth grains of this fabric do not bear the ratio with all contacts closed
            continue;
          }
          const auto [v, h] = mean_stress(s, field);
          CHECK(close(v, s.stress_v, 1e-11));
          CHECK(close(h, s.stress_h, 1e-11));
          const auto directions = directions_in(s, field);
          const double P = contact_density(s);
          CHECK(difference(effective::uniform_strain_kinematic(s).stiffness,
                           stiffness_by_strain(P, directions)) < 1e-11);
          if (r > 0)
            CHECK(difference(effective::uniform_stress_kinematic(s).stiffness,
                             stiffness_by_stress(P, directions)) < 1e-11);
        }
}

TEST_CASE("kinematic field: the static one where both fields are isotropic, and for flat punches") {
  for (const double alpha : {1.0, 2.0, 5.0, infinity}) {
    const State s = state_of(alpha, 0, 0.15, 1e5, 1e5);
    CHECK(difference(effective::uniform_strain_kinematic(s).stiffness,
                     effective::uniform_strain(s).stiffness) < 1e-13);
    CHECK(difference(effective::uniform_stress_kinematic(s).stiffness,
                     effective::uniform_stress(s).stiffness) < 1e-13);
    const auto field = effective::kinematic_force_field(s);
    CHECK(close(field.normal_force(0.3), effective::mean_contact_force(s), 1e-13));
    CHECK(std::abs(field.tangential_force(0.3)) < 1e-13 * field.normal_force(0.3));
  }
  const State flat = state_of(infinity, 0.5, 0.15, 2e5, 1e5);
  CHECK(difference(effective::uniform_strain_kinematic(flat).stiffness,
                   effective::uniform_strain(flat).stiffness) < 1e-14);
}

TEST_CASE("kinematic field: stress ratios that would open contacts are refused") {
  // Smooth spheres: between one strain and none across, stress_v/stress_h runs from 2/5 to 4.
  const auto smooth = [](double ratio) {
    State s = state_of(2, 0, 0.15, ratio * 1e5, 1e5);
    s.tangential_ratio = 0;
    return s;
  };
  for (const double ratio : {0.3999, 4.001})
    CHECK_THROWS_AS((void)effective::uniform_strain_kinematic(smooth(ratio)), InvalidArgument);
  for (const double ratio : {0.4005, 3.998}) {
    const auto field = effective::kinematic_force_field(smooth(ratio));
    CHECK(field.strain_v > 0);
    CHECK(field.strain_h > 0);
  }
  // Where k_t = k_n a strain goes straight into the stress along it: any ratio short of the limit.
  State rough = state_of(2, 0, 0.15, 1e5 * 900, 1e5);
  rough.tangential_ratio = 1;
  CHECK(effective::kinematic_force_field(rough).strain_h > 0);
  CHECK_THROWS_AS((void)effective::kinematic_force_field(state_of(2, 0, 0.15, 1e5, 0)), InvalidArgument);
}

TEST_CASE("kinematic field: limits and homogeneity") {
  for (const double alpha : {1.0, 2.0}) {
    CHECK(effective::uniform_strain_kinematic(state_of(alpha, 0.2, 0.15, 0, 0)).stiffness ==
          elastic::TransverselyIsotropic{});
    CHECK(effective::kinematic_force_field(state_of(alpha, 0.2, 0.15, 0, 0)).strain_v == 0);
    const State s = state_of(alpha, 0.2, 0.15, 2e5, 1e5);
    for (const int power : {-1020, 30}) {
      State scaled = s;
      scaled.stress_v = std::ldexp(s.stress_v, power);
      scaled.stress_h = std::ldexp(s.stress_h, power);
      const double factor = std::exp2(power / (1 + alpha));
      CHECK(close(effective::uniform_strain_kinematic(scaled).stiffness.C44,
                  factor * effective::uniform_strain_kinematic(s).stiffness.C44, 1e-12));
    }
    State none = s;
    none.coordination_number = 0;
    CHECK(effective::uniform_strain_kinematic(none).stiffness == elastic::TransverselyIsotropic{});
    CHECK_THROWS_AS((void)effective::kinematic_force_field(none), InvalidArgument);
  }
  const auto flat = effective::uniform_strain_kinematic(state_of(infinity, 0.2, 0.15, 0, 0)).stiffness;
  CHECK(difference(flat, effective::uniform_strain(state_of(infinity, 0.2, 0.15, 2e5, 1e5)).stiffness) <
        1e-14);
}
