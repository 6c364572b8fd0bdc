// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <granum/dem/specimen.hpp>

#include "specimens.hpp"

/// Packings that benchmarks keep in files, as LAMMPS data: equal spheres of quartz in a periodic cell.
namespace granum::bench {

inline constexpr double friction = 0.5; ///< [1]

/// A count given on the command line.
/// \throws   std::invalid_argument
[[nodiscard]] std::size_t count_of(const std::string& text);

/// Centres and cell; at rest, without histories.
[[nodiscard]] dem::Specimen load_packing(const std::filesystem::path& path);
void save_packing(const dem::Specimen& state, const std::filesystem::path& path);

} // namespace granum::bench
