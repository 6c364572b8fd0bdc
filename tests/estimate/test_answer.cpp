// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/answer.hpp>

#include <granum/effective/relaxation.hpp>
#include <granum/sands/pooled_law.hpp>

#include "estimate/parts.hpp"
#include "questions.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::Preparation;
using estimate::Answer;
using estimate::Field;
using estimate::Question;
using estimate::Range;
using estimate::Spread;

namespace {

/// Glass beads in the laboratory: R 0.5 mm, 26 GPa, nu 0.22, e 0.58, 100 kPa.
Question beads(double void_ratio = 0.58, double pressure = 1e5) {
  return {.state = {.law = contact::PowerLaw::sphere({.shear_modulus = 26e9, .poisson_ratio = 0.22}, 5e-4),
                    .tangential_ratio = contact::mindlin_stiffness_ratio(0.22),
                    .radius = 5e-4,
                    .void_ratio = void_ratio,
                    .stress_v = pressure,
                    .stress_h = pressure},
          .grain_density = 2480};
}

bool holds(const Range& range, double low, double high) { return range.low <= low && high <= range.high; }

/// The width of the range of G in logarithms.
double width(const Question& q) {
  const Range G = estimate::answer(q)[Field::shear_modulus];
  return std::log(G.high / G.low);
}

Question with_grain(Question q, double shear_modulus) {
  q.state.law = q.state.law.of_grain({shear_modulus, q.state.law.grain().poisson_ratio});
  return q;
}

} // namespace

TEST_CASE("answer: glass beads without further inputs are within a factor of 3.2, and include 150 MPa") {
  const Answer a = estimate::answer(beads());
  CHECK(holds(a[Field::shear_modulus], 150e6, 187e6)); // dense packings are the upper end
  CHECK(width(beads()) <= std::log(3.2));
  CHECK(a.validity().ok());
  for (const estimate::FieldRow& row : estimate::fields())
    if (const std::optional<Range>& range = a.find(row.field)) {
      INFO(row.key);
      CHECK(range->low > 0);
    }
  for (const Field of_sands : {Field::modulus_ratio, Field::strained_shear_modulus, Field::damping_ratio,
                               Field::slip_strain, Field::pm4sand_coefficient})
    CHECK(!a.find(of_sands));
}

TEST_CASE("answer: counted contacts give rung 3, with only its standard error") {
  Question q = beads();
  q.state.mechanical_coordination_number = 5.2;
  q.rattler_fraction = 0.03;
  effective::State s = q.state;
  s.coordination_number = 5.2 * 0.97;
  const auto rung3 = effective::relaxed(s, 5.2);
  const Answer a = estimate::answer(q);
  CHECK(a[Field::shear_modulus].value == rung3.stiffness.C44);
  CHECK(a[Field::bulk_modulus].value == rung3.stiffness.bulk_modulus());
  const auto upper = [&](Field field) { return a[field].high / a[field].value - 1; };
  CHECK(close(upper(Field::shear_modulus), rung3.relative_error.G_vh, 1e-7));
  CHECK(close(upper(Field::bulk_modulus), rung3.relative_error.bulk_modulus, 1e-7));
  const auto lower = [&](Field field) { return 1 - a[field].low / a[field].value; };
  CHECK(close(lower(Field::shear_modulus), rung3.relative_error.G_vh, 1e-7));
  CHECK(close(lower(Field::bulk_modulus), rung3.relative_error.bulk_modulus, 1e-7));
  for (const Field exponent :
       {Field::stress_exponent, Field::vertical_exponent, Field::horizontal_exponent}) {
    const double error = 0.03 * a[exponent].value / a[Field::stress_exponent].value;
    CHECK(a[exponent].high - a[exponent].value == relative(error, 1e-9));
    CHECK(a[exponent].value - a[exponent].low == relative(error, 1e-9));
  }
  REQUIRE(a.shares().front().input == "rung 3");
  CHECK(a.shares().front().share == 1);
  // The same by C_n and z*, and by C_n and rattlers.
  Question with_z = beads();
  with_z.state.coordination_number = 5.2 * 0.97;
  Question with_rattlers = with_z;
  with_z.state.mechanical_coordination_number = 5.2;
  with_rattlers.rattler_fraction = 0.03;
  for (const Question& same : {with_z, with_rattlers})
    CHECK(close(estimate::answer(same)[Field::shear_modulus].value, a[Field::shear_modulus].value, 1e-12));
}

TEST_CASE("answer: isotropic moduli obey their identities, speeds their definitions") {
  const Answer a = estimate::answer(beads());
  const double K = a[Field::bulk_modulus].value, G = a[Field::shear_modulus].value, rho = 2480 / 1.58;
  CHECK(close(a[Field::young_modulus].value, 9 * K * G / (3 * K + G), 1e-12));
  CHECK(close(a[Field::poisson_ratio].value, (3 * K - 2 * G) / (2 * (3 * K + G)), 1e-12));
  CHECK(close(a[Field::horizontal_shear_modulus].value, G, 1e-12));
  CHECK(close(a[Field::bulk_density].value, rho, 1e-14));
  CHECK(close(a[Field::shear_wave_speed].value, std::sqrt(G / rho), 1e-14));
  CHECK(close(a[Field::compression_wave_speed].value, std::sqrt((K + 4 * G / 3) / rho), 1e-12));
  CHECK(close(a[Field::horizontal_compression_wave_speed].value, a[Field::compression_wave_speed].value,
              1e-12));
  Question weightless = beads();
  weightless.grain_density.reset();
  CHECK(!estimate::answer(weightless).find(Field::shear_wave_speed));
  CHECK(estimate::answer(weightless)[Field::shear_modulus].value == G);
}

TEST_CASE("answer: each known input narrows the range") {
  using Kind = Preparation::Kind;
  using Change = void (*)(Question&);
  const std::pair<double, Change> rows[] = {
      {0.3, [](Question& q) { q.preparation = {.kind = Kind::dense}; }},
      {0.7, [](Question& q) { q.preparation = {.kind = Kind::loose}; }},
      {0.5, [](Question& q) { q.preparation = {.kind = Kind::friction, .friction_coefficient = 0.2}; }},
      {0.2, [](Question& q) { q.state.mechanical_coordination_number = 5.0; }},
      {0.3, [](Question& q) { q.state.coordination_number = 4.9; }},
      {0.6, [](Question& q) { q.rattler_fraction = 0.03; }}};
  for (const auto& [most, change] : rows) {
    Question q = beads();
    change(q);
    CHECK(width(q) < most * width(beads()));
    if (q.rattler_fraction)
      CHECK(estimate::answer(q)[Field::rattler_fraction].value == 0.03);
  }
}

TEST_CASE(
    "answer: a given C_n and a given z* are reported unchanged, even if no rattler fraction fits them") {
  for (const double z : {5.0, 6.1, 7.3}) {
    Question q = beads();
    q.state.coordination_number = 6.1;
    q.state.mechanical_coordination_number = z;
    const Answer a = estimate::answer(q);
    CHECK(a[Field::coordination_number].value == 6.1);
    CHECK(a[Field::rattler_fraction].value == std::max(0.0, 1 - 6.1 / z));
    CHECK(a[Field::mechanical_coordination_number].value == z);
    CHECK(a[Field::shear_modulus].value == effective::relaxed(q.state, z).stiffness.G_vh());
  }
}

TEST_CASE("answer: at one rattler fraction looser is never stiffer, also where no packing of spheres is so "
          "loose") {
  for (const double rattlers : {0.001, 0.013, 0.05, 0.2}) {
    double before = std::numeric_limits<double>::infinity();
    for (double e = 0.4; e < 1.3; e += 0.01) {
      Question q = grains_of(2, 0, 150e3, 150e3);
      q.state.void_ratio = e;
      q.rattler_fraction = rattlers;
      const estimate::Answer answer = estimate::answer(q);
      const estimate::Range G = answer[Field::shear_modulus];
      CAPTURE(e);
      CAPTURE(rattlers);
      REQUIRE(G.value <= before * (1 + 1e-9));
      REQUIRE(G.low <= G.value);
      REQUIRE(G.value <= G.high);
      before = G.value;
    }
  }
}

TEST_CASE("answer: the effect of an uncertain input is added in quadrature") {
  Question q = beads();
  q.state.mechanical_coordination_number = 5.2;
  q.rattler_fraction = 0.03;
  const Range exact = estimate::answer(q)[Field::shear_modulus];
  const Spread modulus{
      .input = "grain modulus", .less = with_grain(q, 0.8 * 26e9), .more = with_grain(q, 1.25 * 26e9)};
  const Answer a = estimate::answer(q, std::span(&modulus, 1));
  // G ~ G_g^(2/3) at given contacts, and overlaps shorten the branches of stiff grains less
  const auto branches = [](Question at) {
    at.state.coordination_number = 5.2 * (1 - 0.03);
    return shortened(at.state);
  };
  const double rung = std::log(exact.high / exact.value),
               grain = std::log(std::cbrt(1.25 * 1.25) * branches(modulus.more) / branches(q));
  CHECK(close(std::log(a[Field::shear_modulus].high / a[Field::shear_modulus].value), std::hypot(rung, grain),
              1e-9));
  CHECK(a.shares().front().input == "grain modulus");
  REQUIRE(a.shares().size() == 2);
  CHECK(a.shares().front().share + a.shares().back().share == doctest::Approx(1));
}

TEST_CASE("answer: a range is as wide as its effects in quadrature, by logarithms or differences, within its "
          "limits") {
  const estimate::FieldRow &G = estimate::row_of(Field::shear_modulus),
                           &nu = estimate::row_of(Field::poisson_ratio);
  estimate::Values middle{}, less{}, more{}, none{};
  const auto at = [](estimate::Values& values, const estimate::FieldRow& row) -> double& {
    return values[static_cast<std::size_t>(row.field)];
  };
  at(middle, G) = 4, at(less, G) = 2, at(more, G) = 12;
  at(middle, nu) = 0.2, at(less, nu) = 0.1, at(more, nu) = 0.35;
  none = less;
  at(none, G) = 0, at(none, nu) = 0.2;
  const estimate::Effect one = estimate::effect_of("one", true, middle, less, more),
                         two = estimate::effect_of("two", true, middle, more, less),
                         zero = estimate::effect_of("zero", true, middle, none, middle);
  const std::vector both{one, two}, all{one, two, zero};
  const double root = std::sqrt(2);
  const Range of_G = estimate::range_of(G, middle, both, ""),
              of_nu = estimate::range_of(nu, middle, both, "");
  CHECK(of_G.low == relative(4 * std::pow(0.5, root), 1e-12));
  CHECK(of_G.high == relative(4 * std::pow(3, root), 1e-12));
  CHECK(of_nu.low == relative(0.2 - 0.1 * root, 1e-12));
  CHECK(of_nu.high == relative(0.2 + 0.15 * root, 1e-12));
  CHECK(estimate::range_of(G, middle, both, "two").high == relative(12, 1e-12));
  CHECK(estimate::range_of(G, middle, all, "").low == 0);
  const std::vector<estimate::Effect> many(9, one);
  CHECK(estimate::range_of(nu, middle, many, "").high == 0.5); // the most that it can be
  const auto shares = estimate::shares_of(Field::shear_modulus, std::vector{one, zero, one});
  REQUIRE(shares.size() == 2);
  CHECK(shares[0].share == relative(200.0 / 216, 1e-12));
  CHECK(shares[1].share == relative(16.0 / 216, 1e-12));
}

TEST_CASE("answer: water adds mass, and stiffness only to V_p and only without air") {
  const Answer dry = estimate::answer(beads());
  Question q = beads();
  q.saturation = 1;
  const Answer wet = estimate::answer(q);
  CHECK(wet[Field::shear_modulus].value == dry[Field::shear_modulus].value);
  CHECK(wet[Field::bulk_modulus].value == dry[Field::bulk_modulus].value);
  CHECK(close(wet[Field::bulk_density].value, (2480 + 0.58 * 998) / 1.58, 1e-14));
  CHECK(wet[Field::shear_wave_speed].value < dry[Field::shear_wave_speed].value);
  CHECK(wet[Field::compression_wave_speed].value > 1500);
  CHECK(wet[Field::compression_wave_speed].value < 2100);
  q.saturation = 0.9;
  CHECK(estimate::answer(q)[Field::compression_wave_speed].value < dry[Field::compression_wave_speed].value);
}

TEST_CASE("answer: unequal stresses give speeds by direction") {
  Question q = beads();
  q.state.stress_v = 2e5;
  const Answer a = estimate::answer(q);
  CHECK(a[Field::compression_wave_speed].value > a[Field::horizontal_compression_wave_speed].value);
  CHECK(a[Field::young_modulus].value > a[Field::horizontal_young_modulus].value);
  CHECK(a[Field::shear_modulus].value > a[Field::horizontal_shear_modulus].value);
}

TEST_CASE("answer: quartz looser than any sphere packing: a note or the range covers the measured values") {
  // Toyoura sand at 98 kPa [Kokusho1980]. At e = 0.7 it has 107 MPa, more than any spheres.
  for (const auto& [e, G] : {std::pair{0.8, 88e6}, {0.9, 71e6}}) {
    Question q = beads(e, 98e3);
    q.state.law = contact::PowerLaw::sphere({.shear_modulus = 44e9, .poisson_ratio = 0.08}, 1e-4);
    q.state.tangential_ratio = contact::mindlin_stiffness_ratio(0.08);
    q.state.radius = 1e-4;
    const Answer a = estimate::answer(q);
    CHECK((holds(a[Field::shear_modulus], G, G) || !a.validity().ok()));
  }
}

TEST_CASE(
    "answer: beyond the void ratios of spheres the range reaches to measured sands, in full from 0.05 on") {
  const auto k = static_cast<std::size_t>(Field::shear_modulus);
  for (const auto& [e, weight] : {std::pair(0.44, 1.0),
                                  {0.46, 0.8},
                                  {0.49, 0.2},
                                  {0.5, 0.0},
                                  {0.75, 0.0},
                                  {0.76, 0.2},
                                  {0.79, 0.8},
                                  {0.9, 1.0},
                                  {2.95, 0.0}}) {
    const Answer a = estimate::answer(beads(e));
    const double G = a[Field::shear_modulus].value,
                 reach = weight > 0 ? std::pow(sands::pooled_shear_modulus({}, e, 1e5) / G, weight) : 1;
    Range found{G, G, G};
    for (const estimate::Effect& effect : a.effects())
      if (effect.input == "measured sands")
        found = {.value = G, .low = effect.low[k], .high = effect.high[k]};
    CHECK(found.low == relative(std::min(1.0, reach) * G, 1e-9));
    CHECK(found.high == relative(std::max(1.0, reach) * G, 1e-9));
  }
}

TEST_CASE("answer: near the isostatic point the range reaches 0 and stays finite") {
  const Answer a = estimate::answer(beads(0.86));
  CHECK(a[Field::shear_modulus].low == 0);
  CHECK(a[Field::shear_modulus].value > 0);
  CHECK(std::isfinite(a[Field::shear_modulus].high));
  Question q = beads();
  q.state.mechanical_coordination_number = 3.5;
  q.rattler_fraction = 0.1;
  const Answer none = estimate::answer(q);
  for (const Field field : {Field::shear_modulus, Field::shear_wave_speed})
    CHECK((none[field].value == 0 && none[field].low == 0));
  CHECK_FALSE(none.validity().ok());
  q = beads();
  q.state.coordination_number = 0;
  CHECK(estimate::answer(q)[Field::mechanical_coordination_number].value == 0);
  CHECK(estimate::answer(q)[Field::shear_modulus].high == 0);
}

TEST_CASE("answer: C_n, z* and rattlers that contradict each other are refused") {
  Question q = beads();
  q.state.coordination_number = 5;
  q.state.mechanical_coordination_number = 5.2;
  q.rattler_fraction = 0.04;
  CHECK_THROWS_AS((void)estimate::answer(q), InvalidArgument);
}

TEST_CASE(
    "answer: s is the slope of its own G along p', with contacts that grow and with contacts that stay") {
  for (const bool counted : {false, true})
    for (const double ratio : {1.0, 0.5}) {
      CAPTURE(counted);
      CAPTURE(ratio);
      const auto question = [&](double p, double more_v = 1) {
        Question q = grains_of(2, 0.1, p * more_v, ratio * p);
        if (counted) {
          q.state.coordination_number = 5.5;
          q.state.mechanical_coordination_number = 5.7;
        }
        return q;
      };
      const auto at = [&](double p, double more_v = 1) { return estimate::answer(question(p, more_v)); };
      const auto G = [&](double p, double more_v = 1) { return at(p, more_v)[Field::shear_modulus].value; };
      constexpr double step = 1e-3;
      const double up = std::exp(step), down = 1 / up;
      const Answer a = at(1e5);
      CHECK(a[Field::stress_exponent].value ==
            relative(std::log(G(1e5 * up) / G(1e5 * down)) / (2 * step), 1e-5));
      CHECK(a[Field::vertical_exponent].value ==
            relative(std::log(G(1e5, up) / G(1e5, down)) / (2 * step), 1e-4));
      CHECK(a[Field::vertical_exponent].value + a[Field::horizontal_exponent].value ==
            relative(a[Field::stress_exponent].value, 1e-12));
      if (counted)
        CHECK(a[Field::stress_exponent].value ==
              relative(1.0 / 3 - lost_exponent(question(1e5).state), 1e-9));
      else
        CHECK(a[Field::stress_exponent].value > 0.35);
    }
  CHECK(!estimate::answer(grains_of(2, 0, 0, 0)).find(Field::stress_exponent));
  CHECK_THROWS_AS((void)estimate::answer(grains_of(2, 0, 0, 0))[Field::stress_exponent], InvalidArgument);
}

TEST_CASE("answer: where rung 3's error exceeds the modulus its range begins at 0, and nothing is NaN") {
  for (double z = 3.9501; z < 4.1; z += 0.0007) {
    Question q = grains_of(2, 0, 1e5, 1e5);
    q.state.void_ratio = 0.7;
    q.state.mechanical_coordination_number = z;
    const Answer a = estimate::answer(q);
    CAPTURE(z);
    for (const estimate::FieldRow& row : estimate::fields())
      if (const auto& range = a.find(row.field)) {
        CAPTURE(row.key);
        CHECK((std::isfinite(range->low) && std::isfinite(range->high)));
        CHECK((range->low <= range->value && range->value <= range->high));
      }
    if (z < 3.96)
      CHECK(a[Field::shear_modulus].low == 0);
    CHECK(close(a[Field::shear_wave_speed].value,
                std::sqrt(a[Field::shear_modulus].value / a[Field::bulk_density].value), 1e-12));
  }
  // Poisson's ratio of an anisotropic packing may exceed 0.5, and stays in its range.
  Question q = grains_of(2, 0.2, 1e5, 6e4);
  q.state.void_ratio = 0.7;
  q.state.mechanical_coordination_number = 4.1;
  const Range nu = estimate::answer(q)[Field::poisson_ratio];
  CHECK(nu.value > 0.5);
  CHECK((nu.low <= nu.value && nu.value <= nu.high));
}

TEST_CASE("answer: an input is changed as far as a packing is possible") {
  const Question q = grains_of(2, 1.2, 1e5, 1e5); // near 7/5, the most that a fabric may have
  Question counted = q;
  counted.state.coordination_number = 5.5;
  counted.state.mechanical_coordination_number = 5.7;
  const estimate::UncertainInput fabric = uncertain_fabric(counted, 0.5, true);
  const Answer a = estimate::answer(counted, std::span(&fabric, 1));
  CHECK(a.assumes("fabric"));
  CHECK(!a.assumes("contacts"));
  const Range with = a[Field::horizontal_shear_modulus],
              without = a.without(Field::horizontal_shear_modulus, "fabric");
  CHECK(with.high - with.low > without.high - without.low);
  CHECK(without == estimate::answer(counted)[Field::horizontal_shear_modulus]);
  // A larger uncertainty, beyond what is possible too, never gives a narrower range.
  Range narrower = without;
  for (const double deviation : {0.1, 0.5, 0.69, 0.7, 0.71, 1.0, 1e3}) { // of e = 0.7
    CAPTURE(deviation);
    const estimate::UncertainInput void_ratio{
        .input = "void-ratio", .deviation = deviation, .moved = [&](double change) {
          Question moved = counted;
          moved.state.void_ratio += change;
          return moved;
        }};
    const Range range = estimate::answer(counted, std::span(&void_ratio, 1))[Field::horizontal_shear_modulus];
    CHECK(std::isfinite(range.low));
    CHECK(range.low <= narrower.low);
    CHECK(range.high >= narrower.high * (1 - 1e-5)); // of 1e3, the limit is found to 1e-9
    narrower = range;
  }
}
