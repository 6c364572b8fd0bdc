// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs changed as far as a packing is possible. The only source of the closed forms that catches
// exceptions; it is left out on targets without them.
#include <vector>

#include <granum/core/error.hpp>
#include <granum/estimate/answer.hpp>

#include "parts.hpp"

namespace granum::estimate {

namespace {

constexpr int most_halvings = 60;

Spread whole(const UncertainInput& input) {
  return {.input = input.input,
          .assumed = input.assumed,
          .less = input.moved(-input.deviation),
          .more = input.moved(input.deviation)};
}

/// The question with the whole change, or with the largest share of it that has an answer, to 1e-18: a
/// larger uncertainty must not give a narrower range. Assumes that all smaller shares have answers.
Question moved_if_possible(const Question& question, const UncertainInput& input, double change) {
  Question farthest = question;
  double possible = 0, impossible = 2; // the first share tried is 1
  for (int halvings = 0; halvings <= most_halvings && possible < 1; ++halvings) {
    const double share = (possible + impossible) / 2;
    try {
      Question moved = input.moved(share * change);
      (void)possible_answer(moved);
      farthest = moved;
      possible = share;
    } catch (const InvalidArgument&) { // no such packing is possible
      impossible = share;
    }
  }
  return farthest;
}

} // namespace

Answer answer(const Question& question, std::span<const UncertainInput> inputs) {
  std::vector<Spread> spreads;
  try { // usually all are possible, and each attempt costs as much as an answer
    for (const UncertainInput& input : inputs)
      spreads.push_back(whole(input));
    return answer(question, spreads);
  } catch (const InvalidArgument&) { // one of them is not possible
  }
  spreads.clear();
  for (const UncertainInput& input : inputs)
    spreads.push_back({.input = input.input,
                       .assumed = input.assumed,
                       .less = moved_if_possible(question, input, -input.deviation),
                       .more = moved_if_possible(question, input, input.deviation)});
  return answer(question, spreads);
}

} // namespace granum::estimate
