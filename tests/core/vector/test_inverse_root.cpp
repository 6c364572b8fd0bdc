// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vector/power.hpp"

#include <random>

#include "unit.hpp"

// How the levels differ is whether products and sums are fused.
using Plain = AtLevel<VectorLevel::baseline>;
using Fused = AtLevel<VectorLevel::avx2>;

TEST_CASE_TEMPLATE(
    "the inverse root is within 2 ulp of that in long double, over all octaves and all mantissas", Level,
    Plain, Fused) {
  constexpr VectorLevel level = Level::value;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(1, 4);
  long double worst = 0;
  for (int octaves = -1020; octaves <= 1020; octaves += 2)
    for (int k = 0; k < 200; ++k) {
      const double x = std::ldexp(mantissa(random), octaves);
      const long double exact = 1 / std::sqrt(static_cast<long double>(x));
      worst = std::max(worst, std::abs(inverse_root<level>(x) / exact - 1));
    }
  for (const double x : {1.0, 2.0, 4.0}) // where the guess turns over
    for (const double near : {std::nextafter(x, 0.0), x, std::nextafter(x, 8.0)})
      worst = std::max(worst,
                       std::abs(inverse_root<level>(near) * std::sqrt(static_cast<long double>(near)) - 1));
  CHECK(worst < 2 * std::numeric_limits<double>::epsilon());
  CHECK(worst > 0);
  CHECK(std::isfinite(inverse_root<level>(0.0)));
}

TEST_CASE_TEMPLATE("what the inverse root begins with is within 8e-7", Level, Plain, Fused) {
  constexpr VectorLevel level = Level::value;
  long double worst = 0;
  for (int k = 0; k < 30000; ++k) {
    const double x = 1 + 1e-4 * k; // all mantissas of two octaves
    const long double exact = 1 / std::sqrt(static_cast<long double>(x));
    worst = std::max(worst, std::abs(near_inverse_root<level>(x) / exact - 1));
    CHECK(nearer_inverse_root<level>(x, near_inverse_root<level>(x)) == inverse_root<level>(x));
  }
  CHECK(worst < 8e-7);
  CHECK(worst > 6e-7);
}
