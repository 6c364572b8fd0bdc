// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <random>
#include <string>

#include <granum/effective/state.hpp>

/// Random states at the extremes of what the closed forms take.
namespace attack {

using namespace granum;

/// The same numbers on every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  double decades(double low, double high) { return std::pow(10, between(low, high)); }
  bool one_in(std::uint64_t n) { return bits_() % n == 0; }
  std::uint64_t below(std::uint64_t n) { return bits_() % n; }

 private:
  std::mt19937_64 bits_;
};

/// Takes whether a promise is kept, and the promise in words.
using Demand = std::function<void(bool, const std::string&)>;

/// Counts broken promises, and shows the first three of each with where it was broken.
class Promises {
 public:
  Promises(std::FILE* report, std::function<std::string()> here) : report_(report), here_(std::move(here)) {}

  void demand(bool holds, const std::string& promise) {
    if (holds || ++count_[promise] > 3)
      return;
    std::fprintf(report_, "%s\n  %s\n", promise.c_str(), here_().c_str());
    std::fflush(report_);
  }
  /// Lists all; whether none was broken.
  [[nodiscard]] bool report() const {
    for (const auto& [promise, count] : count_)
      std::fprintf(report_, "%9zu  %s\n", count, promise.c_str());
    return count_.empty();
  }

 private:
  std::FILE* report_;
  std::function<std::string()> here_;
  std::map<std::string, std::size_t> count_;
};

/// A law that can be made again in other units.
struct Law {
  int shape = 0;
  contact::GrainMaterial grain;
  double alpha = 2;
  double number = 1; ///< slope, punch radius [m] or profile constant [m^(1-alpha)]

  /// The same grains where the units of length and stress are 1/length and 1/stress of the old ones.
  [[nodiscard]] contact::PowerLaw in_units(double radius, double length, double stress) const {
    const contact::GrainMaterial g{grain.shear_modulus * stress, grain.poisson_ratio};
    switch (shape) {
    case 0:
      return contact::PowerLaw::sphere(g, radius * length);
    case 1:
      return contact::PowerLaw::cone(g, number);
    case 2:
      return contact::PowerLaw::flat(g, number * length);
    default:
      return contact::PowerLaw::general(g, alpha, number * std::pow(length, 1 - alpha));
    }
  }
};

struct Sample {
  Law law;
  effective::State state;
  double mechanical = 0; ///< z*
};

inline double extreme_fabric(Random& random) {
  constexpr double low = -7.0 / 3, high = 7.0 / 5;
  const double all[] = {0, low + random.decades(-10, 0), high - random.decades(-10, 0),
                        random.between(low, high)};
  return all[random.below(4)];
}

inline double extreme_ratio(Random& random) {
  const double all[] = {0, 1, random.decades(-12, 2), random.between(0, 4.0 / 3)};
  return all[random.below(4)];
}

inline Sample sample(Random& random) {
  const double radius = random.decades(-12, 6);
  Law law;
  law.grain = {random.decades(-20, 20),
               random.one_in(8) ? -1 + random.decades(-12, 0) : random.between(-0.999, 0.5)};
  law.shape = static_cast<int>(random.below(4));
  law.alpha = 1 + random.decades(-3, 1);
  law.number = law.shape == 1   ? random.decades(-6, 6)
               : law.shape == 2 ? radius * random.decades(-8, 0)
                                : random.decades(-2, 2) * std::pow(radius, 1 - law.alpha);
  Sample s{.law = law,
           .state = {.law = law.in_units(radius, 1, 1),
                     .tangential_ratio = extreme_ratio(random),
                     .radius = radius,
                     .void_ratio = random.decades(-6, 6),
                     .coordination_number = random.one_in(3) ? random.decades(-6, 4) : random.between(0, 12),
                     .fabric_anisotropy = extreme_fabric(random),
                     .stress_v = 0,
                     .stress_h = 0}};
  if (!random.one_in(50)) {
    s.state.stress_h = random.decades(-20, 20);
    s.state.stress_v = s.state.stress_h * (random.one_in(3) ? 1 : random.decades(-2, 2));
  }
  if (random.one_in(3))
    s.state.rolling = random.one_in(4) ? 1 : random.decades(-12, 0);
  s.mechanical = random.one_in(3) ? random.decades(-3, 3) : random.between(3, 9);
  return s;
}

} // namespace attack
