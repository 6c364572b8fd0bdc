// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// Z(x) = <f_n^x>/<f_n>^x over the contacts that carry force.                             [AgnolinRoux2007c]
/// Assumes   f_n >= 0; contacts with f_n = 0 are left out.
/// \param    exponent  x, any finite number [1]
/// \throws   InvalidArgument if a contact is in tension, or none carries force
/// Checked by tests/packing/test_force_moments.cpp
[[nodiscard]] double normal_force_moment(const Assembly& assembly, double exponent);

/// Two-sided bound on a bulk modulus [Pa].
struct BulkModulusBounds {
  double lower = 0;
  double upper = 0;
};

/// K_Reuss <= K <= K_Voigt from the forces and stiffnesses of the present state, any contact law: upper
/// (1/(9V)) sum k_n l^2 (uniform strain), lower p^2 V/sum (f_n^2/k_n + f_t^2/k_t) (forces scaled with p).
///                                                                                        [AgnolinRoux2007c]
/// Assumes   isotropic stress; grains in force and moment equilibrium (else the lower value is only an
///           estimate); no prestress term, contacts sticking. Contacts that carry no force count in the upper
///           bound only.
/// \return   zeros without contacts; lower = 0 if a contact has a force without the corresponding stiffness
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Accuracy  rounding.  Checked by tests/packing/test_force_moments.cpp,
/// tests/network/test_linear_response.cpp
[[nodiscard]] BulkModulusBounds bulk_modulus_bounds(const Assembly& assembly);

} // namespace granum::packing
