// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/pair.hpp>

#include <granum/core/error.hpp>

namespace granum::contact {

NormalLaw of_sizes(const NormalLaw& law, double i, double j) {
  require_positive("size of a grain", i);
  require_positive("size of a grain", j);
  return law.of_pair_radius(pair_radius(i, j));
}

GrainMaterial pair_material(const GrainMaterial& i, const GrainMaterial& j) {
  for (const GrainMaterial& grain : {i, j}) {
    require_positive("grain_shear_modulus", grain.shear_modulus, "Pa");
    require_poisson_ratio("grain_poisson_ratio", grain.poisson_ratio);
  }
  if (i.shear_modulus == j.shear_modulus && i.poisson_ratio == j.poisson_ratio)
    return i;
  // Both conditions are linear in the compliance s = 1/G and in nu s: s - nu s and 2 s - nu s are the means
  // of the two grains'.
  const double share = j.shear_modulus / (i.shear_modulus + j.shear_modulus); // of 1/G_i in the sum of both
  return {.shear_modulus = harmonic_mean(i.shear_modulus, j.shear_modulus),
          .poisson_ratio = share * i.poisson_ratio + (1 - share) * j.poisson_ratio};
}

} // namespace granum::contact
