// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/rock_physics/sphere_packing.hpp>

namespace granum::rock_physics {

/// Ratio to the uniform-strain shear modulus if pairs of frictionless spheres may deviate from the
/// mean strain: a function of the coordination number alone, 0.30 at k = 6. The published coefficients have
/// two digits; those of the bulk modulus could not be confirmed (as coded in public they lift it above its
/// upper bound) and are left out.                                                             [Jenkins2005]
/// \param    coordination_number   k in [5.1, 11]: below, the expansion turns G negative; above, it passes
///           the upper bound 1
/// \throws   InvalidArgument outside that range
/// Accuracy  1e-13 absolute, of the published polynomials.  Checked by tests/rock_physics/test_jenkins.cpp
[[nodiscard]] double jenkins_shear_factor(double coordination_number);

/// Shear modulus of an isotropic aggregate of identical frictionless spheres with pair fluctuations [Pa]:
/// that of the smooth packing by hertz_mindlin times jenkins_shear_factor.                    [Jenkins2005]
/// \param    packing   with no_slip_fraction = 0, the only contacts that the theory is made for
/// \throws   InvalidArgument as require_valid(SpherePacking) and jenkins_shear_factor, and for
///           no_slip_fraction other than 0
/// Accuracy  as jenkins_shear_factor.  Checked by tests/rock_physics/test_jenkins.cpp
[[nodiscard]] double jenkins_shear_modulus(const SpherePacking& packing);

} // namespace granum::rock_physics
