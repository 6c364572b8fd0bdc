// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues by GSL: Eigen's dense solvers take a minute to compile. Products are sparse, for builds that do
// not optimise.
#include "dense_twin.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

#include <Eigen/SparseCore>
#include <gsl/gsl_eigen.h>

namespace granum::twin {

namespace {

constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

using Dense = Unknowns;
using Sparse = Eigen::SparseMatrix<double>;
using Eigen::Matrix3d;

struct EigenSystem {
  Eigen::VectorXd values;
  Dense vectors; ///< rows
};

EigenSystem eigen_system(Dense m) {
  const auto n = static_cast<std::size_t>(m.rows());
  EigenSystem system{Eigen::VectorXd(m.rows()), Dense(m.rows(), m.rows())};
  gsl_matrix_view a = gsl_matrix_view_array(m.data(), n, n),
                  vectors = gsl_matrix_view_array(system.vectors.data(), n, n); // columns, stored by rows
  gsl_vector_view values = gsl_vector_view_array(system.values.data(), n);
  const std::unique_ptr<gsl_eigen_symmv_workspace, decltype(&gsl_eigen_symmv_free)> work(
      gsl_eigen_symmv_alloc(n), gsl_eigen_symmv_free);
  if (gsl_eigen_symmv(&a.matrix, &values.vector, &vectors.matrix, work.get()) != GSL_SUCCESS)
    throw std::runtime_error("no eigenvalues");
  return system;
}

/// The pseudo-inverse of a symmetric matrix, times w.
Dense solve(const Dense& m, const Dense& w) {
  const EigenSystem system = eigen_system(m);
  const double least = 1e-11 * system.values.cwiseAbs().maxCoeff();
  Dense q = system.vectors * w;
  for (int r = 0; r < q.rows(); ++r)
    q.row(r) *= std::abs(system.values[r]) > least ? 1 / system.values[r] : 0.0;
  return system.vectors.transpose() * q;
}

/// w x o is this times w.
Matrix3d turned(const Vec3& o) {
  Matrix3d m;
  m << 0, o.z, -o.y, -o.z, 0, o.x, o.y, -o.x, 0;
  return m;
}

void add(Sparse& to, int row, int column, const Matrix3d& block) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      to.coeffRef(row + r, column + c) += block(r, c);
}

int first_of(std::uint32_t number) { return 6 * static_cast<int>(number); }

/// Motions of the grains by those of their bodies, u and w of each; a body turns about its first grain.
struct Rigid {
  Sparse motion;            ///< 6 rows a grain, 6 columns a body
  std::vector<Vec3> offset; ///< of each grain from the first of its body
};

Rigid rigid_bodies(const packing::Assembly& a) {
  const auto n = static_cast<std::uint32_t>(a.grain_count());
  Rigid out{Sparse(first_of(n), first_of(*std::max_element(a.body.begin(), a.body.end()) + 1)),
            std::vector<Vec3>(n)};
  const Mat3 parts = inverse_of(a.cell);
  for (std::uint32_t g = 0; g < n; ++g) {
    const auto first = std::find(a.body.begin(), a.body.end(), a.body[g]) - a.body.begin();
    Vec3 part = parts * (a.position[g] - a.position[static_cast<std::size_t>(first)]);
    for (int d = 0; d < 3; ++d)
      part[d] -= std::round(part[d]);
    out.offset[g] = a.cell * part;
    const int row = first_of(g), column = first_of(a.body[g]);
    add(out.motion, row, column, Matrix3d::Identity());
    add(out.motion, row + 3, column + 3, Matrix3d::Identity());
    add(out.motion, row, column + 3, turned(out.offset[g]));
  }
  return out;
}

/// The quadratic form of k in b x.
Sparse energy(const Sparse& k, const Sparse& b) {
  const Sparse transposed = b.transpose(), forces = k * b;
  return transposed * forces;
}

} // namespace

// Notation: rows of all matrices are the three directions at each contact; b relative displacement at the
// contact from the unknowns, v that of the centres, t the turn of one grain against the other, e displacement
// of the centres from the strains; k contact stiffness, g prestress, r stiffness against turning.
Response response(const packing::Assembly& a, bool prestress) {
  const std::size_t between = a.contacts.size(), contacts = between + a.wall_contacts.size();
  const int unknowns = first_of(static_cast<std::uint32_t>(a.grain_count())),
            m = 3 * static_cast<int>(contacts);
  const bool bodies = !a.body.empty();
  const Rigid rigid = bodies ? rigid_bodies(a) : Rigid{};
  Sparse b(m, unknowns), v = b, t = b, k(m, m), g = k, r = k;
  Dense e = Dense::Zero(m, 6);
  for (std::size_t at = 0; at < contacts; ++at) {
    const bool wall = at >= between;
    const packing::Contact& contact = wall ? a.wall_contacts[at - between] : a.contacts[at];
    const int row = 3 * static_cast<int>(at);
    const Vec3 l = contact.branch, n = normal(contact);
    const Eigen::Vector3d normal_vector(n.x, n.y, n.z);
    const Matrix3d identity = Matrix3d::Identity(), along = normal_vector * normal_vector.transpose(),
                   across = identity - along;
    const double sum = a.radius[contact.i] + (wall ? 0 : a.radius[contact.j]);
    const auto add_grain = [&](std::uint32_t grain, double sign) {
      add(v, row, first_of(grain), sign * identity);
      add(b, row, first_of(grain), sign * identity);
      add(b, row, first_of(grain) + 3, -a.radius[grain] / sum * turned(l));
      add(t, row, first_of(grain) + 3, sign * identity);
    };
    add_grain(contact.i, -1);
    if (!wall)
      add_grain(contact.j, 1);
    add(k, row, row, contact.normal_stiffness * along + contact.tangential_stiffness * across);
    add(r, row, row, contact.twisting_stiffness * along + contact.rolling_stiffness * across);
    if (prestress)
      add(g, row, row, -contact.normal_force / norm(l) * across);
    const Vec3 moved = !bodies ? l
                       : wall  ? l + rigid.offset[contact.i]
                               : l - (rigid.offset[contact.j] - rigid.offset[contact.i]);
    for (int c = 0; c < 6; ++c) {
      const auto [p, q] = pairs[c];
      e(row + p, c) += moved[q] / 2;
      e(row + q, c) += moved[p] / 2;
    }
  }
  const Dense with_k = k * e, with_g = g * e;
  Dense w = b.transpose() * with_k + v.transpose() * with_g;
  Sparse h = energy(k, b) + energy(g, v) + energy(r, t);
  if (bodies) {
    w = (rigid.motion.transpose() * w).eval();
    h = energy(h, rigid.motion);
  }
  const Dense q = -solve(h, w);
  const Matrix6 affine = e.transpose() * (with_k + with_g);
  return {.affine = affine / a.volume(),
          .relaxed = (affine + w.transpose() * q) / a.volume(),
          .stiffness = h,
          .motions = q};
}

Matrix6 contact_sum(const packing::Assembly& a) {
  Matrix6 sum = Matrix6::Zero();
  for (const packing::Contact& c : a.contacts) {
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

double distance(const Matrix6& a, const Matrix6& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

double smallest_eigenvalue(const Matrix6& m) { return eigen_system(m).values.minCoeff(); }

} // namespace granum::twin
