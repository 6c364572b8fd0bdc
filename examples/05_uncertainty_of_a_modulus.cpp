// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 05: how accurate is G if its inputs are uncertain?
//
// Spheres of 1 mm diameter at 100 kPa. The void ratio comes from weighing, the shear modulus of the grains
// from a data sheet; both have errors. The number of contacts is not known at first. estimate::answer gives
// the shear modulus G of the packing with the range that results from all these uncertainties. If nothing is
// known of the contacts, the range covers their possible numbers; the other inputs contribute one standard
// deviation to each side. The answer also gives the share of each input in the range. The input with the
// largest share is the one to measure. Four answers follow, each with more knowledge of the contacts.
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

// Inputs and their standard deviations.
constexpr double grain_modulus = 30e9, grain_deviation = 2e9; // [Pa]
constexpr double void_ratio = 0.558, void_deviation = 0.02;

Question with_grain(Question q, double shear_modulus) {
  q.state.law = q.state.law.of_grain({shear_modulus, q.state.law.grain().poisson_ratio});
  return q;
}

/// Void ratio and modulus of the grains are uncertain in all four answers.
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

/// The width of a range: its upper over its lower end.
double width(const estimate::Range& range) { return range.high / range.low; }

/// Prints the answer, and for each input its share and the range that would remain if this input were exact.
/// Returns the width of the range.
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

/// True if two statements hold. The effects of the inputs on ln G, added as squares, give the upper end of
/// the range. The effect of the modulus of the grains, G_g, is that of the contact law, G ~ G_g^(2/3) with
/// constant contacts; the tolerance covers overlaps, which shorten the distances of centres by 2e-4.
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
  // 1. The packing: void ratio, grains and stress. Nothing is known of its contacts.
  const contact::GrainMaterial grain{.shear_modulus = grain_modulus, .poisson_ratio = 0.15};
  Question question{.state = {.law = contact::PowerLaw::sphere(grain, 0.5e-3),
                              .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                              .radius = 0.5e-3,
                              .void_ratio = void_ratio,
                              .stress_v = 100e3,
                              .stress_h = 100e3}};
  std::vector<double> widths{ask("contacts not known", question)};

  // 2. The preparation is known, and with it the likely number of contacts.
  question.preparation.kind = effective::Preparation::Kind::dense;
  widths.push_back(ask("prepared dense", question));

  // 3. Tomography counts C_n, the contacts per grain in the mean of all grains. Only the share of rattlers
  //    (grains that carry no load) remains unknown.
  question.state.coordination_number = 5.73;
  widths.push_back(ask("C_n = 5.73 counted", question));

  // 4. z* is counted too, the contacts per load-carrying grain. The remaining uncertainty comes from the void
  //    ratio, from the modulus of the grains, and from the error of rung 3, the formula that gives the
  //    answer.
  question.state.mechanical_coordination_number = 5.85;
  widths.push_back(ask("z* = 5.85 counted too", question));

  // 5. Check: each new input narrows the range, and the effects of the inputs add up to the range.
  bool narrows = true;
  for (std::size_t k = 1; k < widths.size(); ++k)
    narrows = narrows && widths[k] < widths[k - 1];
  std::printf("from a factor of %.2f down to one of %.2f\n", widths.front(), widths.back());
  return narrows && adds_up(question) ? 0 : 1;
}
