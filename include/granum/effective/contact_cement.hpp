// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/validity.hpp>
#include <granum/effective/hertz_mindlin.hpp>

namespace granum::effective {

/// Where the cement lies.
enum class CementPlace {
  at_contacts, ///< "scheme 1": all of it around the contacts
  on_surfaces  ///< "scheme 2": in a layer of even thickness on the grains
};

/// Spheres cemented at their contacts. The pressure plays no part: cement carries the load.
struct CementedPack {
  contact::GrainMaterial grain;              ///< of the spheres
  contact::GrainMaterial cement;             ///< poisson_ratio below 0.5
  double critical_porosity = State::unset;   ///< of the packing without cement, in (0, 1)
  double porosity = State::unset;            ///< what the cement has left of it, from 0 to critical_porosity
  double coordination_number = State::unset; ///< C_n > 0, over all grains
  CementPlace place = CementPlace::at_contacts;
};

/// Moduli, and what is to be said of them.
struct CementedModuli {
  IsotropicModuli moduli;
  Validity validity;
};

/// Radius of the cement over that of the grain: 2 (d/(3 C_n (1-phi_0)))^(1/4) at the contacts,
/// (2 d/(3 (1-phi_0)))^(1/2) on the surfaces, d the porosity that it fills.                  [DvorkinNur1996]
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  8 ulp.  Checked by tests/effective/test_contact_cement.cpp
[[nodiscard]] double cement_radius_ratio(const CementedPack& pack);

/// K = C_n (1-phi_0) M_c S_n/6, G = 3 K/5 + 3 C_n (1-phi_0) G_c S_t/20 with M_c = K_c + 4 G_c/3 and the
/// regressions S_n, S_t of the stiffness of cemented contacts.                               [DvorkinNur1996]
/// Assumes   uniform strain; contacts bonded all over by the cement.
/// \return   with notes if the cement reaches beyond the grains' radius, or if the regression makes the
///           packing stiffer than the upper bound of grains and cement: it was fitted to cements that are not
///           many times softer than the grains
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_contact_cement.cpp
[[nodiscard]] CementedModuli contact_cement(const CementedPack& pack);

} // namespace granum::effective
