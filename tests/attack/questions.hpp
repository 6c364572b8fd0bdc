// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <granum/core/text.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/estimate/ladder.hpp>

#include "samples.hpp"

/// Random questions, with little or much known and inputs of wild deviations, and what must be true of any
/// answer.
namespace attack {

using estimate::Field;
using estimate::Question;

struct RandomQuestion {
  Question question;
  std::vector<estimate::UncertainInput> inputs;
  std::string text; ///< what is known beside the state
};

/// An input that may be uncertain: its value, and the question with another one.
struct MovableInput {
  const char* name;
  double (*value)(const Question&);
  void (*set)(Question&, double);
};

inline constexpr std::array movable_inputs{
    MovableInput{"void ratio", [](const Question& q) { return q.state.void_ratio; },
                 [](Question& q, double x) { q.state.void_ratio = x; }},
    MovableInput{"stress", [](const Question& q) { return q.state.stress_h; },
                 [](Question& q, double x) {
                   q.state.stress_v *= q.state.stress_h > 0 ? x / q.state.stress_h : 1;
                   q.state.stress_h = x;
                 }},
    MovableInput{"grain modulus", [](const Question& q) { return q.state.law.grain().shear_modulus; },
                 [](Question& q, double x) {
                   q.state.law = q.state.law.of_grain(
                       {.shear_modulus = x, .poisson_ratio = q.state.law.grain().poisson_ratio});
                 }},
    MovableInput{"z*", [](const Question& q) { return q.state.mechanical_coordination_number.value_or(0); },
                 [](Question& q, double x) { q.state.mechanical_coordination_number = x; }},
};

/// A number of what is known; -1 of what is not.
inline void describe(RandomQuestion& asked, const std::string& name, double value) {
  asked.text += name + " " + exact_text(value) + "; ";
}

/// Nothing of the contacts, one number of them, or two.
inline void know_contacts(Random& random, RandomQuestion& asked, const Sample& s) {
  Question& q = asked.question;
  const std::uint64_t known = random.below(7); // nothing, C_n, z*, x_0, and each pair
  if (known == 1 || known == 4 || known == 5)
    q.state.coordination_number = s.state.coordination_number;
  if (known == 2 || known == 4 || known == 6)
    q.state.mechanical_coordination_number = s.mechanical;
  if (known == 3 || known == 5 || known == 6)
    q.rattler_fraction = random.one_in(4)   ? 0
                         : random.one_in(4) ? 1 - random.decades(-12, 0)
                                            : random.between(0, 0.3);
  describe(asked, "C_n", q.state.coordination_number.value_or(-1));
  describe(asked, "z*", q.state.mechanical_coordination_number.value_or(-1));
  describe(asked, "x_0", q.rattler_fraction.value_or(-1));
}

inline void prepare_and_fill(Random& random, RandomQuestion& asked) {
  using Kind = effective::Preparation::Kind;
  constexpr std::array kinds{Kind::unknown, Kind::dense, Kind::loose, Kind::friction};
  Question& q = asked.question;
  q.preparation.kind = kinds[random.below(kinds.size())];
  if (q.preparation.kind == Kind::friction)
    q.preparation.friction_coefficient = random.decades(-6, 3);
  if (random.one_in(2))
    q.grain_density = random.one_in(3) ? random.decades(-20, 20) : random.between(1000, 8000);
  if (random.one_in(2))
    q.saturation = random.one_in(2) ? 1 : random.one_in(2) ? random.decades(-12, 0) : random.between(0, 1);
  describe(asked, "preparation", static_cast<double>(q.preparation.kind));
  describe(asked, "friction", q.preparation.friction_coefficient);
  describe(asked, "grain density", q.grain_density.value_or(0));
  describe(asked, "saturation", q.saturation);
}

inline void doubt(Random& random, RandomQuestion& asked) {
  const MovableInput& input = movable_inputs[random.below(movable_inputs.size())];
  const double value = input.value(asked.question);
  const double deviation = random.one_in(8) ? 0 : (value != 0 ? std::abs(value) : 1) * random.decades(-9, 3);
  describe(asked, std::string("deviation of ") + input.name, deviation);
  asked.inputs.push_back({.input = input.name,
                          .deviation = deviation,
                          .assumed = random.one_in(2),
                          .moved = [q = asked.question, &input, value](double change) {
                            Question moved = q;
                            input.set(moved, value + change);
                            return moved;
                          }});
}

inline RandomQuestion random_question(Random& random, const Sample& s) {
  RandomQuestion asked{.question = {.state = s.state}, .inputs = {}, .text = {}};
  asked.question.state.coordination_number.reset();
  know_contacts(random, asked, s);
  prepare_and_fill(random, asked);
  for (std::uint64_t more = random.below(3); more > 0; --more)
    doubt(random, asked);
  return asked;
}

// ---- what must be true of an answer

inline bool in_order(const estimate::Range& range) {
  return std::isfinite(range.low) && std::isfinite(range.value) && std::isfinite(range.high) &&
         range.low <= range.value && range.value <= range.high;
}

inline void check_ranges(const estimate::Answer& answer, const Demand& demand) {
  for (const estimate::FieldRow& row : estimate::fields()) {
    const auto& range = answer.find(row.field);
    if (!range)
      continue;
    demand(in_order(*range), std::string("not finite, or not in its range: ") + row.key);
    for (const estimate::Effect& effect : answer.effects()) {
      const estimate::Range left = answer.without(row.field, effect.input);
      const double slack = 1e-12 * (std::abs(range->low) + std::abs(range->high));
      demand(in_order(left) && left.value == range->value && left.low >= range->low - slack &&
                 left.high <= range->high + slack,
             std::string("an exact input widens the range: ") + row.key);
    }
  }
}

inline void check_shares(const std::vector<estimate::Share>& shares, const Demand& demand) {
  double sum = 0;
  for (const estimate::Share& share : shares) {
    demand(share.share > 0 && share.share <= 1, "a share is outside (0, 1]");
    sum += share.share;
  }
  demand(shares.empty() || std::abs(sum - 1) <= 1e-12, "shares do not add up to 1");
}

/// V_s is the root of G over the mass, and rung 3 at the contacts of the answer has its G.
inline void check_numbers(const estimate::Answer& answer, const Demand& demand) {
  const double G = answer[Field::shear_modulus].value;
  if (answer.find(Field::shear_wave_speed)) {
    const double speed = answer[Field::shear_wave_speed].value, mass = answer[Field::bulk_density].value;
    // in logarithms: the square of a speed may be beyond what a double holds
    demand(G == 0 ? speed == 0
                  : std::abs(2 * std::log(speed) + std::log(mass) - std::log(G)) <=
                        1e-12 * (1 + std::abs(std::log(G))),
           "V_s^2 times the density is not G");
  }
  const auto rung3 = effective::answer(effective::rung(effective::RungName::relaxed), answer.state());
  demand(rung3.stiffness.C44 == G, "rung 3 at the contacts of the answer has another G");
}

inline void check_ladder(const estimate::Answer& answer, const Demand& demand) {
  std::size_t dearest = std::size(effective::rungs());
  for (const double tolerance : {0.01, 0.3, 3.0}) {
    const estimate::Ladder ladder = estimate::choose(answer, tolerance);
    demand(ladder.chosen <= dearest, "a looser tolerance takes a dearer rung");
    dearest = ladder.chosen;
    for (std::size_t k = 0; k < ladder.chosen; ++k)
      demand(ladder.rungs[k].largest_error().value_or(2 * tolerance) > tolerance || !ladder.tolerance_met,
             "a cheaper rung fits the tolerance");
    const std::optional<double> error = ladder.choice().largest_error();
    demand(!ladder.tolerance_met || (error && *error <= tolerance),
           "the tolerance is met by an error beyond it");
  }
}

inline bool same_answer(const estimate::Answer& a, const estimate::Answer& b) {
  for (const estimate::FieldRow& row : estimate::fields())
    if (a.find(row.field) != b.find(row.field))
      return false;
  return a.validity().notes == b.validity().notes;
}

/// \throws   InvalidArgument if there is no answer
inline void check_answer(const RandomQuestion& asked, const Demand& demand) {
  const estimate::Answer answer = estimate::answer(asked.question, asked.inputs);
  check_ranges(answer, demand);
  check_shares(answer.shares(), demand);
  check_numbers(answer, demand);
  check_ladder(answer, demand);
  demand(same_answer(answer, estimate::answer(asked.question, asked.inputs)),
         "the same question has another answer");
}

} // namespace attack
