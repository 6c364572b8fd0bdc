// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/power_law.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>

namespace granum::effective {

/// A random packing of equal elastic spheres, as the models of rock physics describe it. Their moduli do not
/// depend on the size of the spheres.
struct SpherePack {
  contact::GrainMaterial grain;              ///< of the spheres
  double porosity = State::unset;            ///< voids in the volume, in (0, 1); e/(1+e)
  double coordination_number = State::unset; ///< C_n >= 0, over all grains
  double pressure = State::unset;            ///< effective pressure p >= 0 [Pa]
};

/// Moduli of Hertz and Mindlin's contacts under uniform strain:
/// K = [C_n^2 (1-porosity)^2 G_g^2 p/(18 pi^2 (1-nu_g)^2)]^(1/3), G = 3 (2 + 3 r)/10 K with
/// r = no_slip_share 2 (1-nu_g)/(2-nu_g). The same as uniform_strain of a State of spheres: upper bounds of
/// the moduli of the frozen packing. [Digby1981; Walton1987]
/// \param    no_slip_share   contacts with Mindlin's tangential stiffness, the others having none, in [0, 1]:
///           1 is Walton's infinitely rough packing, 0 his smooth one; in between G is mixed linearly
/// \return   exactly 0 for p = 0 or C_n = 0
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  8 ulp.  Checked by tests/effective/test_hertz_mindlin.cpp and validation/accuracy
[[nodiscard]] IsotropicModuli hertz_mindlin(const SpherePack& pack, double no_slip_share = 1);

} // namespace granum::effective
