// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs that are moved as far as packings allow. The one source of the closed forms that catches exceptions:
// where none can be caught it is left out.
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

/// The question moved as far as it has an answer: not at all if it has none within a 32nd.
Question moved_if_possible(const Question& question, const UncertainInput& input, double change) {
  for (int halvings = 0; halvings <= most_halvings; ++halvings, change /= 2) {
    try {
      Question moved = input.moved(change);
      (void)answer(moved);
      return moved;
    } catch (const InvalidArgument&) { // no packing is so; half as far one may be
    }
  }
  return question;
}

} // namespace

Answer answer(const Question& question, std::span<const UncertainInput> inputs) {
  std::vector<Spread> spreads;
  try { // most packings may have all of them, and each attempt costs as much as an answer
    for (const UncertainInput& input : inputs)
      spreads.push_back(whole(input));
    return answer(question, spreads);
  } catch (const InvalidArgument&) { // one of them may not
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
