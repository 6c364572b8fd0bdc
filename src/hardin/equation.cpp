// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/equation.hpp>

#include <cmath>

#include <granum/core/error.hpp>

namespace granum::hardin {

double shear_modulus(const Equation& equation, const SoilState& state) {
  const double pa = require_positive("atmospheric_pressure", equation.atmospheric_pressure, "Pa");
  const double c = require_positive("coefficient", equation.coefficient);
  const double m = require_finite("exponent_i", equation.exponent_i);
  const double n = require_finite("exponent_j", equation.exponent_j);
  const double si = require_positive("stress_i", state.stress_i, "Pa");
  const double sj = require_positive("stress_j", state.stress_j, "Pa");
  return c * pa * void_ratio_value(equation.void_ratio_function, state.void_ratio) * std::pow(si / pa, m) *
         std::pow(sj / pa, n);
}

} // namespace granum::hardin
