// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/slip.hpp>

#include <random>

#include <granum/effective/relaxation.hpp>

#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::ContactSlip;
using effective::SlipOnset;

namespace {

/// Quartz spheres at one pressure [Pa].
effective::State quartz_at(double pressure) {
  const contact::GrainMaterial quartz{.shear_modulus = 44e9, .poisson_ratio = 0.074};
  effective::State s = state_of(2, 0, quartz.poisson_ratio, pressure, pressure);
  s.radius = 0.1e-3;
  s.law = contact::PowerLaw::sphere(quartz, s.radius);
  s.tangential_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio);
  s.void_ratio = 0.6;
  s.coordination_number = 5.5;
  return s;
}

/// What contacts drawn at random shed, over what they bear: u^2 exponential, forces x^2 exp(-3 x).
double drawn_loss(const SlipOnset& onset, double strain, ContactSlip slip) {
  std::mt19937_64 bits(7);
  std::exponential_distribution<double> square(1), third(3);
  double shed = 0, borne = 0;
  for (int k = 0; k < 2'000'000; ++k) {
    const double x = third(bits) + third(bits) + third(bits);
    const double u = std::sqrt(onset.mean_square * square(bits)) * strain / onset.reference_strain;
    const double c = std::pow(x, 1 - onset.exponent), k_t = std::pow(x, onset.exponent), part = u / c;
    const double force = slip == ContactSlip::sliding ? std::min(u, c)
                         : part < 1.5                 ? c * (1 - std::pow(1 - 2 * part / 3, 1.5))
                                                      : c;
    shed += k_t * u * (u - force);
    borne += k_t * u * u;
  }
  return onset.amplification * onset.tangential_share * shed / borne;
}

} // namespace

TEST_CASE("slip: the reference strain is that at which the mean contact would be at its limit") {
  const effective::State s = quartz_at(100e3);
  const SlipOnset onset = effective::slip_onset(s, 5.8, 0.5);
  const double f = effective::mean_contact_force(s), k_t = s.tangential_ratio * s.law.stiffness_at_force(f);
  CHECK(onset.reference_strain == relative(0.5 * f / (k_t * 2 * s.radius), 1e-12));
  CHECK(onset.reference_strain == relative(8e-5, 0.2)); // quartz spheres at 100 kPa
  CHECK(onset.exponent == relative(1.0 / 3, 1e-14));
  // as p^(1-b), whatever the size of the grains
  CHECK(effective::slip_onset(quartz_at(800e3), 5.8, 0.5).reference_strain ==
        relative(4 * onset.reference_strain, 1e-12));
  CHECK(effective::slip_onset(s, 5.8, 0.25).reference_strain == relative(onset.reference_strain / 2, 1e-14));
}

TEST_CASE("slip: shares are those of rung 3") {
  const effective::State s = quartz_at(100e3);
  const double z = 5.8, r = s.tangential_ratio;
  const SlipOnset onset = effective::slip_onset(s, z, 0.5);
  CHECK(onset.amplification == relative(z / (z - effective::isostatic_coordination_number(r)), 1e-14));
  // G as k_t alone is changed by 1 %
  const auto G = [&](double ratio) {
    effective::State there = s;
    there.tangential_ratio = ratio;
    return effective::relaxed(there, z).stiffness.G_vh();
  };
  CHECK(onset.tangential_share == relative(std::log(G(1.01 * r) / G(r / 1.01)) / (2 * std::log(1.01)), 1e-3));
  // Without relaxation the mean square would be that of uniform strain, 1/10; the share r/10 of r/10 + 1/15.
  const SlipOnset full = effective::slip_onset(s, 60, 0.5);
  CHECK(full.mean_square == relative(0.1, 0.05));
  CHECK(full.tangential_share == relative(r / 10 / (r / 10 + 1.0 / 15), 0.05));
}

TEST_CASE("slip: losses are means over contacts drawn at random") {
  const SlipOnset onset = effective::slip_onset(quartz_at(100e3), 5.8, 0.5);
  for (const double y : {0.8, 1.2, 1.6}) {
    const double strain = y * onset.reference_strain;
    CHECK(effective::slip_loss(onset, strain, ContactSlip::sliding) ==
          relative(drawn_loss(onset, strain, ContactSlip::sliding), 0.03));
  }
  // of partial slip the first order: at a loss of 5 % it is 4 % of it off
  const double little = effective::strain_of_slip_loss(onset, 0.002),
               most = effective::strain_of_slip_loss(onset, effective::largest_slip_loss);
  CHECK(drawn_loss(onset, little, ContactSlip::partial) == relative(0.002, 0.01));
  CHECK(drawn_loss(onset, most, ContactSlip::partial) == relative(0.05, 0.05));
}

TEST_CASE("slip: partial slip is in proportion to strain") {
  const SlipOnset onset = effective::slip_onset(quartz_at(100e3), 5.8, 0.5);
  const double strain = effective::strain_of_slip_loss(onset, 0.01);
  CHECK(effective::slip_loss(onset, strain, ContactSlip::partial) == relative(0.01, 1e-12));
  CHECK(effective::slip_loss(onset, strain / 2, ContactSlip::partial) == relative(0.005, 1e-12));
  CHECK(effective::slip_loss(onset, 0, ContactSlip::sliding) == 0);
}

TEST_CASE("slip: impossible packings are refused") {
  effective::State s = quartz_at(100e3);
  CHECK_THROWS_AS((void)effective::slip_onset(s, 5.8, 0), InvalidArgument);
  CHECK_THROWS_AS((void)effective::slip_onset(s, 3.9, 0.5), InvalidArgument);
  const SlipOnset onset = effective::slip_onset(s, 5.8, 0.5);
  CHECK_THROWS_AS((void)effective::slip_loss(onset, -1e-6, ContactSlip::sliding), InvalidArgument);
  CHECK_THROWS_AS((void)effective::strain_of_slip_loss(onset, 0.06), InvalidArgument);
  s.tangential_ratio = 0;
  CHECK_THROWS_AS((void)effective::slip_onset(s, 6.5, 0.5), InvalidArgument);
  CHECK_THROWS_AS((void)effective::slip_onset(quartz_at(0), 5.8, 0.5), InvalidArgument);
}
