// SPDX-License-Identifier: GPL-3.0-or-later
// What the relaxed estimate is made of besides the uniform-strain stiffness, with slopes and errors: for
// relaxed() and for its derivatives.
#pragma once

#include <granum/effective/state.hpp>

namespace granum::effective::kernel {

/// A relaxation factor; all zero where the packing is not rigid.
struct RelaxingFactor {
  double value = 0;
  double error = 0;           ///< relative standard error
  double by_coordination = 0; ///< d value/d z*
  double by_ratio = 0;        ///< d value/d r
  double by_exponent = 0;     ///< d value/d b
};

struct RelaxingFactors {
  RelaxingFactor shear;
  RelaxingFactor bulk;
};

/// Both factors at z* >= 0, r >= 0, 0 <= b <= 0.5, not checked.
/// \param    branch_variance   as the kernel's function of that name; 0 of equal grains
RelaxingFactors relaxing_factors(double z, double r, double b, double branch_variance);

/// ln of the stretch along the axis.
struct Stretch {
  double logarithm = 0;
  double error = 0; ///< standard error of the logarithm
  double by_shear = 0;
  double by_exponent = 0;
  double by_fabric = 0;     ///< by a
  double by_log_stress = 0; ///< by ln(stress_v/stress_h)
};

/// Factors and stretch of a state, their errors complete with what unequal stresses add.
struct RelaxedParts {
  RelaxingFactor shear;
  RelaxingFactor bulk;
  Stretch stretch;
};

/// b of the state's contacts, or the largest that the factors are calibrated with.
/// Assumes   a valid state.
double calibrated_exponent(const State& state);

/// Assumes   a valid state and z* >= 0.
RelaxedParts relaxed_parts(const State& state, double z);

} // namespace granum::effective::kernel
