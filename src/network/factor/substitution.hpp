// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network: products with blocks of L and R, for all load cases at once.
#pragma once

#include <cstdint>

#include "core/vector/level.hpp"
#include "network/lanes.hpp"
#include "network/numbering/numbering.hpp"

namespace granum::network {

/// Converts the numbers, with rounding if `To` is shorter.
template <class To, int Dof, class From>
GRANUM_INLINE Block<Dof, To> as(const Block<Dof, From>& b) {
  Block<Dof, To> other;
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      other.at[r][c] = static_cast<To>(b.at[r][c]);
  return other;
}

/// target -= B^T source
template <int Dof>
GRANUM_INLINE void subtract_transposed(const Block<Dof>& b, const Rows<Dof>& source, Rows<Dof>& target) {
  for (int k = 0; k < Dof; ++k)
    for (int r = 0; r < Dof; ++r)
      target.row[r] -= b.at[k][r] * source.row[k];
}
/// target -= B source
template <int Dof>
GRANUM_INLINE void subtract(const Block<Dof>& b, const Rows<Dof>& source, Rows<Dof>& target) {
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      target.row[r] -= b.at[r][k] * source.row[k];
}

/// B^T x
template <int Dof>
GRANUM_INLINE Rows<Dof> transposed_product(const Block<Dof>& b, const Rows<Dof>& x) {
  Rows<Dof> y = {};
  for (int k = 0; k < Dof; ++k)
    for (int r = 0; r < Dof; ++r)
      y.row[r] += b.at[k][r] * x.row[k];
  return y;
}
/// B y
template <int Dof>
GRANUM_INLINE Rows<Dof> product(const Block<Dof>& b, const Rows<Dof>& y) {
  Rows<Dof> x = {};
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      x.row[r] += b.at[r][k] * y.row[k];
  return x;
}

/// Rows of one piece of L: blocks row_start[i] to row_start[i + 1] of row i, the first of the piece at
/// lower[0], each transposed; and R of all grains.
template <int Dof, class Number>
struct PieceOfL {
  Piece piece;
  const std::uint32_t* row_start;
  const std::uint32_t* column;
  const Block<Dof, Number>* lower;
  const Block<Dof>* root;

  [[nodiscard]] GRANUM_INLINE Block<Dof> block(std::uint32_t e) const {
    return as<double>(lower[e - row_start[piece.first]]);
  }
};

/// z = L^-1 R^T r in the rows of the piece.
template <int Dof, class Number>
GRANUM_INLINE void substitute_forward(const PieceOfL<Dof, Number>& l, const Rows<Dof>* r, Rows<Dof>* z) {
  for (std::uint32_t i = l.piece.first; i < l.piece.last; ++i) {
    Rows<Dof> zi = transposed_product(l.root[i], r[i]);
    for (std::uint32_t e = l.row_start[i]; e < l.row_start[i + 1]; ++e)
      subtract_transposed(l.block(e), z[l.column[e]], zi);
    z[i] = zi;
  }
}

/// z = R L^-T z, the part of the rows of the piece.
template <int Dof, class Number>
GRANUM_INLINE void substitute_back(const PieceOfL<Dof, Number>& l, Rows<Dof>* z) {
  std::uint32_t e = l.row_start[l.piece.last];
  for (std::uint32_t i = l.piece.last; i-- > l.piece.first;) {
    const Rows<Dof> zi = z[i];
    while (e > l.row_start[i]) { // strictly backwards through memory, which processors prefetch best
      --e;
      subtract(l.block(e), zi, z[l.column[e]]);
    }
    z[i] = product(l.root[i], zi);
  }
}

} // namespace granum::network
