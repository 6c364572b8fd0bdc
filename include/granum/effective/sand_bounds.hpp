// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/hertz_mindlin.hpp>
#include <granum/elastic/isotropic.hpp>

/// Sands less porous than a packing of spheres, between the packing and the mineral: modified bounds of
/// Hashin and Shtrikman. They are models of a sand, not bounds of its moduli.
namespace granum::effective {

/// A sand whose end member is a packing of spheres at the critical porosity.
struct Sand {
  SpherePack end_member;          ///< its porosity is the critical one
  double no_slip_share = 1;       ///< of the end member, see hertz_mindlin
  double porosity = State::unset; ///< of the sand, from 0 to the critical one
};

/// Lower modified bound: the softer phase surrounds the other, as if small grains fell into the pores
/// ("soft", "friable" or "uncemented" sand).                                         [DvorkinNur1996]
/// \return   exactly the end member at the critical porosity, exactly the mineral at 0; 0 at p = 0 between
/// \throws   InvalidArgument if a member is out of its range; above the critical porosity
/// Accuracy  16 ulp.  Checked by tests/effective/test_sand_bounds.cpp
[[nodiscard]] IsotropicModuli soft_sand(const Sand& sand);

/// Upper modified bound: the mineral surrounds the packing, as if cement grew at the contacts first. At least
/// soft_sand.                                                                        [DvorkinNur1996]
/// \throws   InvalidArgument as soft_sand
/// Accuracy  16 ulp.  Checked by tests/effective/test_sand_bounds.cpp
[[nodiscard]] IsotropicModuli stiff_sand(const Sand& sand);

/// The curve of the lower modified bound through a known point of higher porosity, such as a cemented sand
/// ("constant cement").                                                              [DvorkinNur1996]
/// \param    point      moduli at point_porosity, both positive [Pa]
/// \param    porosity   from 0 to point_porosity
/// \throws   InvalidArgument if an argument is out of its range
/// Accuracy  16 ulp.  Checked by tests/effective/test_sand_bounds.cpp
[[nodiscard]] IsotropicModuli sand_below(const IsotropicModuli& point, double point_porosity,
                                         const contact::GrainMaterial& grain, double porosity);

} // namespace granum::effective
