// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/frame_series.hpp"

#include "thresholds.hpp"
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

TEST_CASE(
    "frame series: stresses that vary by a tenth are enough, and exponents known to 0.3 are separated") {
  const auto of_range = [](double i, double j) {
    std::vector<MeasuredModulus> out;
    for (const double part : {0.0, 0.5, 1.0})
      out.push_back({100e6 * (1 + part), {50e3 * std::pow(i, part), 50e3 * std::pow(j, part), 0.6}});
    return fit_series(out).sum.has_value();
  };
  check_threshold(1.1, [&](double x) { return of_range(x, x); });
  check_threshold(1.1 * 1.1, [&](double x) { return of_range(x, 1); });
  check_threshold(1.1 * 1.1, [&](double x) { return of_range(1, x); });
  check_threshold(1.1 * 1.1, [&](double x) { return of_range(1, 1 / x); });
  int near = 0; // the less the ratio of the stresses varies, the larger are the errors
  for (int k = 20; k <= 200; ++k) {
    std::vector<MeasuredModulus> scattered = states(0.2, 0.25, 1e-4 * k);
    for (std::size_t s = 0; s < scattered.size(); s += 2)
      scattered[s].shear_modulus *= 1.02;
    const hardin::Fit fit = hardin::fit(scattered, {.atmospheric_pressure = 100e3,
                                                    .void_ratio_function = hardin::VoidRatioFunction::none})
                                .fit();
    const double error = std::max(fit.exponent_i->standard_error, fit.exponent_j->standard_error);
    const studies::SeriesFit found = fit_series(scattered);
    if (k % 20 == 0)
      CHECK(found.separate.has_value() == (error <= 0.3));
    CHECK(found.separate_remark.empty() == (error <= 0.3));
    near += error > 0.27 && error < 0.3 ? 1 : error > 0.3 && error < 0.33 ? 100 : 0;
  }
  CHECK((near % 100 > 0 && near > 100)); // on both sides
}
