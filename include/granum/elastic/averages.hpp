// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// Isotropic averages of an anisotropic material over all its orientations, as in a polycrystal of it.
/// Checked by tests/elastic/test_averages.cpp
namespace granum::elastic {

/// Voigt averages the stiffness (equal strain, an upper bound of K and of G), Reuss the compliance (equal
/// stress, a lower bound), Hill is the mean of the two moduli.                                    [Hill1952]
/// Both moduli are in the order voigt >= hill >= reuss: where the material is isotropic to the last digits,
/// rounding is kept from turning it.
struct IsotropicAverages {
  Isotropic voigt;
  Isotropic hill;
  Isotropic reuss;
};

/// Averages of a full stiffness.
/// \throws   InvalidArgument unless the stiffness is finite, symmetric (mandel.hpp) and positive definite
///           (smallest eigenvalue above 1e-12 of the largest)
/// Accuracy  voigt 4 ulp of the largest entry, reuss 8 ulp times the condition number.
[[nodiscard]] IsotropicAverages isotropic_averages(const VoigtStiffness& stiffness);

/// Averages of a transversely isotropic stiffness, in closed form.
/// \throws   InvalidArgument unless the stiffness is finite and positive definite
/// Accuracy  voigt 4 ulp of the largest entry, reuss 8 ulp times the condition number.
[[nodiscard]] IsotropicAverages isotropic_averages(const TransverselyIsotropic& stiffness);

} // namespace granum::elastic
