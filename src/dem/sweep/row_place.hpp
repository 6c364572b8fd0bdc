// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

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

} // namespace granum::dem
