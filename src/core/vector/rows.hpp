// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Rows of eight numbers, one vector where the level has vectors of eight and two of four
// elsewhere, and their turning into columns: one number of each of several grains or pairs.
#pragma once

#include <cstddef>
#include <type_traits>

#include "level.hpp"

namespace granum {

struct Halves {
  Four low, high;
};
GRANUM_INLINE Halves operator+(const Halves& a, const Halves& b) { return {a.low + b.low, a.high + b.high}; }
GRANUM_INLINE Halves operator*(const Halves& a, const Halves& b) { return {a.low * b.low, a.high * b.high}; }

GRANUM_INLINE Four low(const Halves& row) { return row.low; }
GRANUM_INLINE Four high(const Halves& row) { return row.high; }
GRANUM_INLINE Four low(const Eight& row) { return __builtin_shufflevector(row, row, 0, 1, 2, 3); }
GRANUM_INLINE Four high(const Eight& row) { return __builtin_shufflevector(row, row, 4, 5, 6, 7); }

/// Rows of a level: `lanes` of them become eight columns.
template <VectorLevel of>
struct Rows {
  static constexpr VectorLevel level = of;
  static constexpr bool wide = level == VectorLevel::avx512;
  static constexpr std::size_t lanes = wide ? 8 : 4;
  using Row = std::conditional_t<wide, Eight, Halves>;
  using Column = std::conditional_t<wide, Eight, Four>;

  GRANUM_INLINE static Row row(const Four& low, const Four& high) {
    if constexpr (wide)
      return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    else
      return {low, high};
  }
  /// From and to an aligned struct of two Fours.
  GRANUM_INLINE static Row get(const void* from) {
    if constexpr (wide)
      return *static_cast<const EightInMemory*>(from);
    else
      return {static_cast<const FourInMemory*>(from)[0], static_cast<const FourInMemory*>(from)[1]};
  }
  GRANUM_INLINE static void put(void* to, const Row& row) {
    if constexpr (wide) {
      *static_cast<EightInMemory*>(to) = row;
    } else {
      static_cast<FourInMemory*>(to)[0] = row.low;
      static_cast<FourInMemory*>(to)[1] = row.high;
    }
  }
  GRANUM_INLINE static Column get_column(const double* from) {
    if constexpr (wide)
      return *reinterpret_cast<const EightInMemory*>(from);
    else
      return *reinterpret_cast<const FourInMemory*>(from);
  }
  GRANUM_INLINE static void put_column(double* to, const Column& column) {
    if constexpr (wide)
      *reinterpret_cast<EightInMemory*>(to) = column;
    else
      *reinterpret_cast<FourInMemory*>(to) = column;
  }
};

/// A column that stays in a register until it is used for the last time. GCC would rather read it again for
/// each use.
template <class Level>
GRANUM_INLINE typename Level::Column read_once(const double* from) {
  typename Level::Column column = Level::get_column(from);
#if GRANUM_HAS_VECTOR_LEVELS && !defined(__clang__)
  if constexpr (Level::level != VectorLevel::baseline)
    asm("" : "+v"(column)); // no instruction
#endif
  return column;
}

/// Four rows of four become columns, and back.
GRANUM_INLINE void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// Column c contains number c of each row.
GRANUM_INLINE void to_columns(const Halves (&rows)[4], Four (&columns)[8]) {
  for (std::size_t k = 0; k < 4; ++k) {
    columns[k] = rows[k].low;
    columns[4 + k] = rows[k].high;
  }
  transpose(columns[0], columns[1], columns[2], columns[3]);
  transpose(columns[4], columns[5], columns[6], columns[7]);
}
GRANUM_INLINE void to_rows(Four (&columns)[8], Halves (&rows)[4]) {
  transpose(columns[0], columns[1], columns[2], columns[3]);
  transpose(columns[4], columns[5], columns[6], columns[7]);
  for (std::size_t k = 0; k < 4; ++k)
    rows[k] = {columns[k], columns[4 + k]};
}

/// Pairs of rows, then of pairs, then of fours change the places of their numbers.
GRANUM_INLINE void to_columns(const Eight (&rows)[8], Eight (&columns)[8]) {
  Eight even[4], odd[4];
  for (std::size_t k = 0; k < 4; ++k) {
    even[k] = __builtin_shufflevector(rows[2 * k], rows[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    odd[k] = __builtin_shufflevector(rows[2 * k], rows[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const Eight(&from)[4] = parity == 0 ? even : odd;
    const Eight top04 = __builtin_shufflevector(from[0], from[1], 0, 1, 4, 5, 8, 9, 12, 13);
    const Eight top26 = __builtin_shufflevector(from[0], from[1], 2, 3, 6, 7, 10, 11, 14, 15);
    const Eight end04 = __builtin_shufflevector(from[2], from[3], 0, 1, 4, 5, 8, 9, 12, 13);
    const Eight end26 = __builtin_shufflevector(from[2], from[3], 2, 3, 6, 7, 10, 11, 14, 15);
    columns[parity] = __builtin_shufflevector(top04, end04, 0, 1, 4, 5, 8, 9, 12, 13);
    columns[parity + 2] = __builtin_shufflevector(top26, end26, 0, 1, 4, 5, 8, 9, 12, 13);
    columns[parity + 4] = __builtin_shufflevector(top04, end04, 2, 3, 6, 7, 10, 11, 14, 15);
    columns[parity + 6] = __builtin_shufflevector(top26, end26, 2, 3, 6, 7, 10, 11, 14, 15);
  }
}
GRANUM_INLINE void to_rows(const Eight (&columns)[8], Eight (&rows)[8]) { to_columns(columns, rows); }

} // namespace granum
