// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Grains and pairs in chunks for threads. Chunks depend on grains and pairs only, each
// sums in its own order, and their results are added in their order: the same bits for any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/dem/neighbours.hpp>

#include "row_place.hpp"

namespace granum::dem {

/// Pairs in a block; each law is one vectorised loop over a block. It is long enough that other vectors
/// proceed while the products of one wait. Sums run over eight pairs at a time for any width of vectors and
/// blocks.
inline constexpr std::size_t block_size = 64;

/// Image of the padding pairs of the last block of a chunk: far out of reach.
inline constexpr RowPlace far_image = RowPlace::of(image_count);

/// A pair, and the row of loads for the force on j: the row of j, or a spare row after those of all grains if
/// j is in another chunk.
class ListedPair {
 public:
  constexpr ListedPair(RowPlace i, RowPlace j, RowPlace image, RowPlace row)
      : j_and_image_(j, image), i_and_row_(i, row) {}
  GRANUM_INLINE RowPlace i() const { return i_and_row_.low(); }
  GRANUM_INLINE RowPlace j() const { return j_and_image_.low(); }
  /// Index among the shifts of all images.
  GRANUM_INLINE RowPlace image() const { return j_and_image_.high(); }
  GRANUM_INLINE RowPlace row() const { return i_and_row_.high(); }

 private:
  TwoPlaces j_and_image_, i_and_row_; // for branches (with i), and for forces
};

/// Half-open ranges.
struct Range {
  std::size_t begin = 0, end = 0;
};

/// Consecutive grains; the pairs whose i is one of them, in whole blocks; the spare rows of these pairs; and
/// the range of Partition::additions that adds spare rows of earlier chunks to the grains.
struct Chunk {
  Range grains, pairs, spare_rows, additions;
};

/// Spare row `row` contains forces on `grain` and is added to the row of that grain.
struct Addition {
  std::uint32_t row, grain;
};

struct Partition {
  std::vector<Chunk> chunks;
  std::vector<ListedPair> pairs;
  std::vector<Addition> additions; ///< by the chunk of their grain
  std::size_t rows = 0;            ///< number of rows of loads: one per grain, and the spare ones

  /// Number of the chunk that a grain is in.
  [[nodiscard]] std::size_t chunk_of(std::uint32_t grain) const;
};

/// \param    pairs   sorted by (i, j), i < j
/// \throws   InvalidArgument beyond RowPlace::most_rows, 5e8 grains
[[nodiscard]] Partition partition(const std::vector<Pair>& pairs, std::size_t grains);

} // namespace granum::dem
