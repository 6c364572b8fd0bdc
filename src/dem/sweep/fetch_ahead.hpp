// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Prefetches the next data of a sweep if its grains exceed the caches. Results do not
// change.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "contact_sweep.hpp"
#include "core/vector/level.hpp"
#include "grain_rows.hpp"
#include "partition.hpp"

namespace granum::dem {

/// The rows of this many grains fit into the second cache; there prefetching costs more than it saves.
inline constexpr std::size_t grains_nearby = 16384;

template <class T>
GRANUM_INLINE void fetch_lines(const T* first, std::size_t count) {
  constexpr std::size_t line = 64;
  const auto* const bytes = reinterpret_cast<const char*>(first);
  for (std::size_t k = 0; k < count * sizeof(T); k += line)
    __builtin_prefetch(bytes + k);
}

GRANUM_INLINE void fetch_grain(const Grains& grains, RowPlace g) {
  __builtin_prefetch(&row_at(grains.row.data(), g));
  __builtin_prefetch(&row_at(grains.spin_y.data(), g));
}
GRANUM_INLINE void fetch_grain(const TranslatingGrains& grains, RowPlace g) {
  __builtin_prefetch(&row_at(grains.place.data(), g));
}

/// Called for the block of pairs that begins at `first`: prefetches the data of the next block, and the pairs
/// of the one after.
/// \param    memory   null: frictionless
template <class AnyGrains, class Load>
GRANUM_INLINE void fetch_ahead(const ListedPair* pairs, const AnyGrains& grains, const MemoryBlock* memory,
                               const Load* load, std::size_t first, const Chunk& chunk) {
  const std::size_t last = chunk.pairs.end - block_size;
  const std::size_t next = std::min(first + block_size, last);
  for (std::size_t k = next; k < next + block_size; ++k) {
    fetch_grain(grains, pairs[k].j());
    __builtin_prefetch(&row_at(load, pairs[k].row()), 1);
  }
  if (memory != nullptr)
    fetch_lines(memory + next / block_size, 1);
  fetch_lines(pairs + std::min(first + 3 * block_size, last), block_size);
}

} // namespace granum::dem
