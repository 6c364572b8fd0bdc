// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/frame_series.hpp"

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>

namespace granum::studies {

namespace {

using FitFunction = hardin::FitReport (*)(std::span<const hardin::MeasuredModulus>,
                                          const hardin::FitOptions&);

/// A fit, or a remark.
std::optional<hardin::Fit> try_fit(FitFunction function, std::span<const hardin::MeasuredModulus> states,
                                   const hardin::FitOptions& options, std::string& remark) {
  try {
    const hardin::FitReport report = function(states, options);
    if (report.status() == hardin::FitStatus::converged)
      return report.fit();
    remark = "the fit did not converge";
  } catch (const InvalidArgument& error) {
    remark = error.what();
  }
  return std::nullopt;
}

/// Largest over smallest product of the two stresses, as a stress.
double stress_range(std::span<const hardin::MeasuredModulus> states) {
  double low = 0, high = 0;
  for (const hardin::MeasuredModulus& m : states) {
    const double stress = std::sqrt(m.state.stress_i) * std::sqrt(m.state.stress_j);
    low = low == 0 ? stress : std::min(low, stress);
    high = std::max(high, stress);
  }
  return low > 0 ? high / low : 0;
}

/// Whether both exponents are accurate enough to be separated.
bool tells_apart(const hardin::Fit& fit) {
  constexpr double too_vague = 0.3;
  const auto vague = [&](const std::optional<Measured>& m) {
    return !m || !(m->standard_error <= too_vague);
  };
  return !vague(fit.exponent_i) && !vague(fit.exponent_j);
}

} // namespace

SeriesFit fit_series(std::span<const hardin::MeasuredModulus> states, double atmospheric_pressure) {
  require_positive("atmospheric_pressure", atmospheric_pressure, "Pa");
  constexpr double varies = 1.1;
  SeriesFit out{.states = states.size(), .sum = {}, .sum_with_void_ratio = {}, .separate = {}, .remark = {}};
  if (states.size() < 3) {
    out.remark = "exponents need at least 3 states";
    return out;
  }
  if (!(stress_range(states) >= varies)) {
    out.remark = "the stress hardly varies: no exponents";
    return out;
  }
  hardin::FitOptions options{.atmospheric_pressure = atmospheric_pressure,
                             .void_ratio_function = hardin::VoidRatioFunction::none};
  std::string ignored;
  out.sum = try_fit(hardin::fit_exponent_sum, states, options, out.remark);
  out.separate = try_fit(hardin::fit, states, options, out.separate_remark);
  if (out.separate && !tells_apart(*out.separate)) {
    out.separate.reset();
    out.separate_remark = "the two stresses change together: m and n cannot be separated";
  }
  options.void_ratio_function = hardin::VoidRatioFunction::hardin_richart_round;
  out.sum_with_void_ratio = try_fit(hardin::fit_exponent_sum, states, options, ignored);
  return out;
}

} // namespace granum::studies
