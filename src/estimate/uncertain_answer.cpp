// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs changed as far as a packing is possible. The only source of the closed forms that catches
// exceptions; it is left out on targets without them.
#include <vector>

#include <granum/core/error.hpp>
#include <granum/estimate/answer.hpp>

namespace granum::estimate {

namespace {

constexpr int most_halvings = 5;

Spread whole(const UncertainInput& input) {
  return {.input = input.input,
          .assumed = input.assumed,
          .less = input.moved(-input.deviation),
          .more = input.moved(input.deviation)};
}

/// The question with a change as large as possible; unchanged if even 1/32 of the change has no answer.
Question moved_if_possible(const Question& question, const UncertainInput& input, double change) {
  for (int halvings = 0; halvings <= most_halvings; ++halvings, change /= 2) {
    try {
      Question moved = input.moved(change);
      (void)answer(moved);
      return moved;
    } catch (const InvalidArgument&) { // no such packing is possible; try half of the change
    }
  }
  return question;
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
