// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/check.hpp>
#include <granum/effective/hertz_mindlin.hpp>

namespace granum::effective {

inline void require_grain(const contact::GrainMaterial& grain) {
  require_positive("grain_shear_modulus", grain.shear_modulus, "Pa");
  require_poisson_ratio("grain_poisson_ratio", grain.poisson_ratio);
}

inline void require_valid(const SpherePack& pack) {
  require_grain(pack.grain);
  require_open("porosity", pack.porosity, 0, 1);
  require_non_negative("coordination_number", pack.coordination_number);
  require_non_negative("pressure", pack.pressure, "Pa");
}

/// k_t/k_n of a packing in which that share of the contacts does not slip.
inline double slipping_ratio(const contact::GrainMaterial& grain, double no_slip_share) {
  require_closed("no_slip_share", no_slip_share, 0, 1);
  return no_slip_share * (2 * (1 - grain.poisson_ratio) / (2 - grain.poisson_ratio));
}

/// C_n (1-porosity) G_g/(1-nu_g) [Pa]: the density of contacts times their material.
inline double contact_modulus(const SpherePack& pack) {
  return pack.coordination_number * (1 - pack.porosity) *
         (pack.grain.shear_modulus / (1 - pack.grain.poisson_ratio));
}

} // namespace granum::effective
