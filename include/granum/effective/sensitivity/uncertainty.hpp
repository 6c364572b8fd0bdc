// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <granum/effective/sensitivity/gradients.hpp>

/// How uncertain inputs make a modulus uncertain: to first order by its exact gradient, and by sampling,
/// which shows where first order breaks down.
namespace granum::effective {

/// A number that is known up to a normally distributed error, independent of those of other numbers.
struct UncertainNumber {
  double value = 0;
  double deviation = 0;                     ///< standard deviation >= 0 [unit of the number]
  std::array<double, input_count> slopes{}; ///< d input/d number in the order of Input
  /// Its name, which decides what it draws: the same whatever other numbers there are, and in any order.
  /// Where it is empty its place does.
  std::string key = {};
};

/// Uncertainty of a modulus whose inputs move in proportion to their uncertain numbers.
struct FirstOrder {
  double deviation = 0; ///< standard deviation: the squares of all contributions add up to its own [Pa]
  std::vector<double> contributions; ///< change of the modulus with one deviation of each number [Pa]
  double calibration = 0;            ///< the estimate's own standard error [Pa]

  /// Of the variance, 0 to 1, what a contribution makes; 0 where nothing is uncertain.
  [[nodiscard]] double share(double contribution) const {
    const double ratio = deviation > 0 ? contribution / deviation : 0;
    return ratio * ratio;
  }
};

/// Standard deviation of a modulus by its gradient: the root of the sum of (dX/d number x deviation)^2 and of
/// the square of the estimate's own standard error.                                               [JCGM2008a]
/// Assumes   independent numbers, deviations small against the distance over which the gradient changes.
/// \param    standard_error   of the estimate at exact inputs, CalibratedGradient::standard_error [Pa]
/// \throws   InvalidArgument if a deviation or the standard error is negative or not finite
/// Accuracy  rounding.  Checked by tests/effective/test_uncertainty.cpp
[[nodiscard]] FirstOrder first_order(const Gradient& gradient, std::span<const UncertainNumber> numbers,
                                     double standard_error = 0);

/// How to sample.
struct Sampling {
  std::size_t draws = 4096;
  std::uint64_t seed = 1; ///< the same seed draws the same numbers
};

/// Distribution of one result over the accepted draws.
struct Band {
  double mean = 0;
  double deviation = 0; ///< standard deviation
  double low = 0;       ///< 16 % of the draws are below
  double median = 0;
  double high = 0; ///< 84 % of the draws are below
};

struct Sample {
  std::vector<Band> bands;  ///< one a result
  std::size_t rejected = 0; ///< draws that no packing can have

  [[nodiscard]] double rejected_share(const Sampling& sampling) const {
    return static_cast<double>(rejected) / static_cast<double>(sampling.draws);
  }
};

/// Results of drawn numbers, always equally many.
using Evaluate = std::function<std::vector<double>(std::span<const double> numbers)>;

/// Draws the numbers again and again and describes the results. A draw for which `evaluate` throws
/// InvalidArgument is rejected, so that the rest is the distribution given that the packing is possible. Each
/// number has a stream of random numbers of its own, by its key and the seed.                    [JCGM2008b]
/// \throws   InvalidArgument if a deviation is negative or not finite, if two keys are the same, or if fewer
///           than two draws are left
/// Accuracy  of n draws: the deviation 1/sqrt(2n), low and high 1.5/sqrt(n) deviations.
///           Checked by tests/effective/test_uncertainty.cpp
[[nodiscard]] Sample sample(std::span<const UncertainNumber> numbers, const Evaluate& evaluate,
                            const Sampling& sampling = {});

/// Standard deviations of the inputs; 0, where nothing is said, for one that is exact.
struct Deviations {
  std::array<double, input_count> by{}; ///< in the order of Input [unit of the input]

  [[nodiscard]] double operator[](Input input) const { return by[static_cast<std::size_t>(input)]; }
  [[nodiscard]] double& operator[](Input input) { return by[static_cast<std::size_t>(input)]; }
};

/// A modulus and what uncertain inputs make of it.
struct Uncertainty {
  double value = 0;         ///< the modulus at the inputs as given [Pa]
  FirstOrder first_order;   ///< contributions in the order of Input
  Band sampled;             ///< [Pa]
  std::size_t rejected = 0; ///< of sampling.draws
};

/// Uncertainty of a modulus of rungs 0 to 2. Inputs move as Input says: grain_poisson_ratio_mindlin takes
/// k_t/k_n along, alpha keeps the profile constant; what a modulus does not depend on has no share in it.
/// \throws   InvalidArgument as gradient and sample, and for an uncertain alpha of a flat punch
/// Accuracy  as first_order and sample.  Checked by tests/effective/test_uncertainty.cpp
[[nodiscard]] Uncertainty uncertainty(const State& state, const Model& model, Modulus which,
                                      const Deviations& deviations, const Sampling& sampling = {});

/// The same for rung 3, with the standard error of the calibration. A draw whose z* is at the isostatic point
/// or below counts with a modulus of 0.
/// \throws   InvalidArgument as relaxed_gradient and sample, and for an uncertain alpha of a flat punch
/// Accuracy  as first_order and sample.  Checked by tests/effective/test_uncertainty.cpp
[[nodiscard]] Uncertainty relaxed_uncertainty(const State& state, double mechanical_coordination_number,
                                              Modulus which, const Deviations& deviations,
                                              const Sampling& sampling = {});

} // namespace granum::effective
