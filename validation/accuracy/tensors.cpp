// SPDX-License-Identifier: GPL-3.0-or-later
// What is done on whole stiffness matrices, written out by components.
#include <algorithm>

#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>

#include "matrices.hpp"

namespace accuracy {

namespace {

using granum::elastic::VoigtStiffness;

/// Of the largest entry.
void compare_entries(const At& at, const std::string& function, const granum::elastic::Matrix6& found,
                     const Real6& reference) {
  Real scale = 0;
  Real6::each([&](int i, int j) { scale = std::max(scale, Real(abs(reference[i][j]))); });
  Real6::each([&](int i, int j) { at.of(scale, function, found(i, j), reference[i][j]); });
}

/// Two where a pair of different axes is counted twice.
int twice(int I) { return I < 3 ? 1 : 2; }

/// A rotation to double precision.
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

/// C'_ijkl = R_ia R_jb R_kc R_ld C_abcd of a Voigt stiffness: T C T^T, as s_ij = R_ia R_jb s_ab with s_ab
/// listed once a pair.
Real6 turned(const Real6& voigt, const Real3& R) {
  constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  Real6 T{};
  for (int I = 0; I < 6; ++I)
    Real3::each([&](int a, int b) { T[I][voigt_index(a, b)] += R[pairs[I][0]][a] * R[pairs[I][1]][b]; });
  return T * voigt * T.transposed();
}

/// K and G of the mean over all rotations: C_iijj = 9 K and C_ijij = 3 K + 10 G.
struct Mean {
  Real K, G;
};
Mean rotation_mean(const Real6& c) {
  Real iijj = 0, ijij = 0;
  Real3::each([&](int i, int j) {
    iijj += c[i][j];
    ijij += c[voigt_index(i, j)][voigt_index(i, j)];
  });
  return {iijj / 9, (ijij - iijj / 3) / 10};
}

Real6 inverse(Real6 m) {
  Real6 r{};
  for (int i = 0; i < 6; ++i)
    r[i][i] = 1;
  for (int p = 0; p < 6; ++p) { // positive definite: no pivoting
    const Real pivot = m[p][p];
    for (int j = 0; j < 6; ++j)
      m[p][j] /= pivot, r[p][j] /= pivot;
    for (int i = 0; i < 6; ++i) {
      const Real f = m[i][p];
      for (int j = 0; i != p && j < 6; ++j)
        m[i][j] -= f * m[p][j], r[i][j] -= f * r[p][j];
    }
  }
  return r;
}

/// Voigt's matrix of a compliance has factors 2 and 4 at the shears.
Mean reuss_mean(const Real6& c) {
  Real6 s = inverse(c);
  Real6::each([&](int i, int j) { s[i][j] /= twice(i) * twice(j); });
  const Mean mean = rotation_mean(s); // of a solid of compliances 1/(9K) and 1/(4G)
  return {1 / (9 * mean.K), 1 / (4 * mean.G)};
}

void check_averages(const At& at, const granum::elastic::IsotropicAverages& found, const Real6& c) {
  const Mean voigt = rotation_mean(c), reuss = reuss_mean(c);
  at("isotropic_averages voigt", found.voigt.bulk_modulus(), voigt.K);
  at("isotropic_averages voigt", found.voigt.shear_modulus(), voigt.G);
  at("isotropic_averages reuss", found.reuss.bulk_modulus(), reuss.K);
  at("isotropic_averages reuss", found.reuss.shear_modulus(), reuss.G);
  at("isotropic_averages hill", found.hill.bulk_modulus(), (voigt.K + reuss.K) / 2);
  at("isotropic_averages hill", found.hill.shear_modulus(), (voigt.G + reuss.G) / 2);
}

/// Mean over the rotations about axis 3 by eight of them, exact for the fourth harmonic.
Real6 axial_mean(const Real6& c) {
  Real6 sum{};
  for (int k = 0; k < 8; ++k) {
    const Real angle = k * pi() / 4, co = cos(angle), si = sin(angle);
    const Real6 one = turned(c, {{{co, -si, 0}, {si, co, 0}, {0, 0, 1}}});
    Real6::each([&](int i, int j) { sum[i][j] += one[i][j] / 8; });
  }
  return sum;
}

Real mandel_norm(const Real6& c) {
  Real sum = 0;
  Real6::each([&](int i, int j) { sum += twice(i) * twice(j) * c[i][j] * c[i][j]; });
  return sqrt(sum);
}

Real distance(Real6 c, const Real6& part) {
  const Real size = mandel_norm(c);
  Real6::each([&](int i, int j) { c[i][j] -= part[i][j]; });
  return mandel_norm(c) / size;
}

Real6 isotropic(const Mean& m) {
  Real6 c{};
  Real3::each([&](int i, int j) { c[i][j] = m.K - 2 * m.G / 3 + (i == j ? Real(2 * m.G) : Real(0)); });
  for (int I = 3; I < 6; ++I)
    c[I][I] = m.G;
  return c;
}

void check_projection(const At& at, const VoigtStiffness& c) {
  const Real6 C = exact<Real6>(c.matrix), axial = axial_mean(C);
  const Mean mean = rotation_mean(C);
  const auto solid = isotropic_projection(c);
  at("isotropic_projection", solid.bulk_modulus(), mean.K);
  at("isotropic_projection", solid.shear_modulus(), mean.G);
  compare_entries(at, "transversely_isotropic_projection (of largest)",
                  granum::elastic::voigt(granum::elastic::transversely_isotropic_projection(c)).matrix,
                  axial);
  const auto distances = symmetry_distances(c);
  at.of(1, "symmetry_distances, of 1", distances.isotropic, distance(C, isotropic(mean)));
  at.of(1, "symmetry_distances, of 1", distances.transversely_isotropic, distance(C, axial));
}

/// Mandel's form has the shear rows and columns times sqrt 2.
void check_mandel(Table& table, Draw& draw, const VoigtStiffness& c) {
  const std::string domain = "full positive definite matrices";
  const At any{table, domain, "any"};
  const auto m = granum::elastic::mandel(c);
  Real6::each([&](int i, int j) {
    any("mandel(Voigt)", m.matrix(i, j),
        c.matrix(i, j) * (i < 3 ? Real(1) : sqrt(Real(2))) * (j < 3 ? Real(1) : sqrt(Real(2))));
  });
  const granum::elastic::Matrix6 back = granum::elastic::voigt(m).matrix;
  Real6::each([&](int i, int j) { any("voigt(mandel(Voigt))", back(i, j), c.matrix(i, j)); });
  const granum::Mat3 R = draw_rotation(draw);
  const At at{table, domain, said("R11 R22 R33", {R(0, 0), R(1, 1), R(2, 2)})};
  compare_entries(at, "rotate (of largest)", rotate(c, R).matrix,
                  turned(exact<Real6>(c.matrix), exact<Real3>(R)));
  VoigtStiffness skew = c;
  skew.matrix(0, 1) += 0.1 * c.matrix(0, 0) * draw.uniform(-1, 1);
  skew.matrix(2, 4) += 0.1 * c.matrix(0, 0) * draw.uniform(-1, 1);
  const auto unsymmetric = granum::elastic::mandel(skew);
  const Real6 s = exact<Real6>(unsymmetric.matrix);
  Real residual = 0, size = 0;
  Real6::each([&](int i, int j) {
    residual += (s[i][j] - s[j][i]) * (s[i][j] - s[j][i]);
    size += s[i][j] * s[i][j];
  });
  at("symmetry_residual", symmetry_residual(unsymmetric), sqrt(residual / size));
}

} // namespace

void check_tensors(Table& table, Draw& draw, std::size_t k) {
  const VoigtStiffness c = draw_full_stiffness(draw);
  const At at{table, "full positive definite matrices", "sample " + std::to_string(k)};
  check_averages(at, isotropic_averages(c), exact<Real6>(c.matrix));
  const auto ti = draw_stiffness(draw);
  check_averages({table, "transversely isotropic", said_of(ti)}, isotropic_averages(ti), voigt_of(ti));
  check_projection(at, c);
  check_mandel(table, draw, c);
}

} // namespace accuracy
