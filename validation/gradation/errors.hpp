// SPDX-License-Identifier: GPL-3.0-or-later
// How far rung 3 is from the networks, and how far seeds are from each other, as README.md says.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../errors.hpp"
#include "states.hpp"

namespace gradation {

/// Errors of one modulus, over the network's.
class ModulusErrors {
 public:
  void add(double closed, double network, double stated) {
    const double error = closed / network - 1;
    errors_.add(error);
    coverage_.add(error, stated);
    lowest_ = std::min(lowest_, error);
    highest_ = std::max(highest_, error);
    most_stated_ = std::max(most_stated_, std::abs(error) / stated);
  }
  [[nodiscard]] std::string text() const {
    return percent_text(errors_.rms()) + " | " + percent_text(lowest_) + " to " + percent_text(highest_) +
           " | " + percent_text(coverage_.one()) + " | " +
           std::to_string(coverage_.count - coverage_.within_two) + " | " + short_text(most_stated_, 2);
  }

 private:
  Errors errors_;
  Coverage coverage_;
  double lowest_ = 1e300, highest_ = -1e300, most_stated_ = 0;
};

/// C_u as the tables print it: seeds of one gradation differ in the next digit.
inline double printed_uniformity(const State& s) { return std::round(10 * s.uniformity) / 10; }

using ChoiceOfStates = std::function<bool(const State&)>;

inline void print_errors_of(const std::string& what, const std::vector<State>& states,
                            const ChoiceOfStates& chosen) {
  ModulusErrors shear, bulk;
  int count = 0;
  for (const State& s : states)
    if (s.mean_radius == usual_radius && chosen(s)) {
      const ClosedForms now = closed_forms(s);
      shear.add(now.relaxed, s.network, now.stated_error);
      bulk.add(now.bulk_modulus, s.network_bulk_modulus, now.stated_bulk_error);
      ++count;
    }
  std::printf("| %s | %d | %s | %s |\n", what.c_str(), count, shear.text().c_str(), bulk.text().c_str());
}

inline void print_errors(const std::vector<State>& states) {
  constexpr double lowest_claimed = 4.1; // z*
  const auto dense = [](double from, double to) {
    return [=](const State& s) {
      return s.dense() && printed_uniformity(s) >= from && printed_uniformity(s) <= to;
    };
  };
  const auto with_friction = [](double from, double to) {
    return [=](const State& s) {
      return !s.dense() && s.z_star >= lowest_claimed && printed_uniformity(s) >= from &&
             printed_uniformity(s) <= to;
    };
  };
  std::printf("| packings | number | G rms | from, to | within one stated error | beyond two | worst, in "
              "stated errors | K rms | from, to | within one | beyond two | worst |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  print_errors_of("with friction, z* from 4.1", states, with_friction(1, 4));
  print_errors_of("- C_u up to 2", states, with_friction(1, 2));
  print_errors_of("- C_u up to 2, friction 0.03 to 0.3", states, [&](const State& s) {
    return with_friction(1, 2)(s) && !s.preparation.ends_with("mu0.5");
  });
  print_errors_of("- C_u beyond 2", states, with_friction(2.5, 4));
  print_errors_of("with friction, z* below 4.1", states,
                  [](const State& s) { return !s.dense() && s.z_star < lowest_claimed; });
  print_errors_of("dense", states, dense(1, 4));
  print_errors_of("- C_u = 1", states, dense(1, 1));
  print_errors_of("- C_u from 2 to 3", states, dense(2, 3));
  print_errors_of("- C_u = 4", states, dense(4, 4));
}

/// Standard deviation of G of the network among the seeds of each gradation and preparation, over their mean.
inline void print_scatter_of_seeds(const std::vector<State>& states) {
  std::map<std::pair<double, std::string>, std::vector<double>> moduli;
  for (const State& s : states)
    if (s.mean_radius == usual_radius)
      moduli[{printed_uniformity(s), s.preparation}].push_back(s.network);
  std::printf("| seeds of one state | G scatters by |\n| --- | --- |\n");
  for (const bool dense : {true, false}) {
    double least = 1e300, most = 0;
    for (const auto& [recipe, of_seeds] : moduli) {
      if ((recipe.second == "dense") != dense || of_seeds.size() < 3)
        continue;
      Errors about;
      for (const double modulus : of_seeds)
        about.add(modulus / of_seeds.front() - 1);
      const double mean = 1 + about.mean(), count = about.count();
      const double variance = (about.rms() * about.rms() - about.mean() * about.mean()) * count / (count - 1);
      least = std::min(least, std::sqrt(variance) / mean);
      most = std::max(most, std::sqrt(variance) / mean);
    }
    std::printf("| %s | %s to %s |\n", dense ? "dense" : "with friction", percent_text(least).c_str(),
                percent_text(most).c_str());
  }
}

} // namespace gradation
