// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <granum/dem/specimen.hpp>
#include <granum/sizes/distribution.hpp>

/// Packings that the engine is measured on.
namespace granum::bench {

inline constexpr double radius = 5e-4;  ///< [m]
inline constexpr double pressure = 1e5; ///< [Pa]
inline constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};

/// Quartz spheres with Hertz-Mindlin contacts.
[[nodiscard]] dem::Material material(double friction);

/// A dense specimen of 1,000 grains at that pressure, without histories; between walls of that friction
/// coefficient [1], or periodic; of those sizes about `radius`.
[[nodiscard]] dem::Specimen thousand_grains(std::optional<double> wall_friction = {},
                                            sizes::Distribution sizes = sizes::Distribution::equal());

/// A periodic specimen so many times along each axis, at rest and without histories.
[[nodiscard]] dem::Specimen side_by_side(const dem::Specimen& one, std::size_t nx, std::size_t ny,
                                         std::size_t nz);

/// The same; each copy moves its own way, by some mm/s.
[[nodiscard]] dem::Specimen repeated(const dem::Specimen& one, std::size_t nx, std::size_t ny,
                                     std::size_t nz);

} // namespace granum::bench
