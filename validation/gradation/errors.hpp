// SPDX-License-Identifier: GPL-3.0-or-later
// How far rung 3 is from the networks, and how far seeds are from each other, as README.md says.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gsl/gsl_statistics_double.h>

#include "../errors.hpp"
#include "states.hpp"

namespace gradation {

/// Errors of one modulus of rung 3, over the network's.
class ModulusErrors {
 public:
  void add(double closed, double network, double stated) {
    const double error = closed / network - 1;
    errors_.add(error);
    coverage_.add(error, stated);
    in_stated_.add(error / stated);
    lowest_ = std::min(lowest_, error);
    highest_ = std::max(highest_, error);
  }
  [[nodiscard]] int count() const { return coverage_.count; }
  [[nodiscard]] int beyond_two() const { return coverage_.count - coverage_.within_two; }
  /// The largest, in stated errors.
  [[nodiscard]] double worst_in_stated() const { return in_stated_.worst(); }
  [[nodiscard]] std::string text() const {
    return percent_text(errors_.rms()) + " | " + percent_text(lowest_) + " to " + percent_text(highest_) +
           " | " + percent_text(coverage_.one()) + " | " + std::to_string(beyond_two()) + " | " +
           short_text(worst_in_stated(), 2);
  }

 private:
  Errors errors_, in_stated_;
  Coverage coverage_;
  double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_;
};

struct ErrorsOfBoth {
  ModulusErrors shear, bulk;
};

/// C_u as the tables print it: seeds of one gradation differ in the next digit.
inline double printed_uniformity(const State& s) { return std::round(10 * s.uniformity) / 10; }

/// Of those states that are chosen and have grains of the usual size.
/// \param    chosen   takes a state
template <class Choice>
ErrorsOfBoth errors_of(const std::vector<State>& states, const Choice& chosen) {
  ErrorsOfBoth errors;
  for (const State& s : states)
    if (s.mean_radius == usual_radius && chosen(s)) {
      const ClosedForms now = closed_forms(s);
      errors.shear.add(now.relaxed, s.network, now.stated_error);
      errors.bulk.add(now.bulk_modulus, s.network_bulk_modulus, now.stated_bulk_error);
    }
  return errors;
}

template <class Choice>
void print_errors_of(const char* what, const std::vector<State>& states, const Choice& chosen) {
  const ErrorsOfBoth errors = errors_of(states, chosen);
  std::printf("| %s | %d | %s | %s |\n", what, errors.shear.count(), errors.shear.text().c_str(),
              errors.bulk.text().c_str());
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
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const auto& [recipe, of_seeds] : moduli) {
      if ((recipe.second == "dense") != dense || of_seeds.size() < 3)
        continue;
      const double scatter = gsl_stats_sd(of_seeds.data(), 1, of_seeds.size()) /
                             gsl_stats_mean(of_seeds.data(), 1, of_seeds.size());
      least = std::min(least, scatter);
      most = std::max(most, scatter);
    }
    std::printf("| %s | %s to %s |\n", dense ? "dense" : "with friction", percent_text(least).c_str(),
                percent_text(most).c_str());
  }
}

} // namespace gradation
