// SPDX-License-Identifier: GPL-3.0-or-later
// What the closed forms say of a packing of validation/gradation.
#pragma once

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/sizes/contact_means.hpp>
#include <granum/sizes/distribution.hpp>

namespace gradation {

using namespace granum;

/// K of rung 3, and G of the nearest isotropic solid, three ways [Pa].
struct ClosedForms {
  double uniform_strain = 0;     ///< rung 2, means over contacts as they were counted
  double relaxed = 0;            ///< rung 3 of the same
  double stated_error = 0;       ///< of the latter, over it [1]
  double bulk_modulus = 0;       ///< K of the same, which has no record: it is worked out again
  double stated_bulk_error = 0;  ///< of the latter, over it [1]
  double relaxed_from_sizes = 0; ///< rung 3, means over contacts from the distribution and the rattlers
};

inline double isotropic_shear_modulus(const elastic::TransverselyIsotropic& stiffness) {
  return elastic::isotropic_projection(elastic::voigt(stiffness)).shear_modulus();
}

/// \param    counted       the state with the means over contacts as they were counted
/// \param    mean_radius   of the distribution, by number [m]
inline ClosedForms closed_forms(const effective::State& counted, double z_star, double rattler_fraction,
                                const sizes::Distribution& distribution, double mean_radius) {
  effective::State from_sizes = counted;
  from_sizes.radius = mean_radius;
  from_sizes.contacts = sizes::expected_contact_means(distribution, rattler_fraction);
  from_sizes.law =
      contact::PowerLaw::sphere(counted.law.grain(), mean_radius * from_sizes.contacts.pair_radius);
  const effective::RelaxedEstimate relaxed = effective::relaxed(counted, z_star);
  if (!(relaxed.stiffness.C44 > 0))
    throw InvalidArgument("z* = " + short_text(z_star, 3) + " is so low that rung 3 has no stiffness");
  return {.uniform_strain = isotropic_shear_modulus(effective::uniform_strain(counted).stiffness),
          .relaxed = isotropic_shear_modulus(relaxed.stiffness),
          .stated_error = (relaxed.relative_error.G_hh + relaxed.relative_error.G_vh) / 2,
          .bulk_modulus = relaxed.stiffness.bulk_modulus(),
          .stated_bulk_error = relaxed.relative_error.bulk_modulus,
          .relaxed_from_sizes = isotropic_shear_modulus(effective::relaxed(from_sizes, z_star).stiffness)};
}

} // namespace gradation
