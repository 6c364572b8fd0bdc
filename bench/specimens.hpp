// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/dem/state.hpp>

/// Packings that the engine is measured on.
namespace granum::bench {

inline constexpr double pressure = 1e5; ///< [Pa]

/// Quartz spheres with Hertz-Mindlin contacts.
[[nodiscard]] dem::Material material(double friction);

/// A dense specimen of 1,000 grains at that pressure, without histories.
[[nodiscard]] dem::State thousand_grains();

/// A periodic specimen so many times along each axis; each copy moves its own way, by some mm/s.
[[nodiscard]] dem::State repeated(const dem::State& one, int nx, int ny, int nz);

} // namespace granum::bench
