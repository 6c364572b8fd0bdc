// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/normal_law.hpp>
#include <granum/core/statistics.hpp>

/// Two grains that differ, as two that are equal: every law of this module is one of equal grains.
namespace granum::contact {

/// Radius of the two equal spheres that touch as a pair of unequal ones does, 2 R* with 1/R* = 1/R_i + 1/R_j:
/// their contact has the same law, PowerLaw::sphere of this radius. [Hertz1882]
/// Assumes   radii > 0 [m], not checked: sweeps call it for every contact.
/// \return   2 R* [m]; exactly R of two equal grains
/// Accuracy  2 ulp.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] constexpr double pair_radius(double radius_i, double radius_j) noexcept {
  return harmonic_mean(radius_i, radius_j);
}

/// The unchecked kernel of two grains of these sizes, radii over that of the kernel's two equal grains [1]:
/// the kernel itself where it does not depend on them.
/// Assumes   sizes > 0.
/// Accuracy  3 ulp; exactly the kernel where both sizes are 1.  Checked by tests/contact/test_pair.cpp
template <class Kernel>
requires requires(const Kernel& kernel) { kernel(0.0); }
[[nodiscard]] Kernel of_sizes(Kernel kernel, [[maybe_unused]] double i, [[maybe_unused]] double j) noexcept {
  if constexpr (requires { kernel.of_pair_radius(i); })
    return kernel.of_pair_radius(pair_radius(i, j));
  else
    return kernel;
}

/// The same of a law.
/// \throws   InvalidArgument if a size is not positive and finite
/// Accuracy  as above.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] NormalLaw of_sizes(const NormalLaw& law, double i, double j);

/// The one material of two grains whose contact is that of two different ones, normal and tangential alike:
/// G/(1-nu) = 2/((1-nu_i)/G_i + (1-nu_j)/G_j) and G/(2-nu) = 2/((2-nu_i)/G_i + (2-nu_j)/G_j).
///                                                                                  [Hertz1882; Mindlin1949]
/// Assumes   no coupling of normal and tangential displacement, which unlike materials have a little of.
/// \throws   InvalidArgument if a material is out of range
/// Accuracy  4 ulp; exactly the material of two equal grains.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] GrainMaterial pair_material(const GrainMaterial& i, const GrainMaterial& j);

} // namespace granum::contact
