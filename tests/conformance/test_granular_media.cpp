// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that published programs for granular media have had, and extreme inputs. Each test shows that granum
// does not have the fault that its name states.
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <granum/contact/power_law.hpp>
#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/rock_physics/cement.hpp>
#include <granum/rock_physics/sphere_packs.hpp>

#include "relative.hpp"

using namespace granum;
using namespace granum::effective;
using namespace granum::rock_physics;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double poisson_ratio(double K, double G) { return (3 * K - 2 * G) / (2 * (3 * K + G)); }

/// The packing of most tests: quartz grains, K 36.6 and G 45 GPa, porosity 0.4, C_n = 8.6, 20 MPa.
SpherePacking reference(double no_slip_fraction = 1) {
  return {45e9, poisson_ratio(36.6, 45), 0.4, 8.6, 20e6, no_slip_fraction};
}
SpherePacking with(double SpherePacking::*member, double value) {
  SpherePacking packing = reference();
  packing.*member = value;
  return packing;
}
BondedPacking bonded(double pressure, double bond = 0.2) {
  return {44e9, poisson_ratio(37, 44), 0.36, 9, pressure, bond};
}
StrainedPacking strained(double e0, double e3, double no_slip_fraction = 1) {
  return {44e9, poisson_ratio(37, 44), 0.36, 6, e0, e3, no_slip_fraction};
}
CementedPacking cemented(double saturation) {
  return {45e9, poisson_ratio(36.6, 45), 45e9, poisson_ratio(37, 45), 0.4, 8.6, saturation};
}

/// Modulus of a contact under the strain e along its normal: 3 C_n (1-phi) G sqrt(e)/(pi (1-nu)).
double contact_modulus(const StrainedPacking& p, double e) {
  return 3 * p.coordination_number * (1 - p.porosity) * p.shear_modulus * std::sqrt(e) /
         (M_PI * (1 - p.poisson_ratio));
}

/// Integrals of x^k sqrt(a^2 + x^2) over [0, 1], k = 0, 2, 4, by a rule that is exact to the last digits for
/// a > 0.3.
std::array<double, 3> integrals(double a) {
  static const std::vector<QuadratureNode> rule = gauss_legendre(100);
  std::array<double, 3> sum{};
  for (const auto& [x, w] : rule)
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] += w / 2 * std::pow(x * x, k) * std::sqrt(a * a + x * x);
  return sum;
}

/// The five constants from the integrals as the original paper arranges them.
elastic::TransverselyIsotropic arranged(const StrainedPacking& p, const std::array<double, 3>& I) {
  const double r = 2 * (1 - p.poisson_ratio) / (2 - p.poisson_ratio) * p.no_slip_fraction;
  const double M = contact_modulus(p, p.uniaxial_strain);
  const double pair = (I[0] - 2 * I[1] + I[2]) / 8, mixed = (I[1] - I[2]) / 2, flat = (I[0] - I[1]) / 2;
  return {.C11 = M * (3 * (1 - r) * pair + r * flat),
          .C33 = M * ((1 - r) * I[2] + r * I[1]),
          .C12 = M * (1 - r) * pair,
          .C13 = M * (1 - r) * mixed,
          .C44 = M * ((1 - r) * mixed + r / 4 * (flat + I[1]))};
}

void check_equal(const elastic::TransverselyIsotropic& a, const elastic::TransverselyIsotropic& b,
                 double tolerance) {
  CHECK(a.C11 == relative(b.C11, tolerance));
  CHECK(a.C33 == relative(b.C33, tolerance));
  CHECK(a.C44 == relative(b.C44, tolerance));
  CHECK(std::abs(a.C12 - b.C12) < tolerance * b.C11);
  CHECK(std::abs(a.C13 - b.C13) < tolerance * b.C11);
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

// ---- wrong physics

TEST_CASE("fault, wrong logarithm: integrals of strained packings are right at every ratio of strains") {
  for (const double a : {0.4, 1.0, std::sqrt(10.0), 30.0}) {
    const double e3 = 0.004 / (1 + a * a), e0 = 0.004 - e3;
    check_equal(norris_johnson(strained(e0, e3)).stiffness, arranged(strained(e0, e3), integrals(a)), 1e-13);
  }
  const auto isotropic = norris_johnson(strained(0.001, 0)).stiffness;
  check_equal(norris_johnson(strained(0.001, 1e-18)).stiffness, isotropic, 1e-14);
}

TEST_CASE("fault, truncated series: C11 of a strained packing is exact") {
  const auto c = norris_johnson(strained(0.03, 0.05)).stiffness;
  CHECK(c.C11 == relative(11.338976e9, 1e-7));
  CHECK(c.C33 == relative(13.936804e9, 1e-7));
  check_equal(norris_johnson(strained(0.0005, 0.05)).stiffness,
              arranged(strained(0.0005, 0.05), integrals(0.1)), 1e-9);
}

TEST_CASE("fault, sign by loading path: every strain path compresses the packing") {
  for (const auto path :
       {StrainPath::hydrostatic_first, StrainPath::uniaxial_first, StrainPath::simultaneous}) {
    const auto stress = norris_johnson_stress(strained(0.003, 0.005), path);
    CHECK(stress.h > 0);
    CHECK(stress.v > stress.h);
    // Tangential forces move stress between the axes; the mean stress is that of the normal forces.
    const auto smooth = norris_johnson_stress(strained(0.003, 0.005, 0), path);
    CHECK(stress.v + 2 * stress.h == relative(smooth.v + 2 * smooth.h, 1e-14));
  }
}

TEST_CASE("fault, slip inverted: a no-slip fraction of 1 is rough, of 0 smooth") {
  CHECK(hertz_mindlin(reference(1)).shear_modulus == relative(2.802805417138183e9, 1e-14));
  CHECK(hertz_mindlin(reference(0)).shear_modulus == relative(1.143791916552714e9, 1e-14));
}

TEST_CASE("fault, wrong factor: the bulk modulus goes with (1 - nu), not with 1 - nu^2") {
  const double K0 = hertz_mindlin(with(&SpherePacking::poisson_ratio, 0)).bulk_modulus;
  for (const double nu : {-0.5, 0.2, 0.5})
    CHECK(hertz_mindlin(with(&SpherePacking::poisson_ratio, nu)).bulk_modulus ==
          relative(K0 * std::pow(1 - nu, -2.0 / 3), 2e-15));
}

TEST_CASE("fault, wrong recursion: the fourth integral is built on the second") {
  // Smooth contacts: C33 is the contact modulus times the fourth integral.
  for (const auto& [a, I4] : {std::pair{1.0, 0.2613}, {0.77, 0.228}}) {
    const auto p = strained(a * a * 0.002, 0.002, 0);
    const double found = norris_johnson(p).stiffness.C33 / contact_modulus(p, 0.002);
    CHECK(std::abs(found - I4) < 6e-4); // printed with three or four digits
    CHECK(found == relative(integrals(a)[2], 1e-13));
  }
}

TEST_CASE("fault, C12 left unset: a coordination number that grows with pressure gives all constants") {
  for (const double pressure : {1e4, 1e6, 1e8}) {
    auto p = strained(0.001, 0.002);
    p.coordination_number = 6 + std::cbrt(pressure / 6e4);
    const auto c = norris_johnson(p).stiffness;
    CHECK(c.C12 > 0);
    CHECK(c.C66() == relative((c.C11 - c.C12) / 2, 1e-15));
    CHECK(c.positive_definite());
  }
}

TEST_CASE("fault, pi as 3.14: pi has all its digits") {
  // pi = 3.14 would be 3.4e-4 off.
  CHECK(hertz_mindlin(reference()).bulk_modulus == relative(1.906319860921191e9, 1e-14));
  CHECK(soft_sand(reference(), 0.4).bulk_modulus == relative(1.906319860921191e9, 1e-14));
}

TEST_CASE("fault, coordination number ignored: it is an argument and counts") {
  const double ratio = hertz_mindlin(with(&SpherePacking::coordination_number, 5)).bulk_modulus /
                       hertz_mindlin(with(&SpherePacking::coordination_number, 10)).bulk_modulus;
  CHECK(ratio == relative(std::pow(0.5, 2.0 / 3), 1e-15));
  CHECK(refusal([] {
          (void)hertz_mindlin(with(&SpherePacking::coordination_number, not_a_number));
        }).find("coordination_number") == 0);
}

TEST_CASE("fault, negative modulus: the fluctuation theory is refused below its domain") {
  for (const double k : {3.0, 3.5, 3.9, 4.0, 5.0})
    CHECK(refusal([k] { (void)jenkins_shear_factor(k); }).find("coordination_number") == 0);
  CHECK(jenkins_shear_factor(5.1) > 0);
}

TEST_CASE("fault, factor 2 lost: the radius of cement at contacts has it") {
  const double S = cement_saturation(0.4, 0.36);
  CHECK(contact_cement(cemented(S), CementScheme::at_contacts).bulk_modulus == relative(10.68e9, 5e-4));
  CHECK(cement_radius_ratio(cemented(S), CementScheme::at_contacts) ==
        relative(2 * std::pow(0.04 / (3 * 8.6 * 0.6), 0.25), 1e-14));
}

TEST_CASE("fault, argument changed: a second call gives the same bits and does not change its argument") {
  const SpherePacking packing = reference();
  const auto first = hertz_mindlin(packing), second = hertz_mindlin(packing);
  CHECK(first.bulk_modulus == second.bulk_modulus);
  CHECK(first.shear_modulus == second.shear_modulus);
  CHECK(packing.pressure == 20e6);
}

TEST_CASE("fault, porosity ignored: it counts") {
  CHECK(hertz_mindlin(with(&SpherePacking::porosity, 0.2)).bulk_modulus ==
        relative(hertz_mindlin(reference()).bulk_modulus * std::pow(0.8 / 0.6, 2.0 / 3), 1e-14));
}

TEST_CASE("fault, coordination number replaced: sands use the one that is given, zero too") {
  const auto bulk = [](double C_n) {
    return soft_sand(with(&SpherePacking::coordination_number, C_n), 0.3).bulk_modulus;
  };
  CHECK(bulk(9) > 1.2 * bulk(5));
  CHECK(bulk(0) == 0);
}

TEST_CASE("fault, 0/0 at equal Lame constants: Walton's rough packing is right there too") {
  // Walton's form: A = (1/G - 1/(G + lambda))/(4 pi), B = (1/G + 1/(G + lambda))/(4 pi).
  for (const double nu : {0.25, poisson_ratio(36.6, 45), 0.4}) {
    const double lambda = 2 * 45e9 * nu / (1 - 2 * nu);
    const double A = (1 / 45e9 - 1 / (45e9 + lambda)) / (4 * M_PI);
    const double B = (1 / 45e9 + 1 / (45e9 + lambda)) / (4 * M_PI);
    const double K = std::cbrt(3 * std::pow(0.6 * 8.6, 2) * 20e6 / (std::pow(M_PI, 4) * B * B)) / 6;
    const auto rough = hertz_mindlin(with(&SpherePacking::poisson_ratio, nu));
    CHECK(rough.bulk_modulus == relative(K, 1e-14));
    CHECK(rough.shear_modulus == relative(0.6 * K * (5 * B + A) / (2 * B + A), 1e-14));
  }
}

TEST_CASE("fault, porosity returned as coordination number: outside the table it is refused") {
  const auto table = [](double porosity) {
    return coordination_number(porosity, CoordinationRelation::murphy_table);
  };
  CHECK(table(0.2) == 14.007);
  CHECK(table(0.7) == relative(3.744, 1e-15));
  for (const double porosity : {0.1, 0.19, 0.71, 0.9})
    CHECK(refusal([&] { (void)table(porosity); }).find("porosity") == 0);
}

TEST_CASE("fault, silent clipping: cement wider than its grains is noted") {
  auto p = cemented(1);
  p.porosity = 0.6;
  p.coordination_number = 3;
  CHECK(cement_radius_ratio(p, CementScheme::at_contacts) == relative(2 * std::pow(0.5 / 3, 0.25), 1e-14));
  CHECK_FALSE(contact_cement(p, CementScheme::at_contacts).validity.ok());
}

// ---- extremes

TEST_CASE("extreme: no contacts give exactly zero moduli") {
  const auto empty = with(&SpherePacking::coordination_number, 0);
  auto bonds = bonded(20e6);
  bonds.coordination_number = 0;
  for (const auto& m : {hertz_mindlin(empty), soft_sand(empty, 0.3), digby(bonds)}) {
    CHECK(m.bulk_modulus == 0);
    CHECK(m.shear_modulus == 0);
  }
}

TEST_CASE("extreme: a negative coordination number or pressure is refused by its name") {
  for (const auto& [member, name] : {std::pair{&SpherePacking::coordination_number, "coordination_number"},
                                     {&SpherePacking::pressure, "pressure"}}) {
    const SpherePacking negative = with(member, -2);
    for (const auto model : {soft_sand, stiff_sand}) {
      CHECK(refusal([&] { (void)hertz_mindlin(negative); }).find(name) == 0);
      CHECK(refusal([&] { (void)model(negative, 0.3); }).find(name) == 0);
    }
  }
  CHECK(refusal([] { (void)digby(bonded(-1)); }).find("pressure") == 0);
}

TEST_CASE("extreme: a porosity above the critical one is refused with its reason") {
  for (const auto model : {soft_sand, stiff_sand})
    CHECK(refusal([&] { (void)model(reference(), 0.8); }).find("critical porosity") != std::string::npos);
  CHECK(refusal([] { (void)cement_saturation(0.4, 0.45); }).find("porosity = 0.45") == 0);
}

TEST_CASE("extreme: impossible porosities and slip fractions are refused") {
  CHECK(refusal([] { (void)hertz_mindlin(with(&SpherePacking::porosity, -0.1)); }).find("porosity") == 0);
  CHECK(refusal([] { (void)hertz_mindlin(with(&SpherePacking::porosity, 1.2)); }).find("porosity") == 0);
  CHECK(refusal([] { (void)hertz_mindlin(reference(5)); }).find("no_slip_fraction") == 0);
  CHECK(refusal([] { (void)soft_sand(reference(), -0.1); }).find("porosity") == 0);
}

TEST_CASE("extreme: without pressure the moduli are exactly zero, or those of the bonds") {
  const auto unloaded = with(&SpherePacking::pressure, 0);
  for (const auto& m : {hertz_mindlin(unloaded), soft_sand(unloaded, 0.3), digby(bonded(0, 0))}) {
    CHECK(m.bulk_modulus == 0);
    CHECK(m.shear_modulus == 0);
  }
  CHECK(digby(bonded(0)).bulk_modulus == relative(digby(bonded(1e-3)).bulk_modulus, 1e-9));
  CHECK(stiff_sand(unloaded, 0.3).shear_modulus > 0);
}

TEST_CASE("extreme: bonded packings along a sweep of pressure rise smoothly, one value each") {
  double last = digby(bonded(0)).bulk_modulus;
  for (double pressure = 1e3; pressure <= 1e10; pressure *= 2) {
    const double K = digby(bonded(pressure)).bulk_modulus;
    CHECK(K > last);
    CHECK(K < 2 * last);
    last = K;
  }
}

TEST_CASE("extreme: incompressible grains have their finite limit, absent shear modulus is refused") {
  const auto soft = hertz_mindlin(with(&SpherePacking::poisson_ratio, 0.5));
  const auto nearly = hertz_mindlin(with(&SpherePacking::poisson_ratio, 0.5 - 1e-14));
  CHECK(soft.bulk_modulus == relative(nearly.bulk_modulus, 1e-13));
  CHECK(soft.shear_modulus == relative(nearly.shear_modulus, 1e-13));
  CHECK(std::isfinite(soft_sand(with(&SpherePacking::poisson_ratio, 0.5), 0.1).bulk_modulus));
  CHECK(refusal([] { (void)hertz_mindlin(with(&SpherePacking::shear_modulus, 0)); }).find("shear_modulus") ==
        0);
}

TEST_CASE("extreme: a Poisson's ratio of zero is nothing special") {
  const auto at = [](double nu) { return hertz_mindlin(with(&SpherePacking::poisson_ratio, nu)); };
  CHECK(at(0).shear_modulus == relative(at(1e-15).shear_modulus, 1e-14));
  CHECK(at(0).shear_modulus == relative(1.5 * at(0).bulk_modulus, 1e-15));
}

TEST_CASE("extreme: moduli and pressure in different units are noticed") {
  CHECK_FALSE(hertz_mindlin(with(&SpherePacking::shear_modulus, 45)).validity.ok()); // GPa with Pa
  auto slipped = reference();
  slipped.shear_modulus = 45; // GPa with MPa
  slipped.pressure = 20;
  CHECK_FALSE(hertz_mindlin(slipped).validity.ok());
  CHECK(hertz_mindlin(reference()).validity.ok());
}

TEST_CASE("extreme: an option that does not exist is refused") {
  CHECK_THROWS_AS((void)contact_cement(cemented(0.1), CementScheme(3)), InvalidArgument);
  CHECK_THROWS_AS((void)norris_johnson_stress(strained(0.001, 0.001), StrainPath(3)), InvalidArgument);
  CHECK_THROWS_AS((void)coordination_number(0.4, CoordinationRelation(3)), InvalidArgument);
}

TEST_CASE("extreme: incompressible or very soft cement is refused or noted") {
  auto rubber = cemented(0.1);
  rubber.cement_poisson_ratio = 0.5;
  CHECK(refusal([&] {
          (void)contact_cement(rubber, CementScheme::at_contacts);
        }).find("cement_poisson_ratio") == 0);
  auto nothing = cemented(0.1), soft = cemented(0.1);
  nothing.cement_shear_modulus = 0;
  soft.cement_shear_modulus = 0.01e9;
  CHECK(refusal([&] {
          (void)contact_cement(nothing, CementScheme::at_contacts);
        }).find("cement_shear_modulus") == 0);
  CHECK_FALSE(contact_cement(soft, CementScheme::at_contacts).validity.ok());
}

TEST_CASE("extreme: coordination relations never rise again with porosity") {
  for (const auto relation : {CoordinationRelation::murphy_table, CoordinationRelation::murphy_quadratic,
                              CoordinationRelation::murphy_exponential}) {
    const auto [low, high] = porosity_range(relation);
    double last = infinity;
    for (int i = 0; i <= 100; ++i) {
      const double C_n = coordination_number(i < 100 ? low + (high - low) * i / 100 : high, relation);
      CHECK(C_n < last);
      CHECK(C_n > 0);
      last = C_n;
    }
  }
}

// ---- cancellation near the isotropic limit

TEST_CASE("cancellation: angular integrals keep their digits towards the isotropic limit") {
  for (const double a : {10.0, 100.0, 1e3, 1e4, 1e6, 1e8}) {
    const double e0 = 0.004, e3 = e0 / (a * a), t = e3 / e0;
    std::array<double, 3> I{}; // binomial series of sqrt(1 + t x^2), times a
    double term = a;
    for (int n = 0; n < 12; ++n) {
      for (std::size_t k = 0; k < 3; ++k)
        I[k] += term / (2 * static_cast<double>(k) + 2 * n + 1);
      term *= t * (0.5 - n) / (n + 1);
    }
    CAPTURE(a);
    check_equal(norris_johnson(strained(e0, e3)).stiffness, arranged(strained(e0, e3), I), 1e-14);
  }
}

// ---- the Gamma function of the contact law

TEST_CASE("gamma function: general contact shapes neither vanish nor overflow at large exponents") {
  const contact::GrainMaterial glass{30e9, 0.15};
  const double a = 1; // a profile (r/a)^alpha of this radius tends to the flat punch
  const double flat = contact::PowerLaw::flat(glass, a).coefficient();
  double last = 0;
  for (const double alpha : {340.0, 341.0, 342.0, 343.0, 344.0, 1e3, 1e6, 1e12, 1e300}) {
    const double c = contact::PowerLaw::general(glass, alpha, 1).coefficient();
    CAPTURE(alpha);
    CHECK(c >= last);
    CHECK(c <= flat);
    last = c;
  }
  CHECK(last == relative(flat, 1e-15));
  CHECK(contact::PowerLaw::general(glass, 342, 1).coefficient() ==
        relative(contact::PowerLaw::general(glass, 341, 1).coefficient(), 1e-4));
  CHECK(contact::PowerLaw::flat(glass, a).stiffness_exponent() == 0);
  CHECK(refusal([&] { (void)contact::PowerLaw::general(glass, infinity, 1); }).find("alpha") == 0);
}
