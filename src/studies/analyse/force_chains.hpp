// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <granum/packing/assembly.hpp>

namespace granum::studies {

/// Force chains as SVG: the pressing contacts of a slice through the middle, seen along y with z upwards.
struct ForceChains {
  std::string svg;     ///< a file of its own
  std::string in_page; ///< a part of a page
  std::string finding;
};

/// Lines as wide as the normal force, those above the mean in colour; grains of the slice pale behind them.
/// The slice is four mean radii thick, and contains the contacts with their middle in it.
/// \return   empty if no contact of the slice carries force
/// Checked by tests/studies/test_force_chains.cpp
[[nodiscard]] std::optional<ForceChains> force_chains(const packing::Assembly& packing);

} // namespace granum::studies
