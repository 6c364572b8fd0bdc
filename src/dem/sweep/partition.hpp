// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Grains and pairs in chunks for threads. Chunks depend on grains and pairs only, each
// sums in its own order, and their results are added in their order: the same bits for any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <granum/dem/neighbours.hpp>

#include "core/vector/level.hpp"

namespace granum::dem {

/// Position of a row among others: eight times its number. Rows have 1, 2, 4 or 8 numbers, so the offset of a
/// row is this times 1, 2, 4 or 8 bytes, which a processor computes as part of an address. The plain number
/// would need a shift for each row of each pair.
struct RowPlace {
  std::uint32_t eightfold;

  static constexpr std::size_t most_rows = std::numeric_limits<std::uint32_t>::max() / 8;

  static constexpr RowPlace of(std::uint32_t number) { return {8 * number}; }
  [[nodiscard]] constexpr std::uint32_t number() const { return eightfold / 8; }
  bool operator==(const RowPlace&) const = default;
};

/// Two positions in one number, to save reads, which limit the loops over pairs.
class TwoPlaces {
 public:
  constexpr TwoPlaces(RowPlace low, RowPlace high)
      : both_(std::uint64_t{high.eightfold} << 32 | low.eightfold) {}
  GRANUM_INLINE RowPlace low() const { return {static_cast<std::uint32_t>(both_)}; }
  GRANUM_INLINE RowPlace high() const { return {static_cast<std::uint32_t>(both_ >> 32)}; }

 private:
  std::uint64_t both_;
};

/// \param    first   address of the first row
template <class Row>
GRANUM_INLINE Row& row_at(Row* first, RowPlace place) {
  constexpr std::size_t factor = sizeof(Row) / 8;
  static_assert(factor == 1 || factor == 2 || factor == 4 || factor == 8);
  using Bytes = std::conditional_t<std::is_const_v<Row>, const char, char>;
  return *reinterpret_cast<Row*>(reinterpret_cast<Bytes*>(first) + factor * place.eightfold);
}

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
