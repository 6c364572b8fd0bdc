// SPDX-License-Identifier: GPL-3.0-or-later
// Engineering constants by elimination in the 3 x 3 block of normal stresses; speeds as eigenvalues of
// C_ijkl n_j n_l; Thomsen's parameters as his equations 8 and 17 print them.
#include <algorithm>

#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/transverse_isotropic.hpp>
#include <granum/elastic/waves.hpp>

#include "matrices.hpp"

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

std::string said_of(const granum::elastic::TransverselyIsotropic& c) {
  return said("C11 C33 C12 C13 C44", {c.C11, c.C33, c.C12, c.C13, c.C44});
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

Real6 voigt_of(const granum::elastic::TransverselyIsotropic& c) {
  Real6 m{};
  m[0][0] = m[1][1] = c.C11, m[2][2] = c.C33;
  m[0][1] = m[1][0] = c.C12;
  m[0][2] = m[2][0] = m[1][2] = m[2][1] = c.C13;
  m[3][3] = m[4][4] = c.C44, m[5][5] = (Real(c.C11) - Real(c.C12)) / 2;
  return m;
}

namespace {

using granum::Vec3;
using granum::elastic::TransverselyIsotropic;

// ---- engineering constants ----

void check_transversely_isotropic(Table& table, Draw& draw) {
  const auto c = draw_stiffness(draw);
  const Real C11 = c.C11, C12 = c.C12, C13 = c.C13, C33 = c.C33;
  // Strains of a unit stress along one axis of the normal block, by Cramer's rule.
  const Real determinant = (C11 - C12) * ((C11 + C12) * C33 - 2 * C13 * C13);
  const Real S11 = (C11 * C33 - C13 * C13) / determinant, S33 = (C11 * C11 - C12 * C12) / determinant;
  const Real S12 = -(C12 * C33 - C13 * C13) / determinant, S13 = -(C11 - C12) * C13 / determinant;
  const At at{table, "C12, C13 from -0.3 to 0.5 C11", said("C11 C33 C12 C13", {c.C11, c.C33, c.C12, c.C13})};
  const At of_one{table, at.domain + ", of 1", at.where};
  at("elastic: E_v", c.E_v(), 1 / S33);
  at("elastic: E_h", c.E_h(), 1 / S11);
  of_one.of(1, "elastic: nu_vh, nu_hv, nu_hh", c.nu_vh(), -S13 / S33);
  of_one.of(1, "elastic: nu_vh, nu_hv, nu_hh", c.nu_hv(), -S13 / S11);
  of_one.of(1, "elastic: nu_vh, nu_hv, nu_hh", c.nu_hh(), -S12 / S11);
  at("elastic: bulk_modulus", c.bulk_modulus(), (2 * C11 + C33 + 2 * C12 + 4 * C13) / 9);
}

void check_isotropic(Table& table, Draw& draw) {
  const double G = draw.log_uniform(1e-3, 1e12), nu = draw.poisson_ratio();
  const auto solid = granum::elastic::Isotropic::from_shear_and_poisson(G, nu);
  if (nu < 0.5)
    At{table, "nu in [-0.999999, 0.5]",
       said("G nu", {G, nu})}("elastic: K from G and nu", solid.bulk_modulus(),
                              2 * Real(G) * (1 + Real(nu)) / (3 * (1 - 2 * Real(nu))));
  const double K = draw.log_uniform(1e-3, 1e3) * G;
  const auto other = granum::elastic::Isotropic::from_bulk_and_shear(K, G);
  const Real k = K, g = G;
  const std::string pair = said("K G", {K, G});
  At{table, "K/G from 1e-3 to 1e3", pair}("elastic: E from K and G", other.young_modulus(),
                                          9 * k * g / (3 * k + g));
  At{table, "K/G from 1e-3 to 1e3, of 1", pair}.of(1, "elastic: nu from K and G", other.poisson_ratio(),
                                                   (3 * k - 2 * g) / (2 * (3 * k + g)));
}

// ---- waves ----

Vec3 draw_direction(Draw& draw) {
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

/// Eigenvalues of a symmetric matrix, ascending, by Jacobi's rotations.
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

/// Compares speeds, ascending, with roots of the eigenvalues of C_ijkl n_j n_l over the density.
void compare_speeds(const At& at, const std::string& function, const std::array<double, 3>& speeds,
                    const Real6& c, double density, const Vec3& direction) {
  const Real x[] = {direction.x, direction.y, direction.z};
  const Real length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  Real3 gamma{};
  Real3::each([&](int i, int k) {
    Real3::each([&](int j, int l) {
      gamma[i][k] += c[voigt_index(i, j)][voigt_index(k, l)] * (x[j] / length) * (x[l] / length);
    });
  });
  const auto squares = eigenvalues(gamma);
  for (std::size_t k = 0; k < 3; ++k)
    at(function, speeds[k], sqrt(squares[k] / density));
}

void check_speeds(Table& table, Draw& draw) {
  const auto said_direction = [](const Vec3& n) { return said("n1 n2 n3", {n.x, n.y, n.z}); };
  const TransverselyIsotropic c = draw_stiffness(draw);
  Vec3 n = draw_direction(draw);
  double density = draw.log_uniform(1, 1e4);
  const auto waves = plane_waves(c, density, n);
  std::array<double, 3> found{waves.quasi_s.speed, waves.pure_s.speed, waves.quasi_p.speed};
  std::sort(found.begin(), found.end());
  compare_speeds({table, "any direction, axes too", said_of(c) + " " + said_direction(n)},
                 "plane_waves(transversely isotropic) speeds", found, voigt_of(c), density, n);
  const auto full = draw_full_stiffness(draw);
  n = draw_direction(draw);
  density = draw.log_uniform(1, 1e4);
  const auto of_full = plane_waves(full, density, n);
  compare_speeds({table, "any direction, axes too", said_direction(n), stiffness_form},
                 "plane_waves(full stiffness) speeds",
                 {of_full.slowest.speed, of_full.middle.speed, of_full.fastest.speed},
                 exact<Real6>(full.matrix), density, n);
}

void check_thomsen(Table& table, const TransverselyIsotropic& c, const std::string& domain) {
  if (!(c.C33 > c.C44 && c.positive_definite()))
    return;
  const Real C11 = c.C11, C33 = c.C33, C12 = c.C12, C13 = c.C13, C44 = c.C44;
  const Real sum = C13 + C44, difference = C33 - C44;
  const auto thomsen = thomsen_parameters(c);
  const double density = 1700;
  const auto solid = thomsen_solid(c, density);
  const At at{table, domain, said_of(c)};
  at("thomsen_parameters epsilon, gamma", thomsen.epsilon, (C11 - C33) / (2 * C33));
  at("thomsen_parameters epsilon, gamma", thomsen.gamma, ((C11 - C12) / 2 - C44) / (2 * C44));
  at("thomsen_parameters delta", thomsen.delta,
     (sum * sum - difference * difference) / (2 * C33 * difference));
  at("weak_thomsen_parameters delta", weak_thomsen_parameters(c).delta, (C13 + 2 * C44 - C33) / C33);
  at("thomsen_solid speeds", solid.vertical_p_speed, sqrt(C33 / density));
  at("thomsen_solid speeds", solid.vertical_s_speed, sqrt(C44 / density));
}

void check_thomsen_inverse(Table& table, Draw& draw) {
  const double V_s = draw.log_uniform(10, 1e4), V_p = V_s * draw.uniform(2, 5), density = 2000;
  const double epsilon = draw.uniform(0, 0.3); // delta above it may leave no positive definite stiffness
  const granum::elastic::ThomsenParameters p{epsilon, draw.uniform(-0.1, epsilon), draw.uniform(-0.1, 0.15)};
  const Real C33 = density * Real(V_p) * V_p, C44 = density * Real(V_s) * V_s, difference = C33 - C44;
  const Real C13 = sqrt(difference * difference + 2 * Real(p.delta) * C33 * difference) - C44;
  const Real C11 = C33 * (1 + 2 * Real(p.epsilon)), C12 = C11 - 2 * C44 * (1 + 2 * Real(p.gamma));
  const auto c = transversely_isotropic(granum::elastic::ThomsenSolid{density, V_p, V_s, p});
  const At at{table, "V_p 2 to 5 V_s, of C33",
              said("V_p V_s epsilon delta gamma", {V_p, V_s, p.epsilon, p.delta, p.gamma})};
  const std::pair<double, Real> entries[] = {
      {c.C11, C11}, {c.C33, C33}, {c.C12, C12}, {c.C13, C13}, {c.C44, C44}};
  for (const auto& [value, reference] : entries)
    at.of(C33, "transversely_isotropic(ThomsenSolid)", value, reference);
}

void check_isotropic_speeds(Table& table, Draw& draw) {
  const double K = draw.log_uniform(1e-3, 1e12), G = K * draw.log_uniform(1e-3, 1e3);
  const granum::elastic::GrainsAndPores mass{draw.log_uniform(1, 1e5), draw.log_uniform(0.01, 100),
                                             draw.uniform_or(0, 2000, {0.0, 1000.0})};
  const double density = granum::elastic::bulk_density(mass);
  const auto v = wave_speeds(granum::elastic::Isotropic::from_bulk_and_shear(K, G), density);
  const std::string where = said("K G density e", {K, G, density, mass.void_ratio});
  At{table, "e 0.01 to 100, dry or filled", where}(
      "bulk_density", density,
      (Real(mass.grain_density) + Real(mass.void_ratio) * mass.pore_density) / (1 + Real(mass.void_ratio)));
  const At at{table, "G/K from 1e-3 to 1e3", where};
  at("wave_speeds", v.p, sqrt((K + 4 * Real(G) / 3) / density));
  at("wave_speeds", v.s, sqrt(Real(G) / density));
}

} // namespace

void check_elastic(Table& table, Draw& draw, std::size_t /*sample*/) {
  check_transversely_isotropic(table, draw);
  check_isotropic(table, draw);
}

void check_waves(Table& table, Draw& draw, std::size_t /*sample*/) {
  check_speeds(table, draw);
  TransverselyIsotropic c = draw_stiffness(draw);
  check_thomsen(table, c, "C12, C13 from -0.3 to 0.5 C11");
  c.C11 = c.C33 * (1 + draw.log_uniform(1e-16, 1e-1));
  c.C13 = (c.C33 - 2 * c.C44) * (1 + draw.log_uniform(1e-16, 1e-1));
  c.C12 = (c.C11 - 2 * c.C44) * (1 - draw.log_uniform(1e-16, 1e-1));
  check_thomsen(table, c, "nearly isotropic");
  check_thomsen_inverse(table, draw);
  check_isotropic_speeds(table, draw);
}

} // namespace accuracy
