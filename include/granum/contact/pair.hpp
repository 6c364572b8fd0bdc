// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <type_traits>

#include <granum/contact/power_law.hpp>
#include <granum/contact/shape.hpp>
#include <granum/core/mean.hpp>

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

/// Whether the law of a pair depends on the sizes of its grains. A sphere's curvature is its size. The
/// profile of a cone, a flat contact or a power law is one of the surface, A_alpha being given in absolute
/// terms: all grains have the same, so that pairs of all sizes have the law of two equal grains.
[[nodiscard]] constexpr bool depends_on_size(Shape shape) noexcept { return shape == Shape::sphere; }

/// The unchecked kernel of two grains of these sizes, radii over that of the kernel's two equal grains [1]:
/// c goes as the root of the pair's radius for spheres, alpha = 2, and is the same for all others.
/// Assumes   sizes > 0.
/// Accuracy  3 ulp; exactly the kernel where both sizes are 1.  Checked by tests/contact/test_pair.cpp
template <class Kernel>
[[nodiscard]] Kernel of_sizes(Kernel kernel, [[maybe_unused]] double i, [[maybe_unused]] double j) noexcept {
  if constexpr (std::is_same_v<Kernel, SphereKernel>)
    kernel.coefficient *= std::sqrt(pair_radius(i, j));
  return kernel;
}

/// The same of a law.
/// \throws   InvalidArgument if a size is not positive and finite
/// Accuracy  as above.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] PowerLaw of_sizes(const PowerLaw& law, double i, double j);

/// The one material of two grains whose contact is that of two different ones, normal and tangential alike:
/// G/(1-nu) = 2/((1-nu_i)/G_i + (1-nu_j)/G_j) and G/(2-nu) = 2/((2-nu_i)/G_i + (2-nu_j)/G_j).
///                                                                                  [Hertz1882; Mindlin1949]
/// Assumes   no coupling of normal and tangential displacement, which unlike materials have a little of.
/// \throws   InvalidArgument if a material is out of range
/// Accuracy  4 ulp; exactly the material of two equal grains.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] GrainMaterial pair_material(const GrainMaterial& i, const GrainMaterial& j);

} // namespace granum::contact
