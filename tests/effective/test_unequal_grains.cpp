// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of unequal grains against sums over contacts, and where they must not differ from equal ones.
#include <granum/effective/uniform_field.hpp>

#include <granum/contact/grains.hpp>
#include <granum/effective/batch.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/sizes/distribution.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using effective::State;

namespace {

constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
constexpr double mean_radius = 0.5e-3;

/// Grains and contacts without positions: all that a closed form knows.
struct Contacts {
  std::vector<double> radii;
  std::vector<sizes::TouchingPair> pairs;
  double volume = 0;
};

Contacts drawn(double void_ratio) {
  Contacts out;
  double solid = 0;
  for (const double x : sizes::sample_radii(sizes::Distribution::lognormal(0.4), 500, 3)) {
    out.radii.push_back(mean_radius * x);
    solid += 4 * std::numbers::pi / 3 * std::pow(out.radii.back(), 3);
  }
  for (std::size_t k = 0; k < out.radii.size(); ++k)
    for (const std::size_t step : {1U, 7U, 12U})
      out.pairs.push_back({out.radii[k], out.radii[(k + step) % out.radii.size()]});
  out.volume = solid * (1 + void_ratio);
  return out;
}

State state_of(const Contacts& c, const contact::PowerLaw& law, double reference = mean_radius) {
  return {.law = law,
          .tangential_ratio = 0.9,
          .radius = reference,
          .void_ratio = 0.6,
          .coordination_number =
              2.0 * static_cast<double>(c.pairs.size()) / static_cast<double>(c.radii.size()),
          .fabric_anisotropy = 0.2,
          .stress_v = 100e3,
          .stress_h = 60e3,
          .contacts = sizes::counted_contact_means(c.radii, c.pairs, reference)};
}

double sum_of_branches(const Contacts& c, double power) {
  double sum = 0;
  for (const auto& [i, j] : c.pairs)
    sum += std::pow(i + j, power);
  return sum;
}

void check_same(const elastic::TransverselyIsotropic& a, const elastic::TransverselyIsotropic& b,
                double tolerance) {
  CHECK(a.C11 == relative(b.C11, tolerance));
  CHECK(a.C33 == relative(b.C33, tolerance));
  CHECK(a.C13 == relative(b.C13, tolerance));
  CHECK(a.C44 == relative(b.C44, tolerance));
}

} // namespace

TEST_CASE("unequal grains: prefactor and mean force are sums over the contacts") {
  const Contacts c = drawn(0.6);
  const State s = state_of(c, contact::PowerLaw::sphere(quartz, mean_radius));
  CHECK(effective::prefactor(s) == relative(sum_of_branches(c, 2) / c.volume, 1e-13));
  const double p = (s.stress_v + 2 * s.stress_h) / 3;
  CHECK(effective::mean_contact_force(s) == relative(3 * p * c.volume / sum_of_branches(c, 1), 1e-13));
  // The static field bears the stress: <f_i n_j> N_c <l>/V, of F^-1 n whose mean product with n is 1.
  const effective::StaticForceField field = effective::static_force_field(s);
  const double a = s.fabric_anisotropy, F33 = (5 + a) / (5 * (3 - a));
  CHECK(field.vertical * F33 * sum_of_branches(c, 1) / c.volume == relative(s.stress_v, 1e-13));
}

TEST_CASE("unequal grains: linear contacts, and spheres of one force, have the bulk modulus of their sum") {
  // Isotropic K = (1/9V) sum k_n l^2 under uniform strain, (1/9V) (sum l)^2/(sum 1/k_n) of uniform stress.
  const Contacts c = drawn(0.6);
  State s = state_of(c, contact::PowerLaw::flat(quartz, 5e-6));
  s.fabric_anisotropy = 0;
  s.stress_h = s.stress_v;
  const double k_n = s.law.stiffness_at_force(1);
  CHECK(effective::uniform_strain(s).stiffness.bulk_modulus() ==
        relative(k_n * sum_of_branches(c, 2) / (9 * c.volume), 1e-12));
  const double lengths = sum_of_branches(c, 1), count = static_cast<double>(c.pairs.size());
  CHECK(effective::uniform_stress(s).stiffness.bulk_modulus() ==
        relative(k_n * lengths * lengths / count / (9 * c.volume), 1e-12));
  check_same(effective::uniform_stress_stiffness(effective::uniform_contacts(s)),
             effective::uniform_stress(s).stiffness, 1e-13);
  // Estimates by force and by strain keep their order: uniform strain is an upper bound.
  CHECK(effective::uniform_stress(s).stiffness.bulk_modulus() <
        effective::uniform_strain(s).stiffness.bulk_modulus());
  // Spheres of one force: R* of each pair.
  s.law = contact::PowerLaw::sphere(quartz, mean_radius * s.contacts.pair_radius);
  const double force = effective::mean_contact_force(s);
  double sum = 0;
  for (const auto& [i, j] : c.pairs)
    sum += contact::PowerLaw::sphere(quartz, contact::pair_radius(i, j)).stiffness_at_force(force) *
           std::pow(i + j, 2);
  CHECK(effective::uniform_strain(s).stiffness.bulk_modulus() == relative(sum / (9 * c.volume), 1e-12));
}

TEST_CASE("unequal grains: the reference radius does not matter") {
  const Contacts c = drawn(0.6);
  const contact::PowerLaw law = contact::PowerLaw::sphere(quartz, mean_radius);
  const State s = state_of(c, law), other = state_of(c, law, 1.7 * mean_radius);
  check_same(effective::uniform_strain(s).stiffness, effective::uniform_strain(other).stiffness, 1e-13);
  check_same(effective::uniform_stress(s).stiffness, effective::uniform_stress(other).stiffness, 1e-13);
  check_same(effective::uniform_strain_kinematic(s).stiffness,
             effective::uniform_strain_kinematic(other).stiffness, 1e-11);
  check_same(effective::relaxed(s, 6.2).stiffness, effective::relaxed(other, 6.2).stiffness, 1e-13);
  CHECK(effective::kinematic_force_field(s).branch_length ==
        relative(effective::kinematic_force_field(other).branch_length, 1e-13));
}

TEST_CASE("unequal grains: the kinematic field has the stress of the state, with the stiffness of the same "
          "contacts") {
  const State s = state_of(drawn(0.6), contact::PowerLaw::sphere(quartz, mean_radius));
  const effective::KinematicForceField field = effective::kinematic_force_field(s);
  const auto C = effective::uniform_strain_kinematic(s).stiffness;
  const double secant = 1 / field.law.force_exponent();
  CHECK(secant * (C.C33 * field.strain_v + 2 * C.C13 * field.strain_h) == relative(s.stress_v, 1e-10));
  CHECK(secant * ((C.C11 + C.C12) * field.strain_h + C.C13 * field.strain_v) == relative(s.stress_h, 1e-10));
}

TEST_CASE("unequal grains: equal ones are the special case to the bit") {
  State s = state_of(drawn(0.6), contact::PowerLaw::sphere(quartz, mean_radius));
  s.contacts = {};
  State counted = s;
  const std::vector<double> radii(40, mean_radius);
  const std::vector<sizes::TouchingPair> pairs(90, {mean_radius, mean_radius});
  counted.contacts = sizes::counted_contact_means(radii, pairs, mean_radius);
  CHECK(effective::uniform_strain(counted).stiffness == effective::uniform_strain(s).stiffness);
  counted.contacts = sizes::expected_contact_means(sizes::Distribution::bidisperse(1), 0.2);
  CHECK(effective::uniform_stress(counted).stiffness == effective::uniform_stress(s).stiffness);
  counted.contacts = sizes::expected_contact_means(sizes::Distribution::lognormal(1e-5));
  check_same(effective::uniform_strain(counted).stiffness, effective::uniform_strain(s).stiffness, 1e-8);
}

TEST_CASE("unequal grains: means that no packing can have are refused") {
  State s = state_of(drawn(0.6), contact::PowerLaw::sphere(quartz, mean_radius));
  s.contacts.branch_square = 0.5 * s.contacts.branch * s.contacts.branch;
  CHECK_THROWS_AS((void)effective::uniform_strain(s), InvalidArgument);
  s.contacts = {.branch = -1};
  CHECK_THROWS_WITH_AS((void)effective::prefactor(s), doctest::Contains("branch = -1"), InvalidArgument);
  effective::UniformContacts contacts{
      .prefactor = 1, .normal_stiffness = 1, .tangential_stiffness = 1, .branch_evenness = 1.1};
  CHECK_THROWS_AS((void)effective::uniform_stress_stiffness(contacts), InvalidArgument);
  contacts.branch_evenness = 1;
  for (const double end : {-7.0 / 3, 7.0 / 5}) // beyond, the fabric tensor has a negative part
    check_threshold(end, [&](double a) {
      contacts.fabric_anisotropy = a;
      return refusals([&] { (void)effective::uniform_stress_stiffness(contacts); });
    });
}

namespace {

/// Spheres at 100 kPa whose branches have this coefficient of variation.
State scattered_branches(double deviation) {
  return {.law = contact::PowerLaw::sphere(quartz, mean_radius),
          .tangential_ratio = 0.9,
          .radius = mean_radius,
          .void_ratio = 0.6,
          .coordination_number = 4.8,
          .stress_v = 100e3,
          .stress_h = 100e3,
          .contacts = {.branch = 1.0, .branch_square = 1 + deviation * deviation}};
}

double relaxed_share(const State& s, double z) {
  return effective::relaxed(s, z).stiffness.G_vh() / effective::uniform_strain(s).stiffness.G_vh();
}

double bulk_share(const State& s, double z) {
  return effective::relaxed(s, z).stiffness.bulk_modulus() /
         effective::uniform_strain(s).stiffness.bulk_modulus();
}

/// By how much z* of equal grains is larger that keep the same share.
double shift_of(double deviation, double z) {
  const State equal = scattered_branches(0), unequal = scattered_branches(deviation);
  double low = z, high = z + 1;
  while (high - low > 1e-12)
    (relaxed_share(equal, (low + high) / 2) < relaxed_share(unequal, z) ? low : high) = (low + high) / 2;
  return low - z;
}

} // namespace

TEST_CASE("unequal grains relax less in G than equal ones of their z*, as equal ones of a larger z* do") {
  const State equal = scattered_branches(0);
  constexpr double z = 4.3;
  double shift = 0;
  for (const double deviation : {0.2, 0.4}) {
    const State unequal = scattered_branches(deviation);
    CHECK(relaxed_share(unequal, z) > 1.01 * relaxed_share(equal, z));
    const double found = shift_of(deviation, z) / (deviation * deviation);
    if (shift > 0)
      CHECK(found == relative(shift, 1e-8)); // in proportion to the variance, at every z*
    shift = found;
  }
  // It fades above the isostatic point: to a quarter of what it is there half a contact above.
  const double isostatic = effective::isostatic_coordination_number(0.9);
  CHECK(shift_of(0.4, isostatic + 1) / shift_of(0.4, isostatic + 0.5) == relative(4.0 / 9, 1e-8));
}

TEST_CASE(
    "unequal grains lose K as the variance of their branches grows, less so far above the isostatic point") {
  // 1/share - 1 = loss v/d_1: in proportion to v, and d_1 grows as z*.
  const auto loss = [](double deviation, double z) {
    return bulk_share(scattered_branches(0), z) / bulk_share(scattered_branches(deviation), z) - 1;
  };
  CHECK(loss(0.4, 4.5) == relative(4 * loss(0.2, 4.5), 1e-10));
  CHECK(loss(0.4, 4.5) > 0.05);
  const double d = loss(0.4, 5.5) / (loss(0.4, 4.5) - loss(0.4, 5.5)); // d_1 at z* = 4.5
  CHECK(loss(0.4, 6.5) == relative(loss(0.4, 4.5) * d / (d + 2), 1e-8));
}

TEST_CASE(
    "unequal grains: stated errors of rung 3 grow with their differences, with a note where none were seen") {
  double G = 0, K = 0;
  for (const double deviation : {0.0, 0.1, 0.3, 0.5, 0.9}) {
    CAPTURE(deviation);
    const effective::RelaxedEstimate estimate = effective::relaxed(scattered_branches(deviation), 5);
    CHECK(estimate.relative_error.G_vh > G);
    CHECK(estimate.relative_error.bulk_modulus > K);
    G = estimate.relative_error.G_vh;
    K = estimate.relative_error.bulk_modulus;
    const auto noted = [](double of) {
      return effective::relaxed(scattered_branches(of), 5).validity.notes.size();
    };
    CHECK(noted(deviation) - noted(0) == (deviation > 0.51 ? 1 : 0));
  }
  CHECK(G > 0.08);
  CHECK(K > 0.08);
}
