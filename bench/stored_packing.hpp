// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <granum/dem/specimen.hpp>
#include <granum/packing/assembly.hpp>

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

/// Its contacts. Copies would answer like one: there the stiffness of each contact is multiplied by a random
/// number between 1/2 and 3/2.
[[nodiscard]] packing::Assembly network_of(const dem::Specimen& state, bool copies);

} // namespace granum::bench
