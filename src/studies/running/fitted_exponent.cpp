// SPDX-License-Identifier: GPL-3.0-or-later
#include "fitted_exponent.hpp"

namespace granum::studies {

std::optional<Measured> fitted_exponent(const std::vector<hardin::MeasuredModulus>& rows,
                                        hardin::VoidRatioFunction function) {
  if (rows.size() < 3)
    return std::nullopt;
  const hardin::FitReport report = hardin::fit_exponent_sum(
      rows,
      {.atmospheric_pressure = 100e3, .void_ratio_function = function, .weights = hardin::Weights::absolute});
  if (report.status() != hardin::FitStatus::converged)
    return std::nullopt; // states too near to each other to have a slope
  const Measured& s = report.fit().exponent_sum;
  return Measured{s.value, s.standard_error};
}

} // namespace granum::studies
