// SPDX-License-Identifier: GPL-3.0-or-later
// What is done on whole stiffness matrices, written out by components.
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>

#include "matrices.hpp"

namespace accuracy {

namespace {

using granum::elastic::VoigtStiffness;

Real6 exact(const granum::elastic::Matrix6& m) {
  Real6 r;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      r[i][j] = m(i, j);
  return r;
}

void compare_entries(Table& table, const std::string& function, const std::string& domain, Reach reach,
                     const granum::elastic::Matrix6& found, const Real6& reference, const std::string& at) {
  const Real scale = largest(reference);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      table.take_against(function, domain, reach, found(i, j), reference[i][j], scale, at);
}

/// K and G of the mean over all rotations: C_iijj = 9 K and C_ijij = 3 K + 10 G.
struct Mean {
  Real K, G;
};
Mean rotation_mean(const Real6& c) {
  Real iijj = 0, ijij = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      iijj += c[i][j];
      ijij += c[voigt_index(i, j)][voigt_index(i, j)];
    }
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
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      s[i][j] /= (i < 3 ? 1 : 2) * (j < 3 ? 1 : 2);
  const Mean mean = rotation_mean(s); // of a solid of compliances 1/(9K) and 1/(4G)
  return {1 / (9 * mean.K), 1 / (4 * mean.G)};
}

void check_averages(Table& table, const std::string& domain, const granum::elastic::IsotropicAverages& found,
                    const Real6& c, const std::string& at) {
  const Mean voigt = rotation_mean(c), reuss = reuss_mean(c);
  const auto take = [&](const char* name, double value, const Real& reference) {
    table.take(name, domain, closed_form, value, reference, at);
  };
  take("isotropic_averages voigt", found.voigt.bulk_modulus(), voigt.K);
  take("isotropic_averages voigt", found.voigt.shear_modulus(), voigt.G);
  take("isotropic_averages reuss", found.reuss.bulk_modulus(), reuss.K);
  take("isotropic_averages reuss", found.reuss.shear_modulus(), reuss.G);
  take("isotropic_averages hill", found.hill.bulk_modulus(), (voigt.K + reuss.K) / 2);
  take("isotropic_averages hill", found.hill.shear_modulus(), (voigt.G + reuss.G) / 2);
}

/// Mean over the rotations about axis 3 by eight of them, exact for the fourth harmonic.
Real6 axial_mean(const Real6& c) {
  Real6 sum{};
  for (int k = 0; k < 8; ++k) {
    const Real angle = k * pi() / 4;
    const Real co = cos(angle), si = sin(angle);
    const Real6 one = turned(c, {{{co, -si, 0}, {si, co, 0}, {0, 0, 1}}});
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        sum[i][j] += one[i][j] / 8;
  }
  return sum;
}

Real mandel_norm(const Real6& c) {
  Real sum = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      sum += (i < 3 ? 1 : 2) * (j < 3 ? 1 : 2) * c[i][j] * c[i][j];
  return sqrt(sum);
}

Real distance(Real6 c, const Real6& part) {
  const Real size = mandel_norm(c);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      c[i][j] -= part[i][j];
  return mandel_norm(c) / size;
}

Real6 isotropic(const Mean& m) {
  Real6 c{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      c[i][j] = m.K - 2 * m.G / 3 + (i == j ? Real(2 * m.G) : Real(0));
    c[i + 3][i + 3] = m.G;
  }
  return c;
}

void check_projection(Table& table, const VoigtStiffness& c, const std::string& at) {
  const Real6 C = exact(c.matrix), axial = axial_mean(C);
  const std::string domain = "full positive definite matrices";
  const Mean mean = rotation_mean(C);
  const auto solid = isotropic_projection(c);
  table.take("isotropic_projection", domain, closed_form, solid.bulk_modulus(), mean.K, at);
  table.take("isotropic_projection", domain, closed_form, solid.shear_modulus(), mean.G, at);
  const auto ti = granum::elastic::transversely_isotropic_projection(c);
  compare_entries(table, "transversely_isotropic_projection (of largest)", domain, closed_form,
                  granum::elastic::voigt(ti).matrix, axial, at);
  const auto distances = symmetry_distances(c);
  table.take_against("symmetry_distances, of 1", domain, closed_form, distances.isotropic,
                     distance(C, isotropic(mean)), 1, at);
  table.take_against("symmetry_distances, of 1", domain, closed_form, distances.transversely_isotropic,
                     distance(C, axial), 1, at);
}

void check_mandel(Table& table, Draw& draw, const VoigtStiffness& c) {
  const std::string domain = "full positive definite matrices";
  const auto m = granum::elastic::mandel(c);
  const Real6 M = mandel_of(c);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      table.take("mandel(Voigt)", domain, closed_form, m.matrix(i, j), M[i][j], "any");
  const granum::elastic::Matrix6 back = granum::elastic::voigt(m).matrix;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      table.take("voigt(mandel(Voigt))", domain, closed_form, back(i, j), c.matrix(i, j), "any");
  const granum::Mat3 R = draw_rotation(draw);
  Real3 exact_rotation;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      exact_rotation[i][j] = R(i, j);
  const std::string at = said({{"R11", R(0, 0)}, {"R22", R(1, 1)}, {"R33", R(2, 2)}});
  compare_entries(table, "rotate (of largest)", domain, closed_form, rotate(c, R).matrix,
                  turned(exact(c.matrix), exact_rotation), at);
  VoigtStiffness skew = c;
  skew.matrix(0, 1) += 0.1 * c.matrix(0, 0) * draw.uniform(-1, 1);
  skew.matrix(2, 4) += 0.1 * c.matrix(0, 0) * draw.uniform(-1, 1);
  const auto unsymmetric = granum::elastic::mandel(skew);
  const Real6 s = exact(unsymmetric.matrix);
  Real residual = 0, size = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      residual += (s[i][j] - s[j][i]) * (s[i][j] - s[j][i]);
      size += s[i][j] * s[i][j];
    }
  table.take("symmetry_residual", domain, closed_form, symmetry_residual(unsymmetric), sqrt(residual / size),
             at);
}

} // namespace

void check_tensors(Table& table, std::size_t samples) {
  Draw draw(13);
  for (std::size_t k = 0; k < samples; ++k) {
    const VoigtStiffness c = draw_full_stiffness(draw);
    const std::string at = "sample " + std::to_string(k);
    check_averages(table, "full positive definite matrices", isotropic_averages(c), exact(c.matrix), at);
    const auto ti = draw_stiffness(draw);
    check_averages(
        table, "transversely isotropic", isotropic_averages(ti), voigt_of(ti),
        said({{"C11", ti.C11}, {"C33", ti.C33}, {"C12", ti.C12}, {"C13", ti.C13}, {"C44", ti.C44}}));
    check_projection(table, c, at);
    check_mandel(table, draw, c);
  }
}

} // namespace accuracy
