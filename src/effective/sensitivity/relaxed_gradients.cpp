// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <granum/core/check.hpp>
#include <granum/effective/sensitivity/gradients.hpp>

#include "dual_moduli.hpp"
#include "effective/relaxation_kernel.hpp"
#include "relaxed_parts.hpp"

namespace granum::effective {

namespace {

using kernel::Constants;
using kernel::RelaxedParts;
using kernel::RelaxingFactor;
using kernel::Stretch;
using Dual = kernel::Dual<8>;
static_assert(Dual::DerType::RowsAtCompileTime == kernel::all_seeds);
using Slopes = Dual::DerType;

/// What relaxation works on, and what a Dual of this file is differentiated by until the chain rule.
enum Part { C11, C33, C12, C13, C44, bulk, shear, stretch };

/// The relaxed constants with their derivatives by Part.
Constants<Dual> relaxed_constants(const Constants<Dual>& uniform, const RelaxedParts& parts) {
  const auto variable = [](double value, Part part) { return Dual(value, kernel::all_seeds, part); };
  const kernel::RelaxedConstants<Dual> c =
      kernel::relax<Dual>({variable(uniform.C11.value(), C11), variable(uniform.C33.value(), C33),
                           variable(uniform.C12.value(), C12), variable(uniform.C13.value(), C13),
                           variable(uniform.C44.value(), C44)},
                          variable(parts.bulk.value, bulk), variable(parts.shear.value, shear),
                          variable(parts.stretch.logarithm, stretch));
  return {.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
}

/// Of a quantity that depends on the packing by way of r and b.
Slopes slopes_of(const State& s, double by_ratio, double by_exponent) {
  const double b = kernel::calibrated_exponent(s);
  Slopes slopes = Slopes::Zero();
  slopes[kernel::ratio] = by_ratio;
  slopes[kernel::shape] = -b * b * by_exponent; // b = 1/(1+alpha)
  return slopes;
}

Slopes slopes_of(const State& s, const RelaxingFactor& factor) {
  return slopes_of(s, factor.by_ratio, factor.by_exponent);
}

/// Of ln of the stretch at a given factor of G.
Slopes slopes_of(const State& s, const Stretch& by) {
  Slopes slopes = slopes_of(s, 0, by.by_exponent);
  slopes[kernel::anisotropy] = by.by_fabric;
  slopes[kernel::log_stress_v] = by.by_log_stress;
  slopes[kernel::log_stress_h] = -by.by_log_stress;
  return slopes;
}

double standard_error(const RelaxedParts& parts, const Slopes& by) {
  return std::hypot(by[bulk] * parts.bulk.value * parts.bulk.error,
                    by[shear] * parts.shear.value * parts.shear.error, by[stretch] * parts.stretch.error);
}

} // namespace

CalibratedGradient relaxed_gradient(const State& s, double mechanical_coordination_number, Modulus which) {
  kernel::require_differentiable(s, Hypothesis::uniform_strain, which);
  const double z = require_non_negative("mechanical_coordination_number", mechanical_coordination_number);
  const RelaxedParts parts = kernel::relaxed_parts(s, z);
  if (!(parts.shear.value > 0))
    throw InvalidArgument("mechanical_coordination_number", z, "", "above the isostatic point");
  const Constants<Dual> uniform = kernel::all_derivatives(s, {});
  const Constants<Dual> relaxed = relaxed_constants(uniform, parts);
  const Dual X = kernel::modulus(relaxed, which);
  const Slopes& by = X.derivatives();

  const double by_shear = by[shear] + by[stretch] * parts.stretch.by_shear;
  Slopes by_seeds = by[bulk] * slopes_of(s, parts.bulk) + by_shear * slopes_of(s, parts.shear) +
                    by[stretch] * slopes_of(s, parts.stretch);
  by_seeds += by[C11] * uniform.C11.derivatives() + by[C33] * uniform.C33.derivatives() +
              by[C12] * uniform.C12.derivatives() + by[C13] * uniform.C13.derivatives() +
              by[C44] * uniform.C44.derivatives();
  Gradient gradient = kernel::by_inputs(s, kernel::checked_modulus(relaxed, which), by_seeds);
  gradient[Input::mechanical_coordination_number] =
      by[bulk] * parts.bulk.by_coordination + by_shear * parts.shear.by_coordination;
  return {.gradient = gradient, .standard_error = standard_error(parts, by)};
}

} // namespace granum::effective
