// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of a sand against states that were measured, and against the laws that it is made of.
#include <granum/estimate/answer.hpp>

#include <granum/contact/grains.hpp>
#include <granum/contact/power_law.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/slip.hpp>
#include <granum/elastic/waves.hpp>

#include "unit.hpp"

using estimate::Field;
using estimate::Range;

namespace {

estimate::Question quartz(double e, double stress_v, double stress_h, const sands::Sand& sand = {}) {
  const contact::GrainMaterial grain = contact::mineral("quartz").material;
  return {.state = {.law = contact::PowerLaw::sphere(grain, 0.2e-3),
                    .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                    .radius = 0.2e-3,
                    .void_ratio = e,
                    .stress_v = stress_v,
                    .stress_h = stress_h},
          .grain_density = 2650,
          .grain_shape = estimate::GrainShape::sand,
          .sand = sand};
}

Range field(const estimate::Question& q, Field wanted) { return estimate::answer(q)[wanted]; }

} // namespace

TEST_CASE("a sand: rolling resistance of the model of spheres changes none of its numbers") {
  for (const std::optional<double> strain : {std::optional<double>(), std::optional(1e-4)}) {
    estimate::Question q = quartz(0.7, 1e5, 0.6e5);
    q.shear_strain = strain;
    const estimate::Answer free = estimate::answer(q);
    q.state.rolling = 0.5;
    const estimate::Answer held = estimate::answer(q);
    for (const estimate::FieldRow& row : estimate::fields())
      if (const auto value = free.find(row.field)) {
        CAPTURE(row.key);
        CHECK(held.find(row.field).value().value == value->value);
        CHECK(held.find(row.field).value().high == value->high);
      }
  }
}

// The rows of tests/sands/data/sand_states.csv; forecasts are in tests/inverse.
TEST_CASE("a sand: measured states agree with the table of states") {
  const auto holds = [](const Range& range, double measured, double deviations) {
    const double off = std::log(measured / range.value);
    const double one = off > 0 ? std::log(range.high / range.value) : std::log(range.value / range.low);
    return std::abs(off) <= deviations * one;
  };
  const Range toyoura =
      field(quartz(0.801, 1e5, 1e5, {.tests = sands::known_sand("toyoura").tests}), Field::shear_modulus);
  CHECK(std::abs(std::log(98e6 / toyoura.value)) < std::log(1.15));
  CHECK(toyoura.high / toyoura.low <= 1.4);
  const Range unnamed = field(quartz(0.801, 1e5, 1e5, {.uniformity = 1.39}), Field::shear_modulus);
  CHECK(holds(unnamed, 98e6, 1));
  CHECK(unnamed.high / unnamed.low > 1.5);
  CHECK(unnamed.high / unnamed.low < 2);
  const Range hostun = field(quartz(0.659, 2e5, 2e5, {.uniformity = 1.40}), Field::shear_modulus);
  CHECK(std::abs(std::log(134.4e6 / hostun.value)) < std::log(1.2));
  CHECK(holds(hostun, 134.4e6, 1));
  CHECK(holds(field(quartz(0.594, 1e5, 1e5, {.uniformity = 1.46}), Field::shear_modulus), 90e6, 2));
  const Range graded = field(quartz(0.443, 1e5, 1e5, {.uniformity = 8}), Field::shear_modulus);
  CHECK(std::abs(std::log(114.3e6 / graded.value)) < std::log(1.2));
  // Poisson's ratio of dry sand at 10.34 MPa, below that at 100 kPa.
  const Range nu = field(quartz(0.61, 10.34e6, 10.34e6), Field::poisson_ratio);
  CHECK(std::abs(nu.value - 0.082) < 0.06);
  CHECK(nu.value < field(quartz(0.61, 1e5, 1e5), Field::poisson_ratio).value);
  // V_p grows as p^0.23 (+- 0.04), more slowly than V_s.
  const auto slope = [](Field speed) {
    return std::log(field(quartz(0.6, 2e6, 2e6), speed).value / field(quartz(0.6, 2e5, 2e5), speed).value) /
           std::log(10.0);
  };
  CHECK(std::abs(slope(Field::compression_wave_speed) - 0.23) < 0.04);
  CHECK(slope(Field::compression_wave_speed) < slope(Field::shear_wave_speed));
  // G/G0 at 0.01 %.
  estimate::Question strained = quartz(0.7, 1e5, 1e5, {.uniformity = 1.5});
  strained.shear_strain = 1e-4;
  const Range ratio = field(strained, Field::modulus_ratio);
  CHECK(ratio.low < 0.76);
  CHECK(ratio.high > 0.83); // the median of eight published curves
}

TEST_CASE("a sand: G equals the pooled law to the bit, the moduli are consistent, PM4Sand gives G back") {
  const sands::Sand sand{.uniformity = 2};
  const estimate::Answer a = estimate::answer(quartz(0.6, 3e5, 3e5, sand));
  CHECK(a[Field::shear_modulus].value == sands::pooled_shear_modulus(sand, 0.6, 3e5));
  const double G = a[Field::shear_modulus].value, nu = a[Field::poisson_ratio].value;
  CHECK(a[Field::young_modulus].value == relative(2 * G * (1 + nu), 1e-14));
  CHECK(a[Field::bulk_modulus].value == relative(2 * G * (1 + nu) / (3 * (1 - 2 * nu)), 1e-14));
  const double rho = 2650 / 1.6;
  CHECK(a[Field::shear_wave_speed].value == relative(std::sqrt(G / rho), 1e-14));
  CHECK(a[Field::compression_wave_speed].value ==
        relative(std::sqrt(2 * G * (1 - nu) / (1 - 2 * nu) / rho), 1e-14));
  CHECK_FALSE(a.find(Field::coordination_number));
  CHECK_FALSE(a.find(Field::modulus_ratio));
  const estimate::Answer answer = estimate::answer(quartz(0.7, 2e5, 1e5));
  const double p = 4e5 / 3, p_atm = 101.3e3;
  CHECK(answer[Field::pm4sand_coefficient].value * p_atm * std::sqrt(p / p_atm) ==
        relative(answer[Field::shear_modulus].value, 1e-13));
}

TEST_CASE("a sand: under unequal stresses each number is its law at the stress it follows, moved by its "
          "deviation") {
  const sands::Sand sand{.uniformity = 2};
  estimate::Question q = quartz(0.65, 3e5, 1.5e5, sand);
  const estimate::Answer a = estimate::answer(q);
  const auto G = [&](double stress) { return sands::pooled_shear_modulus(sand, 0.65, stress); };
  const auto nu = sands::poisson_ratio(sand, 2e5);
  const double by_young = 2 * (1 + nu.value), K = G(2e5) * by_young / (3 * (1 - 2 * nu.value)),
               rho = 2650 / 1.65;
  const auto oedometric = [&](double stress) { return G(stress) * 2 * (1 - nu.value) / (1 - 2 * nu.value); };
  const double G_vh = G(std::pow(3e5, sands::vertical_share) * std::pow(1.5e5, sands::horizontal_share)),
               G_hh = sands::shear_anisotropy * G(1.5e5), E_h = sands::young_anisotropy * by_young * G(1.5e5);
  for (const auto& row : {std::pair(Field::shear_modulus, G_vh),
                          {Field::horizontal_shear_modulus, G_hh},
                          {Field::bulk_modulus, K},
                          {Field::young_modulus, by_young * G(3e5)},
                          {Field::horizontal_young_modulus, E_h},
                          {Field::horizontal_shear_wave_speed, std::sqrt(G_hh / rho)},
                          {Field::compression_wave_speed, std::sqrt(oedometric(3e5) / rho)},
                          {Field::horizontal_compression_wave_speed, std::sqrt(oedometric(1.5e5) / rho)}}) {
    CAPTURE(estimate::row_of(row.first).key);
    CHECK(a[row.first].value == relative(row.second, 1e-12));
  }
  const double s = a[Field::stress_exponent].value, share = sands::share_deviation,
               s_error = sands::growth_exponent(sand, 2e5).deviation,
               factor = sands::stated_factor(sand, 0.65, 2e5);
  struct Move {
    const char* input;
    Field field;
    double low, high;
  };
  for (const auto& [input, of, low, high] :
       {Move{"sand to sand", Field::shear_modulus, G_vh / factor, G_vh * factor},
        Move{"Poisson's ratio", Field::poisson_ratio, nu.value - nu.deviation, nu.value + nu.deviation},
        Move{"exponent", Field::stress_exponent, s - s_error, s + s_error},
        Move{"anisotropy", Field::horizontal_shear_modulus,
             G_hh * (1 - sands::shear_anisotropy_deviation / sands::shear_anisotropy),
             G_hh * (1 + sands::shear_anisotropy_deviation / sands::shear_anisotropy)},
        Move{"anisotropy", Field::horizontal_young_modulus,
             E_h * (1 - sands::young_anisotropy_deviation / sands::young_anisotropy),
             E_h * (1 + sands::young_anisotropy_deviation / sands::young_anisotropy)}}) {
    int found = 0;
    const auto k = static_cast<std::size_t>(of);
    for (const estimate::Effect& effect : a.effects())
      if (effect.input == input && effect.high[k] > effect.low[k] * (1 + 1e-12)) {
        ++found;
        CHECK(effect.low[k] == relative(low, 1e-12));
        CHECK(effect.high[k] == relative(high, 1e-12));
      }
    CHECK(found == 1);
  }
  const auto m = static_cast<std::size_t>(Field::horizontal_exponent),
             n = static_cast<std::size_t>(Field::vertical_exponent);
  const estimate::Effect& of_share = a.effects()[3];
  CHECK(of_share.high[m] - of_share.low[m] == relative(2 * share * s, 1e-12));
  CHECK(of_share.high[n] - of_share.low[n] == relative(2 * share * s, 1e-12));
  // In water the skeleton has the same K, and the moduli of its waves.
  const elastic::TransverselyIsotropic skeleton{
      .C11 = oedometric(1.5e5),
      .C33 = oedometric(3e5),
      .C12 = oedometric(1.5e5) - 2 * G_hh,
      .C13 = (9 * K - 4 * oedometric(1.5e5) - oedometric(3e5) + 4 * G_hh) / 4,
      .C44 = G_vh};
  CHECK(skeleton.bulk_modulus() == relative(K, 1e-12));
  q.saturation = 1;
  const elastic::TransverselyIsotropic wet =
      elastic::saturated(skeleton, {.grain_bulk_modulus = contact::bulk_modulus(q.state.law.grain()),
                                    .fluid_bulk_modulus = elastic::water_and_air_bulk_modulus(1),
                                    .void_ratio = 0.65});
  const double wet_rho = rho + elastic::water_density * 0.65 / 1.65;
  CHECK(field(q, Field::compression_wave_speed).value == relative(std::sqrt(wet.C33 / wet_rho), 1e-12));
  CHECK(field(q, Field::horizontal_compression_wave_speed).value ==
        relative(std::sqrt(wet.C11 / wet_rho), 1e-12));
}

TEST_CASE("a sand: a Poisson's ratio that no contacts have gives the fewest or the most, and it is from 0 to "
          "0.45") {
  const auto with = [](double shift) {
    estimate::Question q = quartz(0.65, 2e5, 2e5);
    q.sand.poisson_shift = shift;
    return estimate::answer(q);
  };
  CHECK(with(-1)[Field::mechanical_coordination_number].value == 12);
  CHECK(with(1)[Field::poisson_ratio].value == 0.45);
  CHECK(with(-1)[Field::poisson_ratio].value == 0);
}

TEST_CASE("a sand: rung 3 at the inferred contacts has this Poisson's ratio and, with the softness, this G") {
  const estimate::Question q = quartz(0.65, 2e5, 2e5);
  const estimate::Answer a = estimate::answer(q);
  const double z = a[Field::mechanical_coordination_number].value;
  effective::State spheres = q.state;
  spheres.coordination_number = spheres.mechanical_coordination_number = z;
  const auto c = effective::relaxed(spheres, z).stiffness;
  CHECK(c.nu_vh() == relative(a[Field::poisson_ratio].value, 1e-8));
  CHECK(c.G_vh() * a[Field::contact_softness].value == relative(a[Field::shear_modulus].value, 1e-12));
  // Many contacts that are soft, or few: the range says that neither is known alone.
  CHECK(a[Field::contact_softness].high / a[Field::contact_softness].low > 1.5);
}

TEST_CASE("a sand: inferred contacts are those of equal spheres for any grain sizes") {
  estimate::Question q = quartz(0.65, 2e5, 2e5);
  q.shear_strain = 1e-4;
  const estimate::Answer equal = estimate::answer(q);
  q.state.contacts = {.branch = 1.06, .branch_square = 1.16, .pair_radius = 1.08, .grain_volume = 1.17};
  q.state.law = q.state.law.of_pair_radius(1.08);
  const estimate::Answer graded = estimate::answer(q);
  for (const Field field :
       {Field::mechanical_coordination_number, Field::contact_softness, Field::slip_strain})
    CHECK(graded[field].value == relative(equal[field].value, 1e-9));
}

TEST_CASE("a sand: slip takes 1 % of G at some 1e-5, later under more stress, and more in stiffer contacts") {
  estimate::Question q = quartz(0.65, 1e5, 1e5);
  q.shear_strain = 1e-4;
  const estimate::Answer a = estimate::answer(q);
  const double z = a[Field::mechanical_coordination_number].value;
  effective::State spheres = q.state;
  spheres.coordination_number = spheres.mechanical_coordination_number = z;
  const effective::SlipOnset onset = effective::slip_onset(spheres, z, 0.5);
  const double strain = a[Field::slip_strain].value * a[Field::contact_softness].value; // of smooth spheres
  CHECK(effective::slip_loss(onset, strain, effective::ContactSlip::partial) == relative(0.01, 1e-9));
  CHECK(a[Field::slip_strain].value > 5e-6);
  CHECK(a[Field::slip_strain].value < 3e-5);
  CHECK(a[Field::slip_strain].low < a[Field::slip_strain].value);
  CHECK(a[Field::modulus_ratio].value < 1);
  q.state.stress_v = q.state.stress_h = 4e5;
  CHECK(field(q, Field::slip_strain).value > 1.5 * a[Field::slip_strain].value);
  q.shear_strain.reset();
  CHECK_FALSE(estimate::answer(q).find(Field::slip_strain));
}

TEST_CASE("a sand: exponents are the slopes of G_vh by each stress") {
  const auto G = [](double v, double h) { return field(quartz(0.6, v, h), Field::shear_modulus).value; };
  const estimate::Answer a = estimate::answer(quartz(0.6, 3e5, 1.5e5));
  const double step = 1e-4, up = std::exp(step), down = std::exp(-step);
  CHECK(std::log(G(3e5 * up, 1.5e5) / G(3e5 * down, 1.5e5)) / (2 * step) ==
        relative(a[Field::vertical_exponent].value, 1e-7));
  CHECK(std::log(G(3e5, 1.5e5 * up) / G(3e5, 1.5e5 * down)) / (2 * step) ==
        relative(a[Field::horizontal_exponent].value, 1e-7));
  CHECK(a[Field::vertical_exponent].value + a[Field::horizontal_exponent].value ==
        relative(a[Field::stress_exponent].value, 1e-14));
  CHECK(a[Field::shear_modulus].value > a[Field::horizontal_shear_modulus].value / 1.2);
  const estimate::Answer equal = estimate::answer(quartz(0.6, 3e5, 3e5));
  CHECK(equal[Field::horizontal_shear_modulus].value ==
        relative(1.1 * equal[Field::shear_modulus].value, 1e-14));
}

TEST_CASE("a sand: saturated, V_p is that of water, and V_s changes by the density only") {
  estimate::Question q = quartz(0.6, 1e5, 1e5);
  const double dry = field(q, Field::shear_wave_speed).value;
  q.saturation = 1;
  CHECK(field(q, Field::compression_wave_speed).value > 1500);
  CHECK(field(q, Field::compression_wave_speed).value < 1900);
  CHECK(field(q, Field::shear_wave_speed).value < dry);
}

TEST_CASE("a sand: without stress no stiffness, no exponents, no inferred contacts") {
  estimate::Question q = quartz(0.6, 0, 0);
  q.shear_strain = 1e-4;
  const estimate::Answer a = estimate::answer(q);
  CHECK(a[Field::shear_modulus] == Range{0, 0, 0});
  for (const Field none : {Field::stress_exponent, Field::mechanical_coordination_number,
                           Field::contact_softness, Field::modulus_ratio})
    CHECK_FALSE(a.find(none));
}

TEST_CASE("the range of spheres beyond their calibration includes measured values, without a jump, or they "
          "are refused") {
  const auto spheres = [](double e) {
    estimate::Question q = quartz(e, 1e5, 1e5);
    q.grain_shape = estimate::GrainShape::sphere;
    return q;
  };
  for (const double e : {0.82, 0.9}) {
    const Range G = field(spheres(e), Field::shear_modulus);
    CHECK(G.high >= sands::pooled_shear_modulus({}, e, 1e5));
  }
  CHECK(field(spheres(0.44), Field::shear_modulus).low <= sands::pooled_shear_modulus({}, 0.44, 1e5));
  CHECK(field(spheres(0.75), Field::shear_modulus).high ==
        relative(field(spheres(0.7500001), Field::shear_modulus).high, 1e-4));
  estimate::Question graded = spheres(0.6);
  graded.sand.uniformity = 10;
  CHECK_THROWS_AS((void)estimate::answer(graded), InvalidArgument);
  estimate::Question strained = spheres(0.6);
  strained.shear_strain = 1e-4;
  CHECK_THROWS_AS((void)estimate::answer(strained), InvalidArgument);
}
