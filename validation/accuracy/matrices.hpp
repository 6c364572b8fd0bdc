// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <granum/core/vec3.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

#include "harness.hpp"

/// Tensors of rank four as 6 x 6 matrices, in 50-digit arithmetic.
namespace accuracy {

template <std::size_t n>
struct Square {
  static constexpr int size = static_cast<int>(n);
  Real entries[n][n];

  Real* operator[](int row) { return entries[row]; }
  const Real* operator[](int row) const { return entries[row]; }
  /// Takes each row and column.
  template <class Take>
  static void each(const Take& take) {
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        take(i, j);
  }
  friend Square operator*(const Square& a, const Square& b) {
    Square c{};
    each([&](int i, int j) {
      for (int k = 0; k < size; ++k)
        c[i][j] += a[i][k] * b[k][j];
    });
    return c;
  }
  [[nodiscard]] Square transposed() const {
    Square c;
    each([&](int i, int j) { c[i][j] = entries[j][i]; });
    return c;
  }
};
using Real3 = Square<3>;
using Real6 = Square<6>;

/// Entries of a matrix of doubles.
template <class Square, class Matrix>
Square exact(const Matrix& m) {
  Square r;
  Square::each([&](int i, int j) { r[i][j] = m(i, j); });
  return r;
}

/// A well conditioned stiffness, C33, C12 and C13 of the size of C11.
granum::elastic::TransverselyIsotropic draw_stiffness(Draw& draw);
std::string said_of(const granum::elastic::TransverselyIsotropic& c);
/// A positive definite matrix without symmetry but its own: diagonally dominant.
granum::elastic::VoigtStiffness draw_full_stiffness(Draw& draw);

/// Voigt index of the pair ij.
inline int voigt_index(int i, int j) { return i == j ? i : 6 - i - j; }
Real6 voigt_of(const granum::elastic::TransverselyIsotropic& c);

} // namespace accuracy
