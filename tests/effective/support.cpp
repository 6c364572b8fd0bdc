// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <algorithm>

#include <Eigen/LU>
#include <granum/core/numerics.hpp>

namespace granum::test {

std::array<Eigen::Matrix3d, 6> symmetric_basis() {
  std::array<Eigen::Matrix3d, 6> basis;
  constexpr std::array<std::array<int, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  for (std::size_t b = 0; b < 6; ++b) {
    const auto [i, j] = pairs[b];
    basis[b].setZero();
    basis[b](i, j) += i == j ? 1 : std::sqrt(0.5);
    if (i != j)
      basis[b](j, i) += std::sqrt(0.5);
  }
  return basis;
}

Matrix6 stiffness_by_strain(double P, const std::vector<Direction>& directions) {
  const auto basis = symmetric_basis();
  Matrix6 C = Matrix6::Zero();
  for (const Direction& d : directions)
    for (std::size_t a = 0; a < 6; ++a)
      for (std::size_t b = 0; b < 6; ++b) {
        const Eigen::Vector3d u = basis[a] * d.normal, v = basis[b] * d.normal;
        const double normal = u.dot(d.normal) * v.dot(d.normal);
        C(int(a), int(b)) += P * d.share * (d.k_n * normal + d.k_t * (u.dot(v) - normal));
      }
  return C;
}

Matrix6 stiffness_by_stress(double P, const std::vector<Direction>& directions) {
  const auto basis = symmetric_basis();
  Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
  for (const Direction& d : directions)
    F += d.share * d.normal * d.normal.transpose();
  const Eigen::Matrix3d inverse = F.inverse();
  Matrix6 S = Matrix6::Zero();
  for (const Direction& d : directions)
    for (std::size_t a = 0; a < 6; ++a)
      for (std::size_t b = 0; b < 6; ++b) {
        const Eigen::Vector3d u = basis[a] * inverse * d.normal, v = basis[b] * inverse * d.normal;
        const double normal = u.dot(d.normal) * v.dot(d.normal);
        S(int(a), int(b)) += d.share / P * (normal / d.k_n + (u.dot(v) - normal) / d.k_t);
      }
  return S.inverse();
}

std::vector<Direction> directions_of(const State& s, int along) {
  const double a = s.fabric_anisotropy;
  const double grain_volume = 4.0 / 3 * M_PI * std::pow(s.radius, 3);
  const double grains = 1 / (grain_volume * (1 + s.void_ratio));
  const double contacts = grains * *s.coordination_number / 2;
  const double F33 = (5 + a) / (5 * (3 - a)), F11 = (1 - F33) / 2;
  std::vector<Direction> directions;
  constexpr int around = 8; // exact for the fourth powers of cos and sin
  for (const auto& [x, w] : gauss_legendre(along))
    for (int i = 0; i < around; ++i) {
      const double phi = 2 * M_PI * (i + 0.3) / around, sine = std::sqrt((1 - x) * (1 + x));
      const double density = 3 * (1 + a * (2 * x * x - 1)) / (4 * M_PI * (3 - a));
      const double force =
          (s.stress_h * sine * sine / F11 + s.stress_v * x * x / F33) / (contacts * 2 * s.radius);
      const double k_n = s.law.stiffness_at_force(force);
      directions.push_back({{sine * std::cos(phi), sine * std::sin(phi), x},
                            density * w * 2 * M_PI / around,
                            k_n,
                            s.tangential_ratio * k_n});
    }
  return directions;
}

} // namespace granum::test
