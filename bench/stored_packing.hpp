// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <granum/dem/state.hpp>

/// Packings that benchmarks keep in files, as LAMMPS data: equal spheres of quartz in a periodic cell.
namespace granum::bench {

inline constexpr double radius = 5e-4;  ///< [m]
inline constexpr double friction = 0.5; ///< [1]
inline constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};

/// Hertz-Mindlin contacts.
[[nodiscard]] dem::Material sphere_material();

/// A count given on the command line.
/// \throws   std::invalid_argument
[[nodiscard]] std::size_t count_of(const std::string& text);

/// Centres and cell; at rest, without histories.
[[nodiscard]] dem::State load_packing(const std::filesystem::path& path);
void save_packing(const dem::State& state, const std::filesystem::path& path);

/// So many copies along each axis, without histories.
[[nodiscard]] dem::State side_by_side(const dem::State& one, std::size_t nx, std::size_t ny, std::size_t nz);

} // namespace granum::bench
