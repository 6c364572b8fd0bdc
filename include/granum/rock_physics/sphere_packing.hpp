// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include <granum/core/error.hpp>

/// Common part of the classical closed forms: equal elastic spheres with Hertz contacts, and the moduli
/// that come out.
namespace granum::rock_physics {

/// An isotropic packing of equal spheres under mean pressure, as the classical models see it. A number that
/// is left out stays NaN and is refused by name.
struct SpherePacking {
  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

  double shear_modulus = unset;       ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = unset;       ///< nu_g of the grain, -1 < nu_g <= 0.5
  double porosity = unset;            ///< pore volume by total volume, in [0, 1)
  double coordination_number = unset; ///< C_n = 2 N_c/N >= 0
  double pressure = unset;            ///< p >= 0, effective, compression positive [Pa]
  double no_slip_fraction = 1;        ///< share of no-slip contacts in [0, 1]: 1 rough, 0 smooth grains
};

/// Moduli of an isotropic packing. Unlike elastic::Isotropic it may contain zeros, for an unloaded packing.
struct IsotropicEstimate {
  double bulk_modulus = 0;  ///< K >= 0 [Pa]
  double shear_modulus = 0; ///< G >= 0 [Pa]
  Validity validity;
};

/// Checks every member of a packing.
/// \throws   InvalidArgument naming the first member that no packing can have
/// \return   notes if C_n > 12, if no contact carries the pressure, or if the contact radius exceeds a tenth
///           of the grain radius, as it does when modulus and pressure are given in different units
/// Checked by tests/rock_physics/test_hertz_mindlin.cpp
Validity require_valid(const SpherePacking& packing);

} // namespace granum::rock_physics
