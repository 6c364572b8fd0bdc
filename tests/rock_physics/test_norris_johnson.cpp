// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sphere_packs.hpp>

#include <granum/core/numerics.hpp>

#include "effective/support.hpp"
#include "states.hpp"
#include "unit.hpp"

using namespace granum::test;
using rock_physics::norris_johnson;
using rock_physics::norris_johnson_stress;
using rock_physics::StrainedPacking;
using rock_physics::StrainPath;

namespace {

constexpr std::array paths{StrainPath::hydrostatic_first, StrainPath::uniaxial_first,
                           StrainPath::simultaneous};

StrainedPacking strained(double e0, double e3, double nu = 0.2, double slip = 1) {
  return {.shear_modulus = 30e9,
          .poisson_ratio = nu,
          .porosity = 0.38,
          .coordination_number = 6.5,
          .hydrostatic_strain = e0,
          .uniaxial_strain = e3,
          .no_slip_fraction = slip};
}

/// Nodes on [0, 1] in panels that double in width from `first` on: functions whose branch points lie at a
/// distance `first` of 0 are integrated to the last digits.
std::vector<QuadratureNode> graded_rule(double first) {
  static const std::vector<QuadratureNode> rule = gauss_legendre(32);
  std::vector<QuadratureNode> nodes;
  for (double low = 0, high = std::min(first, 1.0);; low = high, high = std::min(2 * high, 1.0)) {
    for (const auto& [x, w] : rule)
      nodes.push_back({low + (high - low) * (1 + x) / 2, (high - low) * w / 2});
    if (high == 1)
      return nodes;
  }
}

/// Contacts of spheres of radius 1 in all directions: k_n = 2 G R sqrt(strain)/(1-nu), as Hertz has it for an
/// overlap of 2 R times the strain.
std::vector<Direction> contacts(const StrainedPacking& p) {
  const double first = p.uniaxial_strain > 0 ? std::sqrt(p.hydrostatic_strain / p.uniaxial_strain) : 1;
  const double ratio = p.no_slip_fraction * contact::mindlin_stiffness_ratio(p.poisson_ratio);
  std::vector<Direction> directions;
  for (const auto& [x, w] : graded_rule(std::max(first, 1e-9))) {
    const double strain = p.hydrostatic_strain + p.uniaxial_strain * x * x;
    const double k_n = 2 * p.shear_modulus * std::sqrt(strain) / (1 - p.poisson_ratio);
    const double sine = std::sqrt((1 - x) * (1 + x));
    for (int i = 0; i < 8; ++i) {
      const double angle = M_PI / 4 * (i + 0.3);
      directions.push_back({{sine * std::cos(angle), sine * std::sin(angle), x}, w / 8, k_n, ratio * k_n});
    }
  }
  return directions;
}

/// P = N_c l^2/V for radius 1.
double contact_density(const StrainedPacking& p) {
  return 3 * p.coordination_number * (1 - p.porosity) / (2 * M_PI);
}

} // namespace

TEST_CASE("norris johnson: the published state") {
  // Bulk modulus 37 and shear modulus 44 GPa, porosity 0.36, C_n = 6; checked by summation over contacts.
  const double K = 37e9, G = 44e9;
  const auto c = norris_johnson({.shear_modulus = G,
                                 .poisson_ratio = (3 * K - 2 * G) / (2 * (3 * K + G)),
                                 .porosity = 0.36,
                                 .coordination_number = 6,
                                 .hydrostatic_strain = 0.03,
                                 .uniaxial_strain = 0.05})
                     .stiffness;
  // Printed with 8 digits, C12 and C13 with 6.
  CHECK(c.C11 == relative(11.338976e9, 1e-7));
  CHECK(c.C12 == relative(0.0857965e9, 1e-6));
  CHECK(c.C13 == relative(0.1008496e9, 1e-6));
  CHECK(c.C33 == relative(13.936804e9, 1e-7));
  CHECK(c.C44 == relative(6.269697e9, 1e-7));
  CHECK(c.C66() == relative(5.626590e9, 1e-7));
}

TEST_CASE("norris johnson: equals the sum over contacts at any ratio of the strains") {
  int tried = 0;
  for (double ratio = 1e-16; ratio < 2e16; ratio *= 100, ++tried)
    for (const double nu : {-0.9, 0.2, 0.5}) {
      const double e0 = 0.004 * ratio / (1 + ratio), e3 = 0.004 / (1 + ratio);
      const auto p = strained(e0, e3, nu);
      CAPTURE(ratio);
      // 2,000 terms of the sum round off to some 1e-14.
      CHECK(difference(norris_johnson(p).stiffness, stiffness_by_strain(contact_density(p), contacts(p))) <
            3e-14);
    }
  CHECK(tried == 17);
  // Both sides of the change from the closed form to the quadrature.
  const double tie = 0.002;
  CHECK(difference(norris_johnson(strained(tie, tie)).stiffness,
                   norris_johnson(strained(std::nextafter(tie, 0), tie)).stiffness) < 4e-15);
}

TEST_CASE("norris johnson: limits are exact") {
  const auto iso = norris_johnson(strained(0.001, 0)).stiffness;
  CHECK(iso.C11 == relative(iso.C33, 4e-16));
  CHECK(iso.C12 == relative(iso.C13, 2e-15));
  CHECK(iso.C66() == relative(iso.C44, 1e-15));
  const double p = norris_johnson_stress(strained(0.001, 0), StrainPath::simultaneous).v;
  const auto hm = rock_physics::hertz_mindlin({30e9, 0.2, 0.38, 6.5, p});
  CHECK(iso.bulk_modulus() == relative(hm.bulk_modulus, 4e-15));
  CHECK(iso.C44 == relative(hm.shear_modulus, 4e-15));
  // The smallest anisotropy that doubles show, without a jump.
  CHECK(difference(iso, norris_johnson(strained(0.001, 1e-19)).stiffness) < 4e-15);

  for (const auto& none :
       {strained(0, 0), with(strained(0.001, 0.002), &StrainedPacking::coordination_number, 0)}) {
    CHECK(norris_johnson(none).stiffness == elastic::TransverselyIsotropic{});
    for (const auto path : paths)
      CHECK(norris_johnson_stress(none, path).v == 0);
  }
  CHECK(all_finite(norris_johnson(strained(5e-324, 5e-324)).stiffness));
}

TEST_CASE("norris johnson: stresses keep their digits at any ratio of the strains") {
  // Of each contact the tangential force that its path leaves, the integral of k_t over the uniaxial strain:
  // moments by a graded rule, the difference of cubes in a form that does not cancel.
  for (double ratio = 1e-14; ratio <= 1e14; ratio *= 10) {
    const double c = ratio / (1 + ratio), s = 1 / (1 + ratio), v = std::sqrt(c);
    double normal_v = 0, normal_h = 0, first = 0, together = 0;
    for (const auto& [x, w] : graded_rule(std::max(std::sqrt(ratio), 1e-9))) {
      const double u = std::sqrt(c + s * x * x), sine2 = (1 - x) * (1 + x);
      normal_v += w * u * u * u * x * x;
      normal_h += w * u * u * u * sine2 / 2;
      first += w * sine2 * s * x * x * (u * u + u * v + v * v) / (u + v);
      together += w * s * u * x * x * sine2;
    }
    const auto smooth = norris_johnson_stress(strained(0.004 * c, 0.004 * s, 0.2, 0), paths[0]);
    const double unit = smooth.v / normal_v;
    const double r = contact::mindlin_stiffness_ratio(0.2);
    CAPTURE(ratio);
    CHECK(smooth.h == relative(unit * normal_h, 1e-14));
    const auto added = [&](StrainPath path) {
      for (const double slip : {0.4, 1.0}) { // in proportion to it, and none to the mean stress
        const auto rough = norris_johnson_stress(strained(0.004 * c, 0.004 * s, 0.2, slip), path);
        CHECK(rough.v + 2 * rough.h == relative(smooth.v + 2 * smooth.h, 1e-14));
        const auto whole = norris_johnson_stress(strained(0.004 * c, 0.004 * s), path);
        CHECK(std::abs(rough.v - smooth.v - slip * (whole.v - smooth.v)) < 1e-14 * smooth.v);
      }
      return (norris_johnson_stress(strained(0.004 * c, 0.004 * s), path).v - smooth.v) / (unit * r);
    };
    // Absolute: what is added is a difference of stresses.
    CHECK(std::abs(added(StrainPath::hydrostatic_first) - first) < 2e-15);
    CHECK(std::abs(added(StrainPath::uniaxial_first) - s * std::sqrt(s) / 12) < 2e-15);
    CHECK(std::abs(added(StrainPath::simultaneous) - together) < 2e-15);
  }
}

TEST_CASE("norris johnson: bad input") {
  check_refused(strained(1e-3, 1e-3),
                {&StrainedPacking::shear_modulus, &StrainedPacking::poisson_ratio, &StrainedPacking::porosity,
                 &StrainedPacking::coordination_number, &StrainedPacking::hydrostatic_strain,
                 &StrainedPacking::uniaxial_strain, &StrainedPacking::no_slip_fraction},
                [](const StrainedPacking& p) {
                  CHECK_THROWS_AS((void)norris_johnson_stress(p, StrainPath::simultaneous), InvalidArgument);
                  return norris_johnson(p);
                });
  CHECK_THROWS_AS((void)norris_johnson_stress(strained(1e-3, 1e-3), StrainPath(7)), InvalidArgument);
  CHECK(norris_johnson(strained(1e-3, 1e-3)).validity.ok());
  CHECK_FALSE(norris_johnson(strained(0.03, 0.05)).validity.ok());
}
