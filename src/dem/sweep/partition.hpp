// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Grains and pairs in chunks that threads can work off side by side. Chunks follow from
// grains and pairs alone, each adds up in its own order, and what they give is added in their order: any
// number of threads gives the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/dem/neighbours.hpp>

#include "row_place.hpp"

namespace granum::dem {

/// Pairs are worked off in blocks of this many, so that each law is one vectorised loop over a block: enough
/// of them that one vector's chain of products waits while others go on. Sums run eight pairs at a time,
/// whatever the width of vectors and of blocks.
inline constexpr std::size_t block_size = 64;

/// Image of the pairs that fill up the last block of a chunk: far out of reach.
inline constexpr RowPlace far_image = RowPlace::of(image_count);

/// A pair, and the row of loads that takes the force on j: that of j, or, where j is in another chunk, a
/// spare row after those of all grains.
class ListedPair {
 public:
  constexpr ListedPair(RowPlace i, RowPlace j, RowPlace image, RowPlace row)
      : j_and_image_(j, image), i_and_row_(i, row) {}
  GRANUM_INLINE RowPlace i() const { return i_and_row_.low(); }
  GRANUM_INLINE RowPlace j() const { return j_and_image_.low(); }
  /// Among the shifts of all images.
  GRANUM_INLINE RowPlace image() const { return j_and_image_.high(); }
  GRANUM_INLINE RowPlace row() const { return i_and_row_.high(); }

 private:
  TwoPlaces j_and_image_, i_and_row_; // what branches ask for besides i, and what forces ask for
};

/// Half-open ranges.
struct Range {
  std::size_t begin = 0, end = 0;
};

/// Some grains that follow each other, the pairs whose i is one of them, in whole blocks, the spare rows that
/// these pairs fill, and the range of Partition::additions that adds spare rows of earlier chunks to the
/// grains.
struct Chunk {
  Range grains, pairs, spare_rows, additions;
};

/// Spare row `row` holds forces on `grain` and is to be added to that grain's own row.
struct Addition {
  std::uint32_t row, grain;
};

struct Partition {
  std::vector<Chunk> chunks;
  std::vector<ListedPair> pairs;
  std::vector<Addition> additions; ///< by the chunk of their grain
  std::size_t rows = 0;            ///< of loads: one a grain, and the spare ones

  /// Number of the chunk that a grain is in.
  [[nodiscard]] std::size_t chunk_of(std::uint32_t grain) const;
};

/// \param    pairs   sorted by (i, j), i < j
/// \throws   InvalidArgument beyond RowPlace::most_rows, 5e8 grains
[[nodiscard]] Partition partition(const std::vector<Pair>& pairs, std::size_t grains);

} // namespace granum::dem
