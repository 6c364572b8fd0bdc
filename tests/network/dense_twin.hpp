// SPDX-License-Identifier: GPL-3.0-or-later
// The network response by other means: one dense matrix in dimensional unknowns u, w, no grain left out, and
// a pseudo-inverse by eigenvalues. Slow and short.
#pragma once

#include <cmath>

#include <Eigen/Dense>

#include <granum/assembly/assembly.hpp>
#include <granum/elastic/stiffness.hpp>

namespace granum::twin {

using elastic::Matrix6;
using Strain = Eigen::Matrix<double, 3, 6>;

inline Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Relative displacement of two centres for the six unit strains.
inline Strain branch_strain(const Vec3& b) {
  Strain e = Strain::Zero();
  const int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  for (int k = 0; k < 6; ++k) {
    const auto [i, j] = pairs[k];
    e(i, k) += b[j] / 2;
    e(j, k) += b[i] / 2;
  }
  return e;
}

inline Eigen::Matrix3d contact_matrix(const Contact& c) {
  const Eigen::Vector3d n = eigen(normal(c));
  return c.normal_stiffness * n * n.transpose() +
         c.tangential_stiffness * (Eigen::Matrix3d::Identity() - n * n.transpose());
}

inline Eigen::Matrix3d prestress_matrix(const Contact& c) {
  const Eigen::Vector3d n = eigen(normal(c));
  return -c.normal_force / norm(c.branch) * (Eigen::Matrix3d::Identity() - n * n.transpose());
}

struct Response {
  Matrix6 affine = Matrix6::Zero(); ///< over all contacts, rattlers' too
  Matrix6 relaxed = Matrix6::Zero();
  Eigen::MatrixXd contact_forces; ///< 3 N_c x 6: under the six unit strains, without the prestress term
};

/// Walls count without prestress.
inline Response response(const Assembly& a, bool prestress) {
  const auto n = static_cast<Eigen::Index>(a.grain_count()),
             pairs = static_cast<Eigen::Index>(a.contacts.size()),
             m = pairs + static_cast<Eigen::Index>(a.wall_contacts.size());
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(3 * m, 6 * n), v = b, e(3 * m, 6);
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3 * m, 3 * m), g = k;
  for (Eigen::Index c = 0; c < m; ++c) {
    const bool wall = c >= pairs;
    const Contact& contact =
        wall ? a.wall_contacts[static_cast<std::size_t>(c - pairs)] : a.contacts[static_cast<std::size_t>(c)];
    const Eigen::Index i = 6 * static_cast<Eigen::Index>(contact.i),
                       j = 6 * static_cast<Eigen::Index>(contact.j);
    const double sum = a.radius[contact.i] + (wall ? 0 : a.radius[contact.j]);
    Eigen::Matrix3d cross; // w x branch = cross * w
    const Vec3 l = contact.branch;
    cross << 0, l.z, -l.y, -l.z, 0, l.x, l.y, -l.x, 0;
    v.block<3, 3>(3 * c, i) = -Eigen::Matrix3d::Identity();
    b.block<3, 3>(3 * c, i + 3) = -a.radius[contact.i] / sum * cross;
    if (!wall) {
      v.block<3, 3>(3 * c, j) = Eigen::Matrix3d::Identity();
      b.block<3, 3>(3 * c, j + 3) = -a.radius[contact.j] / sum * cross;
    }
    e.middleRows<3>(3 * c) = branch_strain(contact.branch);
    k.block<3, 3>(3 * c, 3 * c) = contact_matrix(contact);
    if (prestress)
      g.block<3, 3>(3 * c, 3 * c) = prestress_matrix(contact);
  }
  b += v;
  const Eigen::MatrixXd h = b.transpose() * k * b + v.transpose() * g * v;
  const Eigen::MatrixXd w = b.transpose() * k * e + v.transpose() * g * e;
  const Matrix6 energy = e.transpose() * (k + g) * e;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(h);
  const double largest = solver.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::VectorXd inverse =
      solver.eigenvalues().unaryExpr([&](double x) { return std::abs(x) > 1e-11 * largest ? 1 / x : 0.0; });
  const Eigen::MatrixXd q =
      -(solver.eigenvectors() * (inverse.asDiagonal() * (solver.eigenvectors().transpose() * w)));
  return {energy / a.volume(), (energy + w.transpose() * q) / a.volume(), k * (e + b * q)};
}

/// The closed sum over contacts, uniform strain, no spin. [Walton1987]
inline Matrix6 contact_sum(const Assembly& a) {
  const int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  Matrix6 sum = Matrix6::Zero();
  for (const Contact& c : a.contacts) {
    const Vec3 n = normal(c);
    const double l2 = dot(c.branch, c.branch), kn = c.normal_stiffness, kt = c.tangential_stiffness;
    for (int r = 0; r < 6; ++r)
      for (int s = 0; s < 6; ++s) {
        const auto [i, j] = pairs[r];
        const auto [k, l] = pairs[s];
        sum(r, s) += l2 * ((kn - kt) * n[i] * n[j] * n[k] * n[l] +
                           kt / 4 *
                               (n[i] * n[k] * (j == l) + n[i] * n[l] * (j == k) + n[j] * n[k] * (i == l) +
                                n[j] * n[l] * (i == k)));
      }
  }
  return sum / a.volume();
}

/// Largest difference relative to the largest element.
inline double distance(const Matrix6& a, const Matrix6& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

} // namespace granum::twin
