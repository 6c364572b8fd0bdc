// SPDX-License-Identifier: GPL-3.0-or-later
// Speeds as eigenvalues of C_ijkl n_j n_l; Thomsen's parameters as his equations 8 and 17 print them.
#include <algorithm>

#include <granum/elastic/waves.hpp>

#include "matrices.hpp"

namespace accuracy {

namespace {

using granum::Vec3;
using granum::elastic::TransverselyIsotropic;

std::string said_of(const TransverselyIsotropic& c) {
  return said({{"C11", c.C11}, {"C33", c.C33}, {"C12", c.C12}, {"C13", c.C13}, {"C44", c.C44}});
}

std::string said_of(const Vec3& n) { return said({{"n1", n.x}, {"n2", n.y}, {"n3", n.z}}); }

/// Eigenvalues of C_ijkl n_j n_l.
std::array<Real, 3> christoffel(const Real6& c, const Vec3& direction) {
  const Real length = sqrt(Real(direction.x) * direction.x + Real(direction.y) * direction.y +
                           Real(direction.z) * direction.z);
  const Real n[3] = {direction.x / length, direction.y / length, direction.z / length};
  Real3 gamma{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l)
          gamma[i][k] += c[voigt_index(i, j)][voigt_index(k, l)] * n[j] * n[l];
  return eigenvalues(gamma);
}

void check_waves_in_transverse_isotropy(Table& table, Draw& draw) {
  const TransverselyIsotropic c = draw_stiffness(draw);
  const Vec3 n = draw_direction(draw);
  const double density = draw.log_uniform(1, 1e4);
  const auto squares = christoffel(voigt_of(c), n);
  const auto waves = plane_waves(c, density, n);
  std::array<double, 3> found{waves.quasi_s.speed, waves.pure_s.speed, waves.quasi_p.speed};
  std::sort(found.begin(), found.end());
  for (std::size_t k = 0; k < 3; ++k)
    table.take("plane_waves(transversely isotropic) speeds", "any direction, axes too", closed_form, found[k],
               sqrt(squares[k] / density), said_of(c) + " " + said_of(n));
}

void check_full(Table& table, Draw& draw) {
  const auto c = draw_full_stiffness(draw);
  const Vec3 n = draw_direction(draw);
  const double density = draw.log_uniform(1, 1e4);
  Real6 C;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      C[i][j] = c.matrix(i, j);
  const auto squares = christoffel(C, n);
  const auto waves = plane_waves(c, density, n);
  const double found[] = {waves.slowest.speed, waves.middle.speed, waves.fastest.speed};
  for (std::size_t k = 0; k < 3; ++k)
    table.take("plane_waves(full stiffness) speeds", "any direction, axes too", stiffness_form, found[k],
               sqrt(squares[k] / density), said_of(n));
}

void check_thomsen(Table& table, const TransverselyIsotropic& c, const std::string& domain) {
  if (!(c.C33 > c.C44 && c.positive_definite()))
    return;
  const Real C11 = c.C11, C33 = c.C33, C12 = c.C12, C13 = c.C13, C44 = c.C44;
  const Real epsilon = (C11 - C33) / (2 * C33), gamma = ((C11 - C12) / 2 - C44) / (2 * C44);
  const Real sum = C13 + C44, difference = C33 - C44;
  const Real exact = (sum * sum - difference * difference) / (2 * C33 * difference);
  const auto thomsen = thomsen_parameters(c);
  const std::string at = said_of(c);
  table.take("thomsen_parameters epsilon, gamma", domain, closed_form, thomsen.epsilon, epsilon, at);
  table.take("thomsen_parameters epsilon, gamma", domain, closed_form, thomsen.gamma, gamma, at);
  table.take("thomsen_parameters delta", domain, closed_form, thomsen.delta, exact, at);
  table.take("weak_thomsen_parameters delta", domain, closed_form, weak_thomsen_parameters(c).delta,
             (C13 + 2 * C44 - C33) / C33, at);
  const double density = 1700;
  const auto solid = thomsen_solid(c, density);
  table.take("thomsen_solid speeds", domain, closed_form, solid.vertical_p_speed, sqrt(C33 / density), at);
  table.take("thomsen_solid speeds", domain, closed_form, solid.vertical_s_speed, sqrt(C44 / density), at);
}

void check_thomsen_inverse(Table& table, Draw& draw) {
  const double V_s = draw.log_uniform(10, 1e4), V_p = V_s * draw.uniform(2, 5), density = 2000;
  const double epsilon = draw.uniform(0, 0.3); // delta above it may leave no positive definite stiffness
  const granum::elastic::ThomsenParameters p{epsilon, draw.uniform(-0.1, epsilon), draw.uniform(-0.1, 0.15)};
  const Real C33 = density * Real(V_p) * V_p, C44 = density * Real(V_s) * V_s, difference = C33 - C44;
  const Real C13 = sqrt(difference * difference + 2 * Real(p.delta) * C33 * difference) - C44;
  const Real C11 = C33 * (1 + 2 * Real(p.epsilon)), C12 = C11 - 2 * C44 * (1 + 2 * Real(p.gamma));
  const auto c = transversely_isotropic(granum::elastic::ThomsenSolid{density, V_p, V_s, p});
  const std::string at =
      said({{"V_p", V_p}, {"V_s", V_s}, {"epsilon", p.epsilon}, {"delta", p.delta}, {"gamma", p.gamma}});
  const std::pair<double, Real> entries[] = {
      {c.C11, C11}, {c.C33, C33}, {c.C12, C12}, {c.C13, C13}, {c.C44, C44}};
  for (const auto& [value, reference] : entries)
    table.take_against("transversely_isotropic(ThomsenSolid)", "V_p 2 to 5 V_s, of C33", closed_form, value,
                       reference, C33, at);
}

void check_isotropic_speeds(Table& table, Draw& draw) {
  const double K = draw.log_uniform(1e-3, 1e12), G = K * draw.log_uniform(1e-3, 1e3);
  const granum::elastic::GrainsAndPores mass{draw.log_uniform(1, 1e5), draw.log_uniform(0.01, 100),
                                             draw.uniform_or(0, 2000, {0.0, 1000.0})};
  const double density = granum::elastic::bulk_density(mass);
  const std::string at = said({{"K", K}, {"G", G}, {"density", density}, {"e", mass.void_ratio}});
  table.take("bulk_density", "e 0.01 to 100, dry or filled", closed_form, density,
             (Real(mass.grain_density) + Real(mass.void_ratio) * mass.pore_density) /
                 (1 + Real(mass.void_ratio)),
             at);
  const auto v = wave_speeds(granum::elastic::Isotropic::from_bulk_and_shear(K, G), density);
  table.take("wave_speeds", "G/K from 1e-3 to 1e3", closed_form, v.p, sqrt((K + 4 * Real(G) / 3) / density),
             at);
  table.take("wave_speeds", "G/K from 1e-3 to 1e3", closed_form, v.s, sqrt(Real(G) / density), at);
}

} // namespace

void check_waves(Table& table, std::size_t samples) {
  Draw draw(12);
  for (std::size_t k = 0; k < samples; ++k) {
    check_waves_in_transverse_isotropy(table, draw);
    check_full(table, draw);
    TransverselyIsotropic c = draw_stiffness(draw);
    check_thomsen(table, c, "C12, C13 from -0.3 to 0.5 C11");
    c.C11 = c.C33 * (1 + draw.log_uniform(1e-16, 1e-1));
    c.C13 = (c.C33 - 2 * c.C44) * (1 + draw.log_uniform(1e-16, 1e-1));
    c.C12 = (c.C11 - 2 * c.C44) * (1 - draw.log_uniform(1e-16, 1e-1));
    check_thomsen(table, c, "nearly isotropic");
    check_thomsen_inverse(table, draw);
    check_isotropic_speeds(table, draw);
  }
}

} // namespace accuracy
