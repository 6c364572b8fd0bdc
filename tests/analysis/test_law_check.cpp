// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/law_check.hpp>

#include "packing/sample_packings.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using analysis::check_law, analysis::LawCheck;
using contact::PowerLaw;

namespace {

const contact::GrainMaterial grain{30e9, 0.15};

/// Contacts of a law at overlaps over two decades of force, `noise` of each force at random, grains of radii
/// between R and `spread` R.
packing::Assembly contacts_of(const analysis::LawFamily& family, double noise = 0, double spread = 1) {
  samples::Uniform uniform(5);
  packing::Assembly a{.cell = Mat3::identity(), .position = {}, .radius = {}, .contacts = {}};
  for (std::uint32_t k = 0; k < 400; ++k) {
    const double r1 = 0.5e-3 * uniform(1, spread), r2 = 0.5e-3 * uniform(1, spread);
    a.position.push_back({});
    a.position.push_back({});
    a.radius.push_back(r1);
    a.radius.push_back(r2);
    const double pair = 2 * r1 * r2 / (r1 + r2);
    const double overlap = pair * std::exp(uniform(-11, -8));
    const double force = family(grain, pair).force(overlap) * (1 + uniform(-noise, noise));
    a.contacts.push_back({.i = 2 * k,
                          .j = 2 * k + 1,
                          .branch = {r1 + r2 - overlap, 0, 0},
                          .overlap = overlap,
                          .normal_force = force,
                          .tangential_force = {}});
  }
  return a;
}

/// Three contacts of each misfit, at overlaps `range` apart in their logarithms. Logarithms of their forces
/// are off a line of this slope by 1, -2 and 1 times the misfit: its least squares are the same line.
packing::Assembly about_line(double slope, double range, const std::vector<double>& misfits) {
  packing::Assembly a = contacts_of(PowerLaw::sphere);
  a.contacts.resize(3 * misfits.size());
  for (std::size_t k = 0; k < a.contacts.size(); ++k) {
    const double x = range * (static_cast<double>(k % 3) - 1);
    a.contacts[k].overlap = 0.5e-3 * std::exp(x - 9);
    a.contacts[k].normal_force = std::exp(slope * x + misfits[k / 3] * (k % 3 == 1 ? -2 : 1));
  }
  return a;
}

PowerLaw cone(const contact::GrainMaterial& g, double) { return PowerLaw::cone(g, 0.4); }
PowerLaw flat(const contact::GrainMaterial& g, double radius) { return PowerLaw::flat(g, 0.01 * radius); }

} // namespace

TEST_CASE("law check: exact forces give alpha and the coefficient, for every shape") {
  const struct {
    analysis::LawFamily family;
    double exponent;
    std::optional<double> alpha;
    double spread = 1;
  } cases[] = {{PowerLaw::sphere, 1.5, 2},
               {PowerLaw::sphere, 1.5, 2, 3}, // similar grains lie on one line
               {cone, 2, 1},
               {flat, 1, {}},
               {[](const contact::GrainMaterial& g, double radius) {
                  return PowerLaw::general(g, 1.5, 180 * std::sqrt(0.5e-3 / radius));
                },
                1 + 1 / 1.5, 1.5}};
  for (const auto& c : cases) {
    CAPTURE(c.exponent);
    const LawCheck check = check_law(contacts_of(c.family, 0, c.spread), c.family, grain);
    CHECK(check.contacts + check.left_out == 400);
    CHECK(check.contacts > 300);
    REQUIRE(check.force_exponent);
    CHECK(check.force_exponent->value == relative(c.exponent, 1e-12));
    CHECK(check.force_exponent->standard_error < 1e-12);
    REQUIRE(check.alpha.has_value() == c.alpha.has_value());
    if (c.alpha)
      CHECK(check.alpha->value == relative(*c.alpha, 1e-11));
    CHECK(check.coefficient_ratio.value() == relative(1, 1e-14));
    CHECK(check.worst_misfit < 1e-13);
  }
}

TEST_CASE("law check: the coefficient shows another material, the misfit another law") {
  const LawCheck soft = check_law(contacts_of(PowerLaw::sphere), PowerLaw::sphere, {15e9, 0.15});
  CHECK(soft.coefficient_ratio.value() == relative(2, 1e-13));
  CHECK(soft.worst_misfit < 1e-13);
  const LawCheck wrong = check_law(contacts_of(cone), PowerLaw::sphere, grain);
  CHECK(wrong.median_misfit > 0.1);
  REQUIRE(wrong.alpha);
  CHECK(wrong.alpha->value == relative(1, 1e-11)); // of the forces, not of the law they are compared with
}

TEST_CASE("law check: median and the 90 % of four forces lie between them in proportion") {
  packing::Assembly a = contacts_of(PowerLaw::sphere);
  a.contacts.resize(4);
  for (std::size_t k = 0; k < 4; ++k) // over 2.5: off by 0.6, 0.2, 0.2 and 1.4
    a.contacts[k].normal_force *= std::array{1, 3, 2, 6}[k];
  const LawCheck check = check_law(a, PowerLaw::sphere, grain);
  CHECK(check.coefficient_ratio.value() == relative(2.5, 1e-14));
  CHECK(check.median_misfit == relative(0.4, 1e-14));
  CHECK(check.misfit_90 == relative(0.6 + 0.7 * 0.8, 1e-14));
  CHECK(check.worst_misfit == relative(1.4, 1e-14));
}

TEST_CASE("law check: scatter gives an error that covers the truth, and outliers do not count") {
  packing::Assembly a = contacts_of(PowerLaw::sphere, 0.1);
  const LawCheck noisy = check_law(a, PowerLaw::sphere, grain);
  REQUIRE(noisy.force_exponent);
  CHECK(noisy.force_exponent->standard_error > 1e-3);
  CHECK(std::abs(noisy.force_exponent->value - 1.5) < 4 * noisy.force_exponent->standard_error);
  CHECK(noisy.median_misfit == relative(0.05, 0.2)); // of even noise up to 0.1
  CHECK(noisy.misfit_90 == relative(0.09, 0.1));

  a = contacts_of(PowerLaw::sphere, 1e-6);
  for (std::size_t k = 0; k < 10; ++k)
    a.contacts[k].normal_force *= 3; // viscous parts
  const LawCheck damped = check_law(a, PowerLaw::sphere, grain);
  REQUIRE(damped.force_exponent);
  CHECK(std::abs(damped.force_exponent->value - 1.5) < 1e-6);
  CHECK(damped.worst_misfit == relative(2, 1e-5));
}

TEST_CASE("law check: the errors of slopes are those of least squares, by the contacts and types there are") {
  constexpr double e = 1e-2;
  const LawCheck three = check_law(about_line(1.5, 0.5, {e}), PowerLaw::sphere, grain);
  CHECK(three.force_exponent.value().value == relative(1.5, 1e-12));
  CHECK(three.force_exponent->standard_error == relative(std::sqrt(3) * e / 0.5, 1e-10));
  CHECK(three.alpha.value().standard_error == relative(std::sqrt(3) * e / 0.5 / 0.25, 1e-10));
  check_threshold(std::sqrt(3) * e / 0.5, [&](double excess) { // no alpha within the error of 1
    return check_law(about_line(1 + excess, 0.5, {e}), PowerLaw::sphere, grain).alpha ? 1 : 0;
  });
  packing::Assembly a = about_line(1.5, 0.5, {e, e, e, e});
  std::vector<long> type;
  const auto error = [&](double freedom) { return std::sqrt(6 * 4 * e * e / freedom / (8 * 0.25)); };
  const auto found = [&] { return analysis::common_exponent(a, type); };
  CHECK(found()->standard_error == relative(error(12 - 2), 1e-10));
  CHECK(check_law(a, PowerLaw::sphere, grain).force_exponent->standard_error == relative(error(10), 1e-10));
  for (std::size_t k = 0; k < 12; ++k) {
    type.insert(type.end(), {1, k < 6 ? 1L : 2L});
    a.contacts[k].normal_force *= k < 6 ? 5 : 1;
  }
  type.resize(a.grain_count());
  CHECK(found()->value == relative(1.5, 1e-12));
  CHECK(found()->standard_error == relative(error(12 - 3), 1e-10));
  for (std::size_t k = 0; k < 12; ++k) // nine types of one contact, and one of three
    type[2 * k] = type[2 * k + 1] = static_cast<long>(std::min<std::size_t>(k, 9));
  CHECK(found()->standard_error == relative(std::sqrt(3) * e / 0.5, 1e-10));
  type[2 * 11] = type[2 * 11 + 1] = 11;
  CHECK_FALSE(found());
}

TEST_CASE("law check: which contacts are compared, and what range of overlaps gives a slope") {
  packing::Assembly a = about_line(1.5, 0.5, {0, 0, 0, 0});
  check_threshold(1e-3, [&](double share) { // of the mean force
    for (packing::Contact& c : a.contacts)
      c.normal_force = 1;
    a.contacts[5].normal_force = share * 11 / (12 - share);
    return check_law(a, PowerLaw::sphere, grain).left_out;
  });
  // beyond ten times the median misfit a contact is left out, and the error is less
  constexpr double e = 1e-3;
  const auto errors = [&](double most) {
    const packing::Assembly off = about_line(1.5, 0.5, {e, e, e, most * e / 2, e, e, e, e});
    const double all = std::sqrt(6 * (7 + most * most / 4) * e * e / (24 - 2) / (16 * 0.25));
    const double one = check_law(off, PowerLaw::sphere, grain).force_exponent->standard_error,
                 other = analysis::common_exponent(off)->standard_error;
    CHECK(one == relative(other, 1e-10));
    return one < 0.9 * all ? 1 : 0;
  };
  check_threshold(10, errors);
  check_threshold(std::sqrt(1.5) * 1e-6, [&](double range) {
    return check_law(about_line(1.5, range, {0, 0, 0, 0}), PowerLaw::sphere, grain).force_exponent ? 1 : 0;
  });
  check_threshold(std::sqrt(1.5) * 1e-3, [&](double range) {
    return analysis::common_exponent(about_line(1.5, range, {0, 0, 0, 0})) ? 1 : 0;
  });
  a = about_line(1.5, 0.5, {0});
  CHECK(analysis::rounded_share(a, 1e-8) == relative(1e-8 / (0.5e-3 * std::exp(-9)), 1e-12));
  for (packing::Contact& c : a.contacts)
    c.overlap = -c.overlap;
  CHECK(analysis::rounded_share(a, 1e-8) == 0);
}

TEST_CASE("law check: without overlaps, forces or a range of them there is no slope") {
  packing::Assembly a = contacts_of(PowerLaw::sphere);
  for (packing::Contact& c : a.contacts)
    c.normal_force = 0;
  CHECK(check_law(a, PowerLaw::sphere, grain).contacts == 0);
  a = contacts_of(PowerLaw::sphere);
  for (packing::Contact& c : a.contacts)
    c.overlap = -c.overlap;
  const LawCheck apart = check_law(a, PowerLaw::sphere, grain);
  CHECK((apart.contacts == 0 && apart.left_out == 400 && !apart.force_exponent));

  a = contacts_of(PowerLaw::sphere);
  for (packing::Contact& c : a.contacts) {
    c.overlap = 1e-7;
    c.normal_force = PowerLaw::sphere(grain, 0.5e-3).force(1e-7);
  }
  const LawCheck alike = check_law(a, PowerLaw::sphere, grain);
  CHECK(alike.contacts == 400);
  CHECK_FALSE(alike.force_exponent);
  CHECK(alike.coefficient_ratio.value() == relative(1, 1e-14));
}

TEST_CASE("law check: the exponent is found for any factor of each pair of types") {
  packing::Assembly a = contacts_of(PowerLaw::sphere, 0.001);
  std::vector<long> type;
  samples::Uniform uniform(7);
  for (std::size_t k = 0; k < a.contacts.size(); ++k) { // soft grains, and more overlap between them
    const bool soft = k % 3 == 0;
    type.insert(type.end(), {soft ? 2L : 1L, k % 2 == 0 ? 1L : 2L});
    a.contacts[k].normal_force *= soft ? (k % 2 == 0 ? 0.1 : 0.02) : k % 2 == 0 ? 1 : 0.1;
    a.contacts[k].overlap *= soft ? 3 : 1;
    a.contacts[k].normal_force *= soft ? std::pow(3, 1.5) : 1;
  }
  const auto by_type = analysis::common_exponent(a, type);
  REQUIRE(by_type);
  CHECK(std::abs(by_type->value - 1.5) < 4 * by_type->standard_error);
  CHECK(by_type->standard_error < 1e-3);
  const auto all = analysis::common_exponent(a);
  REQUIRE(all);
  CHECK(all->standard_error > 20 * by_type->standard_error); // factors scatter by fifty
  CHECK_THROWS_AS((void)analysis::common_exponent(a, std::vector<long>{1, 2}), InvalidArgument);
  for (std::size_t k = 0; k < 10; ++k)
    a.contacts[k].normal_force *= 3; // viscous parts: far off, and left out
  const auto damped = analysis::common_exponent(a, type);
  CHECK(damped.value().standard_error < 1.1 * by_type->standard_error);
  CHECK(damped->value == doctest::Approx(by_type->value).epsilon(1e-4));
  a.contacts.resize(10);
  CHECK(analysis::common_exponent(a));
  a.contacts.pop_back();
  CHECK_FALSE(analysis::common_exponent(a));
  packing::Assembly alike = contacts_of(PowerLaw::sphere);
  for (packing::Contact& c : alike.contacts)
    c.overlap = 1e-7;
  CHECK_FALSE(analysis::common_exponent(alike));
}

TEST_CASE("law check: forces are of a linear spring within 0.1 %, if overlaps differ by 5 %") {
  const auto spring = [](double off, double range, std::size_t count) {
    packing::Assembly a = contacts_of(flat);
    a.contacts.resize(count);
    for (std::size_t k = 0; k < count; ++k) { // all but two tenths of the contacts at one end
      a.contacts[k].overlap = 1e-7 * (k % 5 == 0 ? range : 1);
      a.contacts[k].normal_force = 2e5 * a.contacts[k].overlap * (k % 5 == 1 ? 1 + off : 1);
    }
    const auto found = analysis::linear_spring(a);
    CHECK(found.value_or(2e5) == relative(2e5, 1e-14));
    return found ? 1 : 0;
  };
  check_threshold(1e-3, [&](double off) { return spring(off, 2, 100); });
  check_threshold(1e-3, [&](double off) { return spring(-off, 2, 100); });
  check_threshold(1.05, [&](double range) { return spring(0, range, 100); });
  CHECK(spring(0, 2, 10) == 1);
  CHECK(spring(0, 2, 9) == 0);
}

TEST_CASE("law check: the mean material of forces is the one that all have, or the mean of stiffnesses") {
  packing::Assembly a = contacts_of(PowerLaw::sphere, 0, 3);
  CHECK(analysis::mean_material_of_forces(a, 0.15)->shear_modulus == relative(30e9, 1e-12));
  // G/(1 - nu) is what forces tell
  CHECK(analysis::mean_material_of_forces(a, 0.3)->shear_modulus == relative(30e9 * 0.7 / 0.85, 1e-12));
  for (std::size_t k = 0; k < a.contacts.size(); k += 2)
    a.contacts[k].normal_force *= 8;
  CHECK(analysis::mean_material_of_forces(a, 0.15)->shear_modulus ==
        relative(30e9 * std::pow((1 + 4) / 2.0, 1.5), 1e-12));
  a.contacts.clear();
  CHECK_FALSE(analysis::mean_material_of_forces(a, 0.15));
}
