// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 05: how accurate is G if its inputs are uncertain?
//
// Spheres of 1 mm at 100 kPa. The void ratio comes from weighing, the shear modulus of the grains from a data
// sheet; both have errors. The number of contacts is not known at first. estimate::answer gives G with the
// range that results from all these uncertainties, and the share of each input in the range. The input with
// the largest share is the one to measure. Four answers follow, each with more knowledge of the contacts.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <granum/estimate/answer.hpp>

using namespace granum;
using estimate::Answer;
using estimate::Field;
using estimate::Question;

namespace {

constexpr double grain_modulus = 30e9, grain_deviation = 2e9; // [Pa]
constexpr double void_ratio = 0.558, void_deviation = 0.02;

Question with_grain(Question q, double shear_modulus) {
  q.state.law = q.state.law.of_grain({shear_modulus, q.state.law.grain().poisson_ratio});
  return q;
}

/// Void ratio and grains are known to within an error, whatever else is known.
std::vector<estimate::UncertainInput> uncertain_inputs(const Question& question) {
  return {{.input = "void ratio",
           .deviation = void_deviation,
           .moved =
               [question](double change) {
                 Question moved = question;
                 moved.state.void_ratio += change;
                 return moved;
               }},
          {.input = "grain modulus", .deviation = grain_deviation, .moved = [question](double change) {
             return with_grain(question, grain_modulus + change);
           }}};
}

/// How wide a range is: its high end over its low end.
double width(const estimate::Range& range) { return range.high / range.low; }

/// Prints the answer and what would be left if an input were exact; returns how wide the range is.
double ask(const char* known, const Question& question) {
  const Answer answer = estimate::answer(question, uncertain_inputs(question));
  const estimate::Range G = answer[Field::shear_modulus];
  std::printf("%s\n  G = %.0f MPa, %.0f to %.0f\n", known, G.value / 1e6, G.low / 1e6, G.high / 1e6);
  for (const estimate::Share& share : answer.shares()) {
    const estimate::Range left = answer.without(Field::shear_modulus, share.input);
    std::printf("  %-14s %3.0f %% of it; if it were exact: %.0f to %.0f\n", share.input.c_str(),
                100 * share.share, left.low / 1e6, left.high / 1e6);
  }
  return width(G);
}

/// Whether the range is what its inputs make of G, added in quadrature of the logarithm, and the grains'
/// part that of the law: G ~ G_g^(2/3) at given contacts, but for branches that overlaps shorten by 2e-4.
bool adds_up(const Question& question) {
  const Answer answer = estimate::answer(question, uncertain_inputs(question));
  const double value = answer[Field::shear_modulus].value;
  const auto k = static_cast<std::size_t>(Field::shear_modulus);
  double sum = 0, by_grains = 0;
  for (const estimate::Effect& effect : answer.effects()) {
    const double up = std::log(effect.high[k] / value);
    sum += up * up;
    if (effect.input == "grain modulus")
      by_grains = up;
  }
  const double up = std::log(answer[Field::shear_modulus].high / value);
  return std::abs(std::sqrt(sum) - up) < 1e-12 &&
         std::abs(by_grains - 2.0 / 3 * std::log1p(grain_deviation / grain_modulus)) < 5e-5;
}

} // namespace

int main() {
  // 1. The packing: what was weighed, read and loaded.
  const contact::GrainMaterial grain{.shear_modulus = grain_modulus, .poisson_ratio = 0.15};
  Question question{.state = {.law = contact::PowerLaw::sphere(grain, 0.5e-3),
                              .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                              .radius = 0.5e-3,
                              .void_ratio = void_ratio,
                              .stress_v = 100e3,
                              .stress_h = 100e3}};
  std::vector<double> widths{ask("contacts not known", question)};

  // 2. How it was prepared says which contacts are likely.
  question.preparation.kind = effective::Preparation::Kind::dense;
  widths.push_back(ask("prepared dense", question));

  // 3. A tomography counts the contacts of all grains: only the rattlers among them are not known.
  question.state.coordination_number = 5.73;
  widths.push_back(ask("C_n = 5.73 counted", question));

  // 4. And those that carry load: what is left is e, the grains, and rung 3 itself.
  question.state.mechanical_coordination_number = 5.85;
  widths.push_back(ask("z* = 5.85 counted too", question));

  // 5. Check: whatever is learnt narrows the range, and the range is the sum of its parts.
  bool narrows = true;
  for (std::size_t k = 1; k < widths.size(); ++k)
    narrows = narrows && widths[k] < widths[k - 1];
  std::printf("from a factor of %.2f down to one of %.2f\n", widths.front(), widths.back());
  return narrows && adds_up(question) ? 0 : 1;
}
