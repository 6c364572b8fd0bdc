// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/ladder.hpp>

#include <granum/core/text.hpp>
#include <granum/effective/uniform_field.hpp>
#include <set>

#include "questions.hpp"
#include "unit.hpp"

using namespace granum::test;
using elastic::TransverselyIsotropic;
using estimate::Field;
using estimate::Ladder;
using estimate::Question;
using estimate::RungVerdict;

namespace {

/// Dense spheres at 100 kPa, and loose cones and flat contacts sheared, of validation/relaxation/states.csv.
std::vector<Question> recorded() {
  const auto known = [](double alpha, double e, double C_n, double z, double a, double v, double h) {
    Question q = grains_of(alpha, a, v, h);
    q.state.void_ratio = e;
    q.state.coordination_number = C_n;
    q.state.mechanical_coordination_number = z;
    return q;
  };
  return {known(2, 0.5674027, 6.049, 6.108641, 0.0021, 1e5, 1e5),
          known(1, 0.5569385, 5.3565, 5.411288, 0.1331, 153330, 73334),
          known(infinity, 0.5686133, 4.3815, 4.630188, 0.2522, 153330, 73334)};
}

/// The ladder of a question, its fabric assumed or measured.
Ladder ladder_of(const Question& q, double tolerance, bool fabric_assumed = false) {
  if (!fabric_assumed)
    return estimate::choose(estimate::answer(q), tolerance);
  const estimate::UncertainInput fabric =
      uncertain_fabric(q, estimate::assumed_fabric_deviation(q.state.stress_v, q.state.stress_h), true);
  return estimate::choose(estimate::answer(q, std::span(&fabric, 1)), tolerance);
}

Question dense_spheres() {
  Question q = grains_of(2, 0, 1e5, 1e5);
  q.state.coordination_number = 5.73;
  q.state.mechanical_coordination_number = 5.85;
  return q;
}

std::size_t count_mentions(const std::vector<std::string>& texts, const std::string& word) {
  return static_cast<std::size_t>(std::count_if(texts.begin(), texts.end(), [&](const std::string& text) {
    return text.find(word) != std::string::npos;
  }));
}
bool mentions(const std::vector<std::string>& texts, const std::string& word) {
  return count_mentions(texts, word) > 0;
}

} // namespace

// That stated errors cover the networks of packings: validation/ladder.
TEST_CASE("ladder: each rung is the closed form of its name") {
  Question q = grains_of(2, 0.2, 1.5e5, 1e5);
  q.state.coordination_number = 5.73;
  q.state.mechanical_coordination_number = 5.85;
  const effective::State& s = q.state;
  const Ladder ladder = ladder_of(q, 0.05);
  effective::State isotropic = s;
  isotropic.fabric_anisotropy = 0;
  isotropic.stress_v = isotropic.stress_h = 3.5e5 / 3;
  const TransverselyIsotropic rung0 = effective::uniform_strain(isotropic).stiffness;
  CHECK(ladder.rungs[0].stiffness->G_vh() == relative(rung0.G_vh(), 1e-14));
  CHECK(ladder.rungs[0].stiffness->bulk_modulus() == relative(rung0.bulk_modulus(), 1e-14));
  CHECK(*ladder.rungs[1].stiffness == effective::uniform_strain_stiffness(effective::uniform_contacts(s)));
  CHECK(*ladder.rungs[2].stiffness == effective::uniform_strain(s).stiffness);
  CHECK(ladder.rungs[3].stiffness->G_vh() == relative(effective::relaxed(s, 5.85).stiffness.G_vh(), 1e-14));
}

TEST_CASE("ladder: a fabric that is not measured is as uncertain as pouring and shear make it") {
  for (const auto& [v, h, by_shear] : {std::tuple(2e5, 1e5, 0.2 * std::numbers::ln2),
                                       {1e5, 2e5, 0.2 * std::numbers::ln2},
                                       {1e5, 1e5, 0.0},
                                       {1e5, 0.0, 0.0},
                                       {0.0, 1e5, 0.0},
                                       {0.0, 0.0, 0.0}})
    CHECK(estimate::assumed_fabric_deviation(v, h) == relative(std::hypot(0.05, by_shear), 1e-14));
}

TEST_CASE("ladder: rung 3 has the answer's value and error, lower rungs their distance from it") {
  const estimate::Answer answer = estimate::answer(dense_spheres());
  const Ladder ladder = estimate::choose(answer, 0.05);
  const auto relaxed = effective::relaxed(dense_spheres().state, 5.85);
  const auto& own = *ladder.rungs[3].relative_error;
  CHECK(ladder.rungs[3].stiffness->G_vh() == relative(answer[Field::shear_modulus].value, 1e-14));
  Question unequal = dense_spheres();
  unequal.state.stress_v = 2e5;
  const estimate::Answer of_unequal = estimate::answer(unequal);
  const auto errors = estimate::choose(of_unequal, 0.05).rungs[3].relative_error.value();
  CHECK(errors.bulk_modulus == relative(of_unequal[Field::bulk_modulus].relative_error(), 1e-12));
  CHECK(errors.G_hh == relative(of_unequal[Field::horizontal_shear_modulus].relative_error(), 1e-12));
  CHECK(own.G_vh == relative(answer[Field::shear_modulus].relative_error(), 1e-12));
  CHECK(own.G_vh == relative(relaxed.relative_error.G_vh, 2e-3)); // ends of a logarithmic range
  CHECK(own.bulk_modulus == relative(relaxed.relative_error.bulk_modulus, 2e-3));
  const double ratio = ladder.rungs[0].stiffness->G_vh() / relaxed.stiffness.G_vh();
  CHECK(ladder.rungs[0].relative_error->G_vh == relative(ratio - 1 + ratio * own.G_vh, 1e-12));
  CHECK(ladder.chosen == 3);
  CHECK(ladder.tolerance_met);
  CHECK(ladder.validity.ok());
}

TEST_CASE(
    "ladder: an isotropic packing gains nothing from rungs 1 and 2, and a wide tolerance takes rung 0") {
  const Ladder ladder = ladder_of(dense_spheres(), 0.7);
  for (const std::size_t k : {1u, 2u})
    CHECK(ladder.rungs[k].stiffness->G_vh() == relative(ladder.rungs[0].stiffness->G_vh(), 1e-14));
  CHECK(ladder.chosen == 0);
  CHECK(ladder.rungs[0].verdict == RungVerdict::chosen);
  CHECK(ladder.rungs[3].verdict == RungVerdict::cheaper_does);
}

TEST_CASE("ladder: a larger tolerance never leads to a more expensive rung") {
  std::vector<estimate::Answer> answers;
  for (Question q : recorded()) {
    answers.push_back(estimate::answer(q));
    q.state.mechanical_coordination_number.reset();
    const estimate::UncertainInput fabric = uncertain_fabric(q, 0.05, true);
    answers.push_back(estimate::answer(q, std::span(&fabric, 1)));
  }
  for (const double a : {-0.6, 0.3, 0.8})
    for (const double ratio : {0.3, 1.0, 3.0})
      for (const double z : {4.05, 5.0, 8.0}) {
        Question q = grains_of(2, a, ratio * 1e5, 1e5);
        q.state.mechanical_coordination_number = z;
        answers.push_back(estimate::answer(q));
      }
  int changes = 0;
  for (const estimate::Answer& answer : answers) {
    std::size_t last = 3;
    for (double tolerance = 1e-3; tolerance < 1e3; tolerance *= 1.1) {
      const Ladder ladder = estimate::choose(answer, tolerance);
      CHECK(ladder.chosen <= last);
      CHECK(ladder.tolerance_met == (*ladder.choice().largest_error() <= tolerance));
      CHECK(ladder.tolerance_met == !mentions(ladder.validity.notes, "tolerance"));
      changes += ladder.chosen != last;
      last = ladder.chosen;
      std::size_t cheaper = 0; // cheaper rungs, each better by a twentieth than all before
      double least = 1e300;
      for (std::size_t k = 0; k < ladder.chosen; ++k)
        if (const auto error = ladder.rungs[k].largest_error(); error && *error < 0.95 * least) {
          ++cheaper;
          least = *error;
        }
      CHECK(count_mentions(ladder.advice, "enough") == cheaper);
    }
  }
  CHECK(changes >= static_cast<int>(answers.size()));
}

TEST_CASE("ladder: the z* is that of the answer for any given contacts") {
  Question q = dense_spheres();
  q.state.mechanical_coordination_number.reset();
  const Ladder dense = ladder_of(q, 0.05);
  q.state.coordination_number = 4.2;
  const estimate::Answer answer = estimate::answer(q);
  const Ladder loose = estimate::choose(answer, 0.05);
  CHECK(loose.mechanical_coordination_number == answer[Field::mechanical_coordination_number]);
  CHECK(*loose.rungs[3].largest_error() > 1.2 * *dense.rungs[3].largest_error());
  // Published packings at 10 kPa [AgnolinRoux2007a]: without friction, with little, with friction.
  for (const auto& [C_n, z_star] : {std::pair{5.995, 6.074}, {5.687, 5.80}, {4.041, 4.546}}) {
    Question published = grains_of(2, 0, 1e4, 1e4);
    published.state.coordination_number = C_n;
    const estimate::Range z = estimate::answer(published)[Field::mechanical_coordination_number];
    CHECK(std::abs(z_star - z.value) <= 3 * std::max(z.high - z.value, z.value - z.low));
  }
}

TEST_CASE("ladder: missing inputs are listed, with their benefit") {
  Question q = dense_spheres();
  q.state.stress_v = 2e5;
  const Ladder ladder = ladder_of(q, 0.02, true);
  for (const std::size_t k : {1u, 2u}) {
    CHECK(ladder.rungs[k].verdict == RungVerdict::inputs_missing);
    CHECK(mentions(ladder.rungs[k].missing, "fabric"));
    CHECK_FALSE(ladder.rungs[k].stiffness.has_value());
    CHECK_FALSE(ladder.rungs[k].relative_error.has_value());
  }
  for (const std::size_t k : {4u, 5u})
    CHECK(mentions(ladder.rungs[k].missing, "packing"));
  CHECK(ladder.chosen == 3);
  CHECK_FALSE(ladder.tolerance_met);
  CHECK(mentions(ladder.advice, "fabric"));
  CHECK(mentions(ladder.advice, "packing"));
  CHECK(*ladder_of(q, 0.02).rungs[3].largest_error() < *ladder.rungs[3].largest_error());
}

TEST_CASE("ladder: the error of rung 3 is stated by its parts") {
  const estimate::Answer answer = estimate::answer(recorded().front());
  std::set<std::string> sources; // of an answer whose contacts were counted: the calibration alone
  for (const estimate::Effect& effect : answer.effects())
    if (effect.low != effect.high)
      sources.insert(effect.input);
  const std::string text = estimate::choose(answer, 0.05).rungs[3].error_source;
  CHECK(static_cast<std::size_t>(std::count(text.begin(), text.end(), '%')) == sources.size());
  double largest = 0;
  for (const estimate::Effect& effect : answer.effects())
    for (const Field field : {Field::bulk_modulus, Field::shear_modulus, Field::horizontal_shear_modulus}) {
      const auto k = static_cast<std::size_t>(field);
      largest = std::max(largest, (effect.high[k] - effect.low[k]) / answer[field].value / 2);
    }
  CHECK(text.find(percent_text(largest)) != std::string::npos);
  // An input is worth knowing if the error would fall by a twentieth.
  int worth = 0;
  for (double deviation = 0.02; deviation < 0.4; deviation *= 1.02) {
    const estimate::UncertainInput fabric = uncertain_fabric(dense_spheres(), deviation, false);
    const estimate::Answer of_fabric = estimate::answer(dense_spheres(), std::span(&fabric, 1));
    double now = 0, then = 0;
    for (const Field field : {Field::bulk_modulus, Field::shear_modulus, Field::horizontal_shear_modulus}) {
      now = std::max(now, of_fabric[field].relative_error());
      then = std::max(then, of_fabric.without(field, "fabric").relative_error());
    }
    CHECK(mentions(estimate::choose(of_fabric, 1e-3).advice, "fabric") == (then < 0.95 * now));
    worth += then < 0.95 * now;
  }
  CHECK((worth > 5 && worth < 150));
}

TEST_CASE("ladder: a better known input may allow a cheaper rung") {
  // Rung 0 is off by some 60 %, by more if z* is known to 0.4 only: rung 3 is not.
  const Question q = dense_spheres();
  const estimate::UncertainInput z{.input = "z*", .deviation = 0.4, .moved = [q](double change) {
                                     Question moved = q;
                                     *moved.state.mechanical_coordination_number += change;
                                     return moved;
                                   }};
  const estimate::Answer answer = estimate::answer(q, std::span(&z, 1));
  const double bare = *ladder_of(q, 0.05).rungs[0].largest_error();
  const double doubtful = *estimate::choose(answer, 0.05).rungs[0].largest_error();
  REQUIRE(doubtful > bare);
  const Ladder ladder = estimate::choose(answer, (bare + doubtful) / 2);
  CHECK(ladder.chosen == 3);
  CHECK(ladder.tolerance_met);
  CHECK(mentions(ladder.advice, "allow rung 0"));
}

TEST_CASE("ladder: exact where every rung is zero") {
  for (const double C_n : {5.73, 0.0}) {
    Question q = dense_spheres();
    q.state.stress_v = q.state.stress_h = 0;
    q.state.coordination_number = C_n;
    if (C_n == 0)
      q.state.mechanical_coordination_number.reset();
    const Ladder ladder = ladder_of(q, 1e-9);
    CHECK(ladder.chosen == 0);
    CHECK(ladder.tolerance_met);
    CHECK(*ladder.choice().largest_error() == 0);
    CHECK(*ladder.choice().stiffness == TransverselyIsotropic{});
    CHECK_FALSE(ladder.choice().error_source.empty());
  }
}

TEST_CASE(
    "ladder: no error is stated where the packing may not be rigid, impossible tolerances are refused") {
  Question q = dense_spheres();
  q.state.mechanical_coordination_number = 3.5;
  q.state.coordination_number = 3.4;
  const Ladder ladder = ladder_of(q, 0.05);
  CHECK(ladder.chosen == 3);
  CHECK_FALSE(ladder.tolerance_met);
  CHECK_FALSE(ladder.choice().largest_error().has_value());
  CHECK(ladder.rungs[0].verdict == RungVerdict::error_unknown);
  CHECK(ladder.validity.notes.size() == estimate::answer(q).validity().notes.size() + 1);
  for (const double tolerance : {0.0, -0.05, static_cast<double>(NAN), infinity})
    CHECK_THROWS_AS((void)ladder_of(dense_spheres(), tolerance), InvalidArgument);
}
