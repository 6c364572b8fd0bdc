// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vector/power.hpp"

#include <random>

#include "core/vector/ulps.hpp"
#include "unit.hpp"

namespace {

using test::ulps;

template <VectorLevel level>
double power(double x, double b) {
  return power_from<level>(log2_of<level>(x), SplitExponent(b));
}

// How the levels differ is whether products and sums are fused.
using Plain = AtLevel<VectorLevel::baseline>;
using Fused = AtLevel<VectorLevel::avx2>;

} // namespace

TEST_CASE_TEMPLATE("powers with all exponents of contact laws within 1.5 ulp up to 1/2, 2.5 ulp up to 1",
                   Level, Plain, Fused) {
  constexpr VectorLevel level = Level::value;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> mantissa(1, 2);
  for (const double b : {1.0, 0.97, 0.7, 0.5, 1.0 / 3, 0.1, 1.0 / 301, 1e-9}) {
    double worst = 0;
    for (int octave = -1020; octave <= 1020; octave += 3)
      for (int k = 0; k < 100; ++k) {
        const double x = std::ldexp(mantissa(random), octave);
        const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(b));
        worst = std::max(worst, ulps(power<level>(x, b), exact));
      }
    CAPTURE(b);
    CHECK(worst < (b <= 0.5 && level != VectorLevel::baseline ? 1.5 : 2.5));
    CHECK(worst > 0);
  }
}

TEST_CASE_TEMPLATE("powers near the ends of the mantissa, of 1 and of 0", Level, Plain, Fused) {
  constexpr VectorLevel level = Level::value;
  for (const double b : {1.0, 0.7, 0.5, 0.1}) {
    CHECK(power<level>(1, b) == 1);
    for (const double x : {std::sqrt(0.5), std::sqrt(2.0), 1 - 0x1p-53, 1 + 0x1p-52}) {
      const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(b));
      CHECK(ulps(power<level>(x, b), exact) < 2.5);
    }
    const double of_nothing = power<level>(0, b);
    CHECK(of_nothing >= 0);
    CHECK(of_nothing < 1e-30);
  }
}
