// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/io. What files of grains need of their numbers.
#pragma once

#include <cstddef>
#include <span>

#include <granum/io/grain_fields.hpp>

namespace granum::io {

/// \throws   InvalidArgument as grains_xyz
void require_numbers(const packing::Assembly& assembly, std::span<const long> id,
                     std::span<const GrainField> fields = {});

[[nodiscard]] inline long id_of(std::span<const long> id, std::size_t grain) {
  return id.empty() ? static_cast<long>(grain) : id[grain];
}

} // namespace granum::io
