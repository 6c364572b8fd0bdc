// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of questions: each refused value, and the last one that is not.
#include <granum/estimate/answer.hpp>

#include <tuple>

#include "estimate/parts.hpp"
#include "questions.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using estimate::Field;
using estimate::GrainShape;
using estimate::Question;

namespace {

const sands::Sand limited{.least_void_ratio = 0.6, .largest_void_ratio = 1.0};

Question of_sand(double void_ratio, const sands::Sand& sand = limited) {
  Question q = test::grains_of(2, 0, 100e3, 100e3);
  q.grain_shape = GrainShape::sand;
  q.state.void_ratio = void_ratio;
  q.sand = sand;
  return q;
}

/// The name of the number that is refused; "" if the question is answered.
void usual_answer(const Question& q) { (void)estimate::answer(q); }

std::string refused(const Question& q, void (*answered)(const Question&) = usual_answer) {
  try {
    answered(q);
    return "";
  } catch (const InvalidArgument& error) {
    return error.refused() ? error.refused()->name : "?";
  }
}

bool is_noted(const Question& q) { return !estimate::answer(q).validity().ok(); }

Question with_ratio(GrainShape shape, double k0) {
  Question q = of_sand(0.7);
  q.grain_shape = shape;
  q.state.stress_h = k0 * q.state.stress_v;
  return q;
}

} // namespace

TEST_CASE(
    "question: a sand is between its limits, a little denser with a note and a wider range, or refused") {
  for (const auto& [e, name] : {std::pair{1.0, ""}, {1.001, "void_ratio"}, {0.519, "void_ratio"}})
    CHECK(refused(of_sand(e)) == name);
  CHECK_FALSE(is_noted(of_sand(0.6)));
  CHECK(is_noted(of_sand(0.52)));
  const auto width = [](double e) {
    return estimate::answer(of_sand(e))[Field::shear_modulus].relative_error();
  };
  CHECK(width(0.6) == relative(width(0.9), 1e-12));
  CHECK(width(0.52) > 1.2 * width(0.6));
  // The same where the relative density is known by itself.
  CHECK(is_noted(of_sand(0.7, {.relative_density = 1.2})));
  CHECK(refused(of_sand(0.7, {.relative_density = 1.21})) == "relative_density");
  CHECK(refused(of_sand(0.7, {.relative_density = -0.01})) == "relative_density");
  // Limits are facts on the grains, also if these are taken for spheres.
  Question spheres = of_sand(0.519);
  spheres.grain_shape = GrainShape::sphere;
  CHECK(refused(spheres) == "void_ratio");
}

TEST_CASE("question: a packing is not below the pressure of its preparation, which narrows G of dense ones") {
  Question q = of_sand(0.6);
  q.grain_shape = GrainShape::sphere;
  q.state.mechanical_coordination_number = 6.1;
  const auto prepared = [&](double pressure) {
    Question dense = q;
    dense.preparation = {.kind = effective::Preparation::Kind::dense, .pressure = pressure};
    return dense;
  };
  CHECK(refused(prepared(100e3)) == "");
  CHECK(refused(prepared(100.1e3)) == "pressure of preparation");
  const estimate::Answer fresh = estimate::answer(prepared(100e3)), old = estimate::answer(prepared(1e3)),
                         unknown = estimate::answer(prepared(0));
  CHECK(old[Field::shear_modulus].value > 1.04 * fresh[Field::shear_modulus].value);
  CHECK(fresh[Field::stress_exponent].value > old[Field::stress_exponent].value + 0.01);
  CHECK(old[Field::shear_modulus].relative_error() < unknown[Field::shear_modulus].relative_error());
  CHECK(old.state().unevenness.has_value());
  CHECK(unknown.state().unevenness->standard_error > 3 * old.state().unevenness->standard_error);
}

TEST_CASE("question: limits of the void ratio that no soil has are refused") {
  CHECK(refused(of_sand(0.6, {.least_void_ratio = 0.6, .largest_void_ratio = 0.65})) == ""); // 0.05 apart
  CHECK(refused(of_sand(0.6, {.least_void_ratio = 0.6, .largest_void_ratio = 0.649})) ==
        "largest_void_ratio");
  CHECK(refused(of_sand(0.3, {.least_void_ratio = 0.09, .largest_void_ratio = 0.6})) == "least_void_ratio");
}

TEST_CASE(
    "question: limits unlike those of the sands tested are noted, and their answer is as uncertain as any") {
  const auto with = [](double least, double largest) {
    return of_sand((least + largest) / 2, {.least_void_ratio = least, .largest_void_ratio = largest});
  };
  CHECK_FALSE(is_noted(with(0.6, 0.95)));
  for (const auto& [least, largest] : {std::pair(0.5, 1.6), std::pair(0.25, 0.6), std::pair(0.62, 0.7)}) {
    CHECK(is_noted(with(least, largest)));
    CHECK(estimate::answer(with(least, largest))[Field::shear_modulus].relative_error() >
          1.5 * estimate::answer(with(0.6, 0.95))[Field::shear_modulus].relative_error());
  }
}

TEST_CASE(
    "question: one limit of the void ratio excludes what lies beyond it, a relative density what it is not") {
  CHECK(refused(of_sand(0.85, {.largest_void_ratio = 0.8})) == "void_ratio");
  CHECK(refused(of_sand(0.8, {.largest_void_ratio = 0.8})) == "");
  CHECK(refused(of_sand(0.5, {.least_void_ratio = 0.6})) == "void_ratio");
  CHECK(refused(of_sand(0.55, {.least_void_ratio = 0.6})) == "");
  sands::Sand both = limited;
  both.relative_density = 0.9; // e 0.7 is 0.75
  CHECK(refused(of_sand(0.7, both)) == "relative_density");
  both.relative_density = 0.76;
  CHECK(refused(of_sand(0.7, both)) == "");
}

TEST_CASE(
    "question: contacts follow from z*, C_n or rattlers, with the rattlers and the errors of the prior") {
  using Counts = effective::ContactCounts;
  for (const double e : {0.62, 0.8}) { // the last beyond packings of spheres
    Question q = test::grains_of(2, 0, 100e3, 100e3);
    q.state.void_ratio = e;
    const effective::ContactPrior prior = effective::contact_prior(q.state);
    const auto typical = [&](double z) {
      return effective::typical_rattler_fraction(z, prior.relative_overlap);
    };
    const double z = prior.middle.mechanical_coordination_number, factor = std::exp(prior.rattler_error),
                 doubt = prior.coordination_error - prior.packing_scatter;
    const auto reach = [&](const Counts& end, double error) {
      return std::hypot(end.mechanical_coordination_number - z, error);
    };
    const auto check = [](const Counts& found, double z_star, double rattlers) {
      CHECK(found.mechanical_coordination_number == relative(z_star, 1e-9));
      CHECK(found.rattler_fraction == relative(rattlers, 1e-9));
    };
    const double least = z - reach(prior.loosest, prior.coordination_error),
                 most = z + reach(prior.densest, prior.coordination_error);
    const estimate::KnownContacts free = estimate::contacts_of(q);
    check(free.middle, z, prior.middle.rattler_fraction);
    check(free.fewer, least, typical(least));
    check(free.more, most, typical(most));

    Question by_rattlers = q;
    const double x = typical(z), shift = prior.rattler_error / std::log(typical(4) / typical(5));
    by_rattlers.rattler_fraction = x;
    const estimate::KnownContacts of_x = estimate::contacts_of(by_rattlers);
    check(of_x.middle, z, x);
    check(of_x.fewer, z - std::min(shift, reach(prior.loosest, prior.packing_scatter)) - doubt, x);
    check(of_x.more, z + std::min(shift, reach(prior.densest, prior.packing_scatter)) + doubt, x);
    by_rattlers.state.contacts.branch = 1.05, by_rattlers.state.contacts.branch_square = 1.2;
    const effective::ContactPrior of_sizes = effective::contact_prior(by_rattlers.state);
    by_rattlers.rattler_fraction = 0.2; // of unequal grains they do not determine z*
    check(estimate::contacts_of(by_rattlers).middle, of_sizes.middle.mechanical_coordination_number, 0.2);

    Question by_z = q, by_C_n = q;
    by_z.state.mechanical_coordination_number = 5;
    by_C_n.state.coordination_number = 4.8;
    const estimate::KnownContacts of_z = estimate::contacts_of(by_z), of_C_n = estimate::contacts_of(by_C_n);
    check(of_z.middle, 5, typical(5));
    check(of_z.fewer, 5, typical(5) * factor);
    check(of_z.more, 5, typical(5) / factor);
    for (const auto& [counts, share] :
         {std::pair(of_C_n.middle, 1.0), {of_C_n.fewer, 1 / factor}, {of_C_n.more, factor}}) {
      CHECK(counts.coordination_number() == relative(4.8, 1e-12));
      CHECK(counts.rattler_fraction ==
            relative(share * typical(counts.mechanical_coordination_number), 1e-9));
    }
    by_z.state.mechanical_coordination_number = 0.1; // most grains are rattlers, never more than 90 %
    by_C_n.state.coordination_number = 0.01;
    CHECK(estimate::contacts_of(by_z).fewer.rattler_fraction == 0.9);
    CHECK(estimate::contacts_of(by_C_n).more.mechanical_coordination_number == relative(0.1, 1e-9));

    // Growth with the mean stress at the same void ratio.
    const estimate::ContactGrowth growth = estimate::growth_of(q);
    const auto at = [&](double step) {
      Question moved = q;
      moved.state.stress_v *= std::exp(step);
      moved.state.stress_h *= std::exp(step);
      return estimate::contacts_of(moved);
    };
    const double h = 2e-3;
    const estimate::KnownContacts before = at(-h), after = at(h);
    for (const auto& [slope, low, high] : {std::tuple(growth.middle, before.middle, after.middle),
                                           {growth.fewer, before.fewer, after.fewer},
                                           {growth.more, before.more, after.more}}) {
      CHECK(slope.coordination_number ==
            relative(std::log(high.coordination_number() / low.coordination_number()) / (2 * h), 1e-4));
      CHECK(slope.mechanical_coordination_number ==
            relative((high.mechanical_coordination_number - low.mechanical_coordination_number) / (2 * h),
                     1e-4));
    }
  }
}

TEST_CASE("question: shares of rattlers that no packing has are noted") {
  check_threshold(0.25, [](double rattlers) {
    Question q = test::grains_of(2, 0, 100e3, 100e3);
    q.rattler_fraction = rattlers;
    return estimate::answer(q).validity().notes.size();
  });
}

TEST_CASE("question: a standard deviation may lead beyond the limits, and widens the range") {
  const Question q = of_sand(0.58);
  const auto with = [&](double deviation) {
    const estimate::UncertainInput input{
        .input = "void-ratio", .deviation = deviation, .moved = [&](double change) {
          Question moved = q;
          moved.state.void_ratio += change;
          return moved;
        }};
    return estimate::answer(q, std::span(&input, 1))[Field::shear_modulus];
  };
  CHECK(with(0.1).high > with(0.05).high); // to e 0.48, D_r 1.3
  CHECK(with(0.1).high / with(0.1).value > std::pow(10, 0.294 * 0.1 / 0.4));
}

TEST_CASE("question: stresses that no friction can hold are refused, those of no soil noted") {
  const auto least = [](double degrees) { // K_0 that a friction angle holds
    const double sine = std::sin(degrees * M_PI / 180);
    return (1 - sine) / (1 + sine);
  };
  for (const GrainShape shape : estimate::all_grain_shapes)
    for (const bool turned : {false, true}) {
      const auto at = [&](double k0) { return with_ratio(shape, turned ? 1 / k0 : k0); };
      check_threshold(least(70), [&](double k0) { return refused(at(k0)) == "stress_h" ? 1 : 0; });
      if (shape == GrainShape::sand)
        check_threshold(least(50),
                        [&](double k0) { return estimate::answer(at(k0)).validity().notes.size(); });
    }
}

TEST_CASE("question: the extreme stresses that friction holds are possible but for rounding") {
  for (const double sign : {1, -1})
    check_threshold(1e-9, [=](double beyond) {
      const double end = sign > 0 ? stress::largest_stress_ratio : stress::least_stress_ratio;
      return refused(with_ratio(GrainShape::sphere, end * (1 + sign * beyond))) == "stress_h" ? 1 : 0;
    });
}

TEST_CASE("question: what a deviation leads to is refused where no packing has it") {
  using Change = void (*)(Question&);
  for (const auto& [change, name] :
       {std::pair{Change{[](Question& q) { q.grain_density = -1; }}, "grain_density"},
        {[](Question& q) { q.saturation = 1.01; }, "saturation"},
        {[](Question& q) { q.state.coordination_number = -1; }, "coordination_number"},
        {[](Question& q) { q.rattler_fraction = 1.01; }, "rattler_fraction"},
        {[](Question& q) { q.shear_strain = 1e-4; }, "shear_strain"},
        {[](Question& q) { q.sand.uniformity = 4.01; }, "uniformity"}}) {
    Question q = test::grains_of(2, 0, 100e3, 100e3);
    CHECK_NOTHROW((void)estimate::possible_answer(q));
    change(q);
    CHECK(refused(q, [](const Question& one) { (void)estimate::possible_answer(one); }) == name);
  }
  Question weightless = test::grains_of(2, 0, 100e3, 100e3);
  weightless.grain_density.reset();
  CHECK_NOTHROW((void)estimate::possible_answer(weightless));
}
