// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and numbers of grains and contacts.
#pragma once

#include <cstddef>

#include <granum/analysis/measurement.hpp>

namespace granum::analysis {

[[nodiscard]] Sizes sizes_of(const packing::Assembly& assembly);

/// \param    assembly   of bodies
/// \param    grains   that form them
[[nodiscard]] Counts counts_of(const packing::Assembly& assembly, std::size_t grains);

} // namespace granum::analysis
