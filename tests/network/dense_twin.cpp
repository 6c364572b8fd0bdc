// SPDX-License-Identifier: GPL-3.0-or-later
// Plain loops and GSL: Eigen's dense solvers take a minute to compile.
#include "dense_twin.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>

#include <gsl/gsl_eigen.h>

namespace granum::twin {

namespace {

constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

class Dense {
 public:
  Dense(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), values_(rows * columns) {}

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  double& operator()(std::size_t r, std::size_t c) { return values_[r * columns_ + c]; }
  double operator()(std::size_t r, std::size_t c) const { return values_[r * columns_ + c]; }

 private:
  std::size_t rows_, columns_;
  std::vector<double> values_;
};

Dense dense(const Matrix6& m) {
  Dense out(6, 6);
  for (std::size_t r = 0; r < 6; ++r)
    for (std::size_t c = 0; c < 6; ++c)
      out(r, c) = m(static_cast<int>(r), static_cast<int>(c));
  return out;
}

Matrix6 matrix6(const Dense& m) {
  Matrix6 out;
  for (std::size_t r = 0; r < 6; ++r)
    for (std::size_t c = 0; c < 6; ++c)
      out(static_cast<int>(r), static_cast<int>(c)) = m(r, c);
  return out;
}

Unknowns unknowns(const Dense& m) {
  Unknowns out(static_cast<int>(m.rows()), static_cast<int>(m.columns()));
  for (std::size_t r = 0; r < m.rows(); ++r)
    for (std::size_t c = 0; c < m.columns(); ++c)
      out(static_cast<int>(r), static_cast<int>(c)) = m(r, c);
  return out;
}

Dense transposed(const Dense& m) {
  Dense out(m.columns(), m.rows());
  for (std::size_t r = 0; r < m.rows(); ++r)
    for (std::size_t c = 0; c < m.columns(); ++c)
      out(c, r) = m(r, c);
  return out;
}

Dense operator+(Dense a, const Dense& b) {
  for (std::size_t r = 0; r < a.rows(); ++r)
    for (std::size_t c = 0; c < a.columns(); ++c)
      a(r, c) += b(r, c);
  return a;
}

Dense operator*(const Dense& a, const Dense& b) {
  Dense out(a.rows(), b.columns());
  for (std::size_t r = 0; r < a.rows(); ++r)
    for (std::size_t k = 0; k < a.columns(); ++k)
      if (const double x = a(r, k); x != 0) // most are zero
        for (std::size_t c = 0; c < b.columns(); ++c)
          out(r, c) += x * b(k, c);
  return out;
}

struct EigenSystem {
  std::vector<double> values;
  Dense vectors; ///< columns
};

EigenSystem eigen_system(const Dense& m) {
  const std::size_t n = m.rows();
  const std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)> a(gsl_matrix_alloc(n, n), gsl_matrix_free),
      vectors(gsl_matrix_alloc(n, n), gsl_matrix_free);
  const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> values(gsl_vector_alloc(n), gsl_vector_free);
  const std::unique_ptr<gsl_eigen_symmv_workspace, decltype(&gsl_eigen_symmv_free)> work(
      gsl_eigen_symmv_alloc(n), gsl_eigen_symmv_free);
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c < n; ++c)
      gsl_matrix_set(a.get(), r, c, m(r, c));
  if (gsl_eigen_symmv(a.get(), values.get(), vectors.get(), work.get()) != GSL_SUCCESS)
    throw std::runtime_error("no eigenvalues");
  EigenSystem system{std::vector<double>(n), Dense(n, n)};
  for (std::size_t r = 0; r < n; ++r) {
    system.values[r] = gsl_vector_get(values.get(), r);
    for (std::size_t c = 0; c < n; ++c)
      system.vectors(r, c) = gsl_matrix_get(vectors.get(), r, c);
  }
  return system;
}

/// The pseudo-inverse of a symmetric matrix, times w.
Dense solve(const Dense& m, const Dense& w) {
  const EigenSystem system = eigen_system(m);
  double largest = 0;
  for (const double x : system.values)
    largest = std::max(largest, std::abs(x));
  Dense q = transposed(system.vectors) * w;
  for (std::size_t r = 0; r < q.rows(); ++r) {
    const double x = system.values[r], factor = std::abs(x) > 1e-11 * largest ? 1 / x : 0.0;
    for (std::size_t c = 0; c < q.columns(); ++c)
      q(r, c) *= factor;
  }
  return system.vectors * q;
}

double delta(std::size_t i, std::size_t j) { return i == j ? 1 : 0; }

/// Motions of the grains by those of their bodies, u and w of each; a body turns about its first grain.
struct Rigid {
  Dense motion;             ///< 6 rows a grain, 6 columns a body
  std::vector<Vec3> offset; ///< of each grain from the first of its body
};

Rigid rigid_bodies(const packing::Assembly& a) {
  const std::size_t n = a.grain_count();
  const std::size_t bodies = *std::max_element(a.body.begin(), a.body.end()) + std::size_t{1};
  Rigid out{Dense(6 * n, 6 * bodies), std::vector<Vec3>(n)};
  const Mat3 parts = inverse_of(a.cell);
  for (std::size_t g = 0; g < n; ++g) {
    const std::size_t first =
        static_cast<std::size_t>(std::find(a.body.begin(), a.body.end(), a.body[g]) - a.body.begin());
    Vec3 part = parts * (a.position[g] - a.position[first]);
    for (int d = 0; d < 3; ++d)
      part[d] -= std::round(part[d]);
    const Vec3 o = out.offset[g] = a.cell * part;
    const double cross[3][3] = {{0, o.z, -o.y}, {-o.z, 0, o.x}, {o.y, -o.x, 0}}; // w x o = cross * w
    for (std::size_t d = 0; d < 3; ++d) {
      out.motion(6 * g + d, 6 * std::size_t{a.body[g]} + d) = 1;
      out.motion(6 * g + 3 + d, 6 * std::size_t{a.body[g]} + 3 + d) = 1;
      for (std::size_t c = 0; c < 3; ++c)
        out.motion(6 * g + d, 6 * std::size_t{a.body[g]} + 3 + c) = cross[d][c];
    }
  }
  return out;
}

/// H of the moments of contacts that resist turning.
Dense turning(const packing::Assembly& a) {
  const std::size_t n = a.grain_count(), between = a.contacts.size(), m = between + a.wall_contacts.size();
  Dense t(3 * m, 6 * n), k(3 * m, 3 * m);
  for (std::size_t row = 0; row < 3 * m; ++row) {
    const bool wall = row / 3 >= between;
    const packing::Contact& contact = wall ? a.wall_contacts[row / 3 - between] : a.contacts[row / 3];
    const std::size_t d = row % 3;
    t(row, 6 * std::size_t{contact.i} + 3 + d) = -1;
    if (!wall)
      t(row, 6 * std::size_t{contact.j} + 3 + d) = 1;
    const Vec3 normals = normal(contact);
    for (std::size_t c = 0; c < 3; ++c) {
      const double along = normals[static_cast<int>(d)] * normals[static_cast<int>(c)];
      k(row, row - d + c) =
          contact.twisting_stiffness * along + contact.rolling_stiffness * (delta(d, c) - along);
    }
  }
  return transposed(t) * (k * t);
}

} // namespace

// Notation: rows of all matrices are the three directions at each contact; b relative displacement at the
// contact from the unknowns, v that of the centres, e that of the centres from the strains; k contact
// stiffness, g prestress.
Response response(const packing::Assembly& a, bool prestress) {
  const std::size_t n = a.grain_count(), between = a.contacts.size(), m = between + a.wall_contacts.size();
  const Rigid rigid = a.body.empty() ? Rigid{Dense(0, 0), {}} : rigid_bodies(a);
  Dense b(3 * m, 6 * n), v = b, e(3 * m, 6), k(3 * m, 3 * m), g = k;
  for (std::size_t row = 0; row < 3 * m; ++row) {
    const bool wall = row / 3 >= between;
    const packing::Contact& contact = wall ? a.wall_contacts[row / 3 - between] : a.contacts[row / 3];
    const std::size_t d = row % 3, i = 6 * std::size_t{contact.i}, j = 6 * std::size_t{contact.j};
    const double sum = a.radius[contact.i] + (wall ? 0 : a.radius[contact.j]);
    const Vec3 l = contact.branch, normals = normal(contact);
    const double cross[3][3] = {{0, l.z, -l.y}, {-l.z, 0, l.x}, {l.y, -l.x, 0}}; // w x branch = cross * w
    v(row, i + d) = -1;
    if (!wall)
      v(row, j + d) = 1;
    const int axis = static_cast<int>(d);
    for (std::size_t c = 0; c < 3; ++c) {
      b(row, i + 3 + c) = -a.radius[contact.i] / sum * cross[d][c];
      if (!wall)
        b(row, j + 3 + c) = -a.radius[contact.j] / sum * cross[d][c];
      const double along = normals[axis] * normals[static_cast<int>(c)], across = delta(d, c) - along;
      k(row, row - d + c) = contact.normal_stiffness * along + contact.tangential_stiffness * across;
      if (prestress)
        g(row, row - d + c) = -contact.normal_force / norm(l) * across;
    }
    const Vec3 moved = a.body.empty() ? l
                       : wall         ? l + rigid.offset[contact.i]
                                      : l - (rigid.offset[contact.j] - rigid.offset[contact.i]);
    for (std::size_t c = 0; c < 6; ++c) {
      const auto [p, q] = pairs[c];
      e(row, c) += (p == axis ? moved[q] / 2 : 0) + (q == axis ? moved[p] / 2 : 0);
    }
  }
  b = b + v;
  const Dense bk = transposed(b) * k, vg = transposed(v) * g;
  Dense w = bk * e + vg * e, h = bk * b + vg * v + turning(a);
  if (!a.body.empty()) {
    w = transposed(rigid.motion) * w;
    h = transposed(rigid.motion) * (h * rigid.motion);
  }
  Dense q = solve(h, w);
  for (std::size_t r = 0; r < q.rows(); ++r)
    for (std::size_t c = 0; c < 6; ++c)
      q(r, c) = -q(r, c);
  const Dense energy = transposed(e) * ((k + g) * e),
              forces = k * (e + b * (a.body.empty() ? q : rigid.motion * q));
  Response out{.affine = matrix6(energy) / a.volume(),
               .relaxed = matrix6(energy + transposed(w) * q) / a.volume(),
               .contact_forces = std::vector<Strain>(m),
               .stiffness = unknowns(h),
               .motions = unknowns(q)};
  for (std::size_t row = 0; row < 3 * m; ++row)
    for (std::size_t c = 0; c < 6; ++c)
      out.contact_forces[row / 3](static_cast<int>(row % 3), static_cast<int>(c)) = forces(row, c);
  return out;
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

Matrix6 inverse(const Matrix6& m) { return matrix6(solve(dense(m), dense(Matrix6::Identity()))); }

double smallest_eigenvalue(const Matrix6& m) {
  const std::vector<double> values = eigen_system(dense(m)).values;
  return *std::min_element(values.begin(), values.end());
}

} // namespace granum::twin
