// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/equation.hpp>

#include "unit.hpp"

using namespace granum::hardin;

TEST_CASE("values worked by hand at e = 0.5 and e = 1") {
  const double ulps = 1e-15;
  CHECK(void_ratio_value(VoidRatioFunction::hardin_richart_round, 0.5) == relative(1.67 * 1.67 / 1.5, ulps));
  CHECK(void_ratio_value(VoidRatioFunction::hardin_richart_angular, 0.5) ==
        relative(2.47 * 2.47 / 1.5, ulps));
  CHECK(void_ratio_value(VoidRatioFunction::hardin_blandford, 0.5) == relative(1 / 0.475, ulps));
  CHECK(void_ratio_value(VoidRatioFunction::power_1_3, 0.5) == relative(2 * std::pow(2.0, 0.3), ulps));
  CHECK(void_ratio_value(VoidRatioFunction::power_1_3, 1) == 1);
  CHECK(void_ratio_value(VoidRatioFunction::hardin_blandford, 1) == 1);
  CHECK(void_ratio_value(VoidRatioFunction::none, 0.5) == 1);
}

TEST_CASE("every function falls with void ratio, but for none") {
  for (const VoidRatioFunction function : all_void_ratio_functions())
    for (double e = 0.1; e < 2; e += 0.1) {
      CAPTURE(name(function));
      const double step = void_ratio_value(function, e) - void_ratio_value(function, e + 0.1);
      CHECK((function == VoidRatioFunction::none ? step == 0 : step > 0));
    }
}

TEST_CASE("void ratios outside the range are refused") {
  for (const VoidRatioFunction function : all_void_ratio_functions())
    for (const double e : {0.0, -0.5, double(NAN), std::numeric_limits<double>::infinity()})
      CHECK_THROWS_AS((void)void_ratio_value(function, e), InvalidArgument);
  CHECK_THROWS_AS((void)void_ratio_value(VoidRatioFunction::hardin_richart_round, 2.17), InvalidArgument);
  CHECK_THROWS_AS((void)void_ratio_value(VoidRatioFunction::hardin_richart_angular, 3), InvalidArgument);
}

TEST_CASE("names lead back to their function") {
  for (const VoidRatioFunction function : all_void_ratio_functions())
    CHECK(void_ratio_function(name(function)) == function);
  CHECK_THROWS_WITH_AS((void)void_ratio_function("hardin"), doctest::Contains("'hardin'"), InvalidArgument);
}
