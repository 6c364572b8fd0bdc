// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/frame_series.hpp"

#include "unit.hpp"

using hardin::MeasuredModulus;
using studies::fit_series;

namespace {

/// States that obey Eq. (1) without f(e), sigma_v/sigma_h from 1 by `step` a state.
std::vector<MeasuredModulus> states(double m, double n, double step, int count = 6) {
  const hardin::Equation equation{.coefficient = 800,
                                  .exponent_i = m,
                                  .exponent_j = n,
                                  .atmospheric_pressure = 100e3,
                                  .void_ratio_function = hardin::VoidRatioFunction::none};
  std::vector<MeasuredModulus> out;
  for (int k = 0; k < count; ++k) {
    const hardin::SoilState state{(50e3 + 20e3 * k) * (1 + step * k * k), 50e3 + 20e3 * k, 0.6};
    out.push_back({hardin::shear_modulus(equation, state), state});
  }
  return out;
}

} // namespace

TEST_CASE("frame series: states of one stress ratio give only s, those of several also m and n") {
  const studies::SeriesFit iso = fit_series(states(0.2, 0.25, 0));
  REQUIRE(iso.sum);
  CHECK(iso.sum->exponent_sum.value == relative(0.45, 1e-10));
  CHECK(iso.sum->coefficient.value == relative(800, 1e-9));
  CHECK_FALSE(iso.separate);
  CHECK(iso.remark.empty());
  // e is the same in all, so f(e) changes C alone
  REQUIRE(iso.sum_with_void_ratio);
  CHECK(iso.sum_with_void_ratio->exponent_sum.value == relative(0.45, 1e-10));
  CHECK(iso.sum_with_void_ratio->coefficient.value == relative(800 * 1.6 / (1.57 * 1.57), 1e-9));

  const studies::SeriesFit sheared = fit_series(states(0.2, 0.25, 0.05));
  REQUIRE(sheared.separate);
  CHECK(sheared.separate->exponent_i->value == relative(0.2, 1e-9));
  CHECK(sheared.separate->exponent_j->value == relative(0.25, 1e-9));
}

TEST_CASE("frame series: the reason is reported if no fit is possible") {
  std::vector<MeasuredModulus> alike(4, states(0.2, 0.2, 0, 1).front()), bad = states(0.2, 0.2, 0);
  bad[1].shear_modulus = -1;
  CHECK(fit_series({}).remark.find("3") != std::string::npos); // states are needed
  CHECK(fit_series(states(0.2, 0.2, 0, 2)).remark == fit_series({}).remark);
  CHECK_FALSE((fit_series(alike).remark.empty() || fit_series(alike).sum));
  CHECK(fit_series(bad).remark.find("shear_modulus") != std::string::npos);
  CHECK_THROWS_AS((void)fit_series(states(0.2, 0.2, 0), 0), InvalidArgument);
}
