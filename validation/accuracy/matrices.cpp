// SPDX-License-Identifier: GPL-3.0-or-later
#include "matrices.hpp"

#include <algorithm>

namespace accuracy {

granum::elastic::TransverselyIsotropic draw_stiffness(Draw& draw) {
  const double scale = draw.log_uniform(1e-3, 1e12);
  const double C33 = scale * draw.uniform(1, 3), C11 = scale * draw.uniform(1, 3);
  return {.C11 = C11,
          .C33 = C33,
          .C12 = C11 * draw.uniform(-0.3, 0.5),
          .C13 = scale * draw.uniform(-0.3, 0.5),
          .C44 = scale * draw.uniform(0.1, 1)};
}

granum::elastic::VoigtStiffness draw_full_stiffness(Draw& draw) {
  granum::elastic::VoigtStiffness c;
  const double scale = draw.log_uniform(1e-3, 1e12);
  for (int i = 0; i < 6; ++i) {
    c.matrix(i, i) = scale * draw.uniform(1, 3);
    for (int j = 0; j < i; ++j)
      c.matrix(i, j) = c.matrix(j, i) = scale * draw.uniform(-0.19, 0.19);
  }
  return c;
}

granum::Vec3 draw_direction(Draw& draw) {
  const double kind = draw.uniform(0, 8);
  if (kind < 1)
    return {0, 0, 1};
  if (kind < 2)
    return {1, 0, 0};
  if (kind < 3)
    return {1, 1, 0};
  if (kind < 4)
    return {draw.log_uniform(1e-200, 1), 0, 1};
  return {draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)};
}

granum::Mat3 draw_rotation(Draw& draw) {
  double q[4], square = 0;
  do {
    square = 0;
    for (double& x : q)
      x = draw.uniform(-1, 1), square += x * x;
  } while (square < 0.1 || square > 1);
  const double s = 2 / square, w = q[0], x = q[1], y = q[2], z = q[3];
  return {{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
           {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
           {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}}};
}

int voigt_index(int i, int j) { return i == j ? i : 6 - i - j; }

Real6 mandel_of(const granum::elastic::VoigtStiffness& c) {
  Real6 m;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      m[i][j] = c.matrix(i, j) * (i < 3 ? Real(1) : sqrt(Real(2))) * (j < 3 ? Real(1) : sqrt(Real(2)));
  return m;
}

Real6 voigt_of(const granum::elastic::TransverselyIsotropic& c) {
  Real6 m{};
  m[0][0] = m[1][1] = c.C11, m[2][2] = c.C33;
  m[0][1] = m[1][0] = c.C12;
  m[0][2] = m[2][0] = m[1][2] = m[2][1] = c.C13;
  m[3][3] = m[4][4] = c.C44, m[5][5] = (Real(c.C11) - Real(c.C12)) / 2;
  return m;
}

Real6 turned(const Real6& voigt, const Real3& R) {
  // s_ij = R_ia R_jb s_ab with s_ab listed once a pair: T C T^T.
  constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  Real6 T{}, left{}, result{};
  for (int I = 0; I < 6; ++I)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        T[I][voigt_index(a, b)] += R[pairs[I][0]][a] * R[pairs[I][1]][b];
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
        left[i][j] += T[i][k] * voigt[k][j];
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
        result[i][j] += left[i][k] * T[j][k];
  return result;
}

Real largest(const Real6& m) {
  Real size = 0;
  for (const auto& row : m.entries)
    for (const Real& x : row)
      size = std::max(size, Real(abs(x)));
  return size;
}

std::array<Real, 3> eigenvalues(Real3 m) {
  for (int sweep = 0; sweep < 12; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (m[p][q] == 0)
          continue;
        const Real half = (m[q][q] - m[p][p]) / (2 * m[p][q]);
        const Real t = (half < 0 ? -1 : 1) / (abs(half) + sqrt(1 + half * half));
        const Real c = 1 / sqrt(1 + t * t), s = t * c;
        const Real off = m[p][q];
        m[p][p] -= t * off, m[q][q] += t * off, m[p][q] = m[q][p] = 0;
        const int k = 3 - p - q;
        const Real x = m[k][p], y = m[k][q];
        m[k][p] = m[p][k] = c * x - s * y, m[k][q] = m[q][k] = s * x + c * y;
      }
  std::array<Real, 3> values{m[0][0], m[1][1], m[2][2]};
  std::sort(values.begin(), values.end());
  return values;
}

} // namespace accuracy
