// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/measure.hpp>

#include <tuple>

#include <granum/contact/grains.hpp>
#include <granum/effective/relaxation.hpp>

#include "analysis/materials.hpp"
#include "lattices.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::analysis;
using namespace lattices;

TEST_CASE("measure: when moments are left by forces, and when their rest is a weight") {
  // Forces along y of contacts along x turn each grain and push none; one contact with more force pushes two.
  const auto turned = [](double moment, double more) {
    packing::Assembly a = cubic();
    for (packing::Contact& c : a.contacts)
      if (c.branch.x != 0)
        c.tangential_force.y = (c.branch.x > 0 ? 0.5 : -0.5) * moment * f_n;
    a.contacts[0].normal_force *= 1 + more;
    return a;
  };
  const auto left = [&](double moment, double more, double rounding) {
    const Given given{.law = law, .friction_coefficient = 0.5 * moment, .force_rounding = rounding};
    const Measurement m = measure(turned(moment, more), given, {.force_bins = 8});
    if (more == 0) {
      CHECK(m.forces->mean_tangential_over_normal.value() == relative(moment / 6, 1e-12));
      CHECK(m.forces->sliding_fraction.value() == relative(1.0 / 3, 1e-12));
    }
    return m.moments.empty() ? 1 : 0;
  };
  check_threshold(0.02, [&](double moment) { return left(moment, 0, 0); });
  check_threshold(0.03, [&](double moment) { return left(moment, 0, 0.01); });
  check_threshold(3 * unbalance(turned(0.11, 0.5)).force_ratio * (1 + 0.5 / 81), // over the mean force
                  [&](double moment) { return left(moment, 0.5, 0); });
  const auto weighs = [](double weight, double more) {
    packing::Assembly a = cubic();
    for (std::uint32_t g = 0; g < a.grain_count(); ++g)
      a.wall_contacts.push_back({.i = g, .branch = {0, 0, -R}, .normal_force = weight * f_n});
    a.contacts[0].normal_force *= 1 + more;
    const bool there = unbalance(a).force_ratio > 1e-3 && common_weight(a).left_over < 0.1;
    CHECK(measure_forces(a, {}, 8).weight.has_value() == there);
    return there;
  };
  int some = 0;
  for (int k = -20; k <= 20; ++k) {
    some += weighs(1e-3 * std::exp(0.02 * k), 0);
    some += weighs(0.1, 0.13 * std::exp(0.02 * k));
  }
  CHECK((some > 20 && some < 62));
}

TEST_CASE("measure: rounding above 1 % of the overlaps leaves stiffnesses to the forces, springs of turning "
          "are given") {
  packing::Assembly packing = cubic();
  for (packing::Contact& c : packing.contacts)
    c.normal_stiffness = c.tangential_stiffness = 0;
  check_threshold(0.01, [&](double rounded) {
    Given given = own;
    given.overlap_rounding = rounded * (2 * R - edge);
    const double k = stiffened(packing, given).contacts[0].normal_stiffness;
    return k == relative(law.stiffness_at_force(f_n), 1e-12)              ? 1
           : k == relative(law.stiffness_at_overlap(2 * R - edge), 1e-12) ? 0
                                                                          : 9;
  });
  Given turning = own;
  const auto springs = [&] {
    const packing::Contact c = stiffened(packing, turning).contacts[0];
    return std::pair(c.rolling_stiffness > 0, c.twisting_stiffness > 0);
  };
  CHECK(springs() == std::pair(false, false));
  turning.twisting = packing::TurningSpring{0.1};
  CHECK(springs() == std::pair(false, true));
  std::swap(turning.rolling, turning.twisting);
  CHECK(springs() == std::pair(true, false));
}

TEST_CASE("measure: forces linear in overlaps are springs where no law was requested") {
  packing::Assembly packing = cubic();
  for (std::size_t k = 0; k < packing.contacts.size(); ++k) {
    packing::Contact& c = packing.contacts[k];
    c.overlap = (2 * R - edge) * (1 + 0.01 * static_cast<double>(k));
    c.normal_force = k_n * c.overlap;
    c.normal_stiffness = c.tangential_stiffness = 0;
  }
  Given given{.law_assumed = true};
  const Measurement m = measure(packing, given, {.law_check = true});
  CHECK(m.law.value().stiffness_at_force(f_n) == relative(k_n, 1e-12));
  CHECK((m.law_check.value().coefficient_ratio == relative(1, 1e-12) && m.law_check->worst_misfit < 1e-12));
  CHECK_FALSE(m.grain);
  CHECK_FALSE(measure(packing, given).law_check);
  CHECK(stiffened(packing, given).contacts[7].normal_stiffness == relative(k_n, 1e-12));
  given.normal_forces = false;
  CHECK_FALSE(measure(packing, given).law);
  CHECK_FALSE(measure(packing, {}).law);
  given = {.grain_shear_modulus = 30e9, .law_assumed = true};
  CHECK(measure(packing, given).law->stiffness_at_force(f_n) == relative(law.stiffness_at_force(f_n), 1e-12));
  // Grains of several materials are compared with their own law.
  given = {.law_assumed = true, .materials = std::vector(27, contact::GrainMaterial{30e9, 0.15})};
  CHECK_FALSE(measure(packing, given).law_check);
  CHECK(measure(packing, given, {.law_check = true}).law_check.value().force_exponent->value ==
        relative(1, 1e-9));
  given.normal_forces = false;
  CHECK_FALSE(measure(packing, given, {.law_check = true}).law_check);
}

TEST_CASE("measure: from how clear an exponent contacts are Hertz' though their factors differ") {
  packing::Assembly packing = cubic();
  Given given{.type = std::vector<long>(27, 1)};
  std::fill_n(given.type.begin() + 9, 9, 2); // the factor of their contacts is twice as large
  int some = 0;
  const auto compare = [&](double exponent, double noise) {
    for (std::size_t k = 0; k < packing.contacts.size(); ++k) {
      packing::Contact& c = packing.contacts[k];
      c.normal_stiffness = c.tangential_stiffness = 0;
      c.overlap = (2 * R - edge) * (1 + 0.01 * static_cast<double>(k));
      c.normal_force = 1e8 * (given.type[c.i] + given.type[c.j] == 4 ? 2 : 1) *
                       std::pow(c.overlap, exponent) * (1 + noise * (k % 2 == 0 ? 1 : -1));
    }
    const Measured found = common_exponent(packing, given.type).value();
    const bool hertz =
        found.standard_error <= 0.02 && std::abs(found.value - 1.5) <= 2 * found.standard_error + 1e-4;
    const Measurement m = measure(packing, given);
    CHECK((m.grain.has_value() == hertz && m.notes.size() == 1));
    some += hertz;
    if (hertz) {
      CHECK(*m.grain == mean_material_of_forces(packing, 0.15));
      const packing::Contact c = stiffened(packing, given).contacts[7];
      CHECK(c.normal_stiffness == relative(1.5 * c.normal_force / c.overlap, 1e-12));
    }
  };
  for (int k = -15; k <= 15; ++k) {
    const double times = std::exp(0.02 * k);
    compare(1.5, 0.035 * times);
    compare(1.5 + 1e-4 * times, 0);
    compare(1.5 + 0.02 * times, 0.018);
  }
  CHECK((some > 20 && some < 73));
}

TEST_CASE("measure: grains of several materials weigh as their contacts' lengths squared") {
  packing::Assembly packing = row();
  packing.radius[2] = 2 * R;
  packing.contacts[1].normal_force = -f_n;
  const std::vector<contact::GrainMaterial> materials{{30e9, 0.15}, {10e9, 0.3}, {20e9, 0.2}};
  const auto first = contact::pair_material(materials[0], materials[1]),
             second = contact::pair_material(materials[1], materials[2]);
  const effective::MixedContacts mixed = mixed_contacts(packing, materials),
                                 by_hand = effective::mixed_contacts(
                                     std::vector<effective::MaterialPair>{
                                         {.material = first, .weight = 4 * R * R, .force = f_n},
                                         {.material = second, .weight = 9 * R * R, .force = 0}},
                                     1.0 / 3);
  CHECK(mixed.mean.shear_modulus == relative(by_hand.mean.shear_modulus, 1e-12));
  CHECK(mixed.mean.poisson_ratio == relative(by_hand.mean.poisson_ratio, 1e-12));
  CHECK(relative_stiffnesses(packing, materials, mixed.mean)[1] ==
        relative(effective::relative_stiffness(second, mixed.mean, 1.0 / 3), 1e-12));
}

TEST_CASE("measure: the errors of rung 3 grow as those of z* do, the fewer grains an interior has") {
  packing::Assembly many = cubic(); // z* = 6, in each part too
  const Given given{.law = law};
  const auto errors = [&](double from, double to) {
    Wanted wanted{.closed_forms = true};
    if (to > 0)
      wanted.window = Window{.low = {from, from, from}, .high = {to, to, to}};
    const Measurement found = measure(many, given, wanted);
    return std::tuple(found.interior ? found.interior->grains : 27,
                      found.closed_form(effective::RungName::relaxed)->relative_error.value(), *found.state);
  };
  const auto [all, of_all, state] = errors(0, 0);
  const auto [whole, of_whole, same] = errors(-0.5 * edge, 2.5 * edge);
  const auto [few, of_few, part] = errors(-0.5 * edge, 1.5 * edge);
  REQUIRE((all == 27 && whole == 27 && few == 8));
  CHECK(of_whole.G_vh == relative(of_all.G_vh, 1e-9));
  const auto at = [&, whole_state = effective::State(state)](double z) {
    effective::State other = whole_state;
    other.coordination_number = z;
    return effective::relaxed(other, z).stiffness;
  };
  const auto added = [&](auto modulus, double few_error, double all_error) {
    const double slope = (std::log(modulus(6.01)) - std::log(modulus(5.99))) / 0.02;
    CHECK(few_error * few_error - all_error * all_error ==
          relative((std::pow(1.5 * slope, 2) + 0.64) * (1.0 / 8 - 1.0 / 27), 1e-3));
  };
  added([&](double z) { return at(z).G_vh(); }, of_few.G_vh, of_all.G_vh);
  added([&](double z) { return at(z).G_hh(); }, of_few.G_hh, of_all.G_hh);
  added([&](double z) { return at(z).bulk_modulus(); }, of_few.bulk_modulus, of_all.bulk_modulus);
}

TEST_CASE("measure: from how clear forces the material follows, and what is said of rolling stiffness") {
  const auto part = [](std::size_t k) { return static_cast<double>(k % 3) - 1; }; // -1, 0 and 1
  packing::Assembly packing = cubic();
  const Given cones{.law_family = [](const contact::GrainMaterial& grain, double) {
    return contact::NormalLaw(contact::PowerLaw::cone(grain, 0.4));
  }};
  const auto clear = [&](double off, double rounded, std::size_t count = 81) {
    packing = cubic();
    packing.contacts.resize(count);
    for (std::size_t k = 0; k < count; ++k) { // of the forces of two thirds
      packing::Contact& c = packing.contacts[k];
      c.overlap = (2 * R - edge) * (1 + 0.01 * static_cast<double>(k));
      c.normal_force = contact::PowerLaw::cone({30e9, 0.15}, 0.4).force(c.overlap) * (1 + off * part(k));
    }
    Given given = cones;
    given.overlap_rounding = rounded * 1.4 * (2 * R - edge); // of the median
    return measure(packing, given).grain.has_value() ? 1 : 0;
  };
  check_threshold(0.01, [&](double off) { return clear(off, 0); });
  check_threshold(0.01 + 1.5 * 0.05, [&](double off) { return clear(off, 0.05); });
  check_threshold(0.1, [&](double rounded) { return clear(0, rounded); });
  CHECK((clear(0, 0, 10) == 1 && clear(0, 0, 9) == 0));
  const auto rolled = [&](double ratio, double deviation) {
    packing::Assembly rolling = cubic();
    rolling.radius[5] *= 1.5;
    for (std::size_t k = 0; k < rolling.contacts.size(); ++k) {
      packing::Contact& c = rolling.contacts[k];
      c.rolling_stiffness = k_n * std::pow(1 / (1 / rolling.radius[c.i] + 1 / rolling.radius[c.j]), 2) *
                            ratio * (1 + std::sqrt(1.5) * deviation * part(k));
    }
    return measure(rolling, own, {.closed_forms = true});
  };
  const auto notes = [&](double ratio, double deviation, const char* words) {
    const std::vector<std::string> all = rolled(ratio, deviation).notes;
    return std::count_if(all.begin(), all.end(),
                         [&](const std::string& note) { return note.find(words) != std::string::npos; });
  };
  check_threshold(0.05, [&](double x) { return notes(0.1, x, "%"); });
  CHECK(notes(0.1, 0.8, " 79 %") == 1);
  check_threshold(1, [&](double x) { return notes(x, 0, "up to 1"); });
  for (const double k_r : {0.3, 1 + 5e-10, 1.01}) { // known up to 1, but for rounding

    const Measurement m = rolled(k_r, 0);
    CHECK(m.state.value().rolling == doctest::Approx(k_r > 1.001 ? 0 : k_r).epsilon(1e-9));
    CHECK(m.closed_form(effective::RungName::relaxed).has_value() == (k_r < 1.001));
  }
}

TEST_CASE(
    "measure: types of grains differ by their factors of forces from 2 % on, of five contacts or more") {
  packing::Assembly packing = cubic();
  std::vector<long> type(27, 1);
  for (std::size_t g = 9; g < 18; ++g)
    type[g] = 2; // nine contacts among these layers of a plane, and nine to either side
  const auto differ = [&](double factor, std::size_t few) {
    std::size_t between = 0;
    for (packing::Contact& c : packing.contacts) {
      c.normal_force = law.force(c.overlap);
      if (type[c.i] == 2 && type[c.j] == 2)
        c.normal_force *= ++between <= few ? factor : 0;
    }
    return analysis::factors_differ(packing, type) ? 1 : 0;
  };
  check_threshold(1.02, [&](double factor) { return differ(factor, 18); });
  check_threshold(1 / 1.02, [&](double factor) { return differ(factor, 18); });
  CHECK(differ(2, 5) == 1);
  CHECK(differ(2, 4) == 0);
}
