// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/rock_physics/sphere_packing.hpp>

/// Sands between a packing of clean spheres at its critical porosity and the solid mineral at porosity 0, by
/// modified Hashin-Shtrikman bounds: the packing has the volume fraction porosity/critical porosity.
namespace granum::rock_physics {

/// The lower bound: pore-filling fines, sorting. The packing surrounds the mineral.       [DvorkinNur1996]
/// \param    packing    end member by hertz_mindlin; its porosity > 0 is the critical one
/// \param    porosity   in [0, critical porosity]
/// \return   K and G [Pa]: at porosity 0 those of the mineral (K infinite for nu_g = 0.5), at the critical
///           porosity those of the packing, both exactly; 0 at p = 0 in between
/// \throws   InvalidArgument as require_valid(SpherePacking), and for a porosity out of its range
/// Accuracy  8 ulp.  Checked by tests/rock_physics/test_sand_bounds.cpp
[[nodiscard]] IsotropicEstimate soft_sand(const SpherePacking& packing, double porosity);

/// The upper bound: contacts stiffened by the mineral, which surrounds the packing.              [Gal1998]
/// Parameters, result and errors as soft_sand, but not 0 at p = 0.
/// Accuracy  8 ulp.  Checked by tests/rock_physics/test_sand_bounds.cpp
[[nodiscard]] IsotropicEstimate stiff_sand(const SpherePacking& packing, double porosity);

} // namespace granum::rock_physics
