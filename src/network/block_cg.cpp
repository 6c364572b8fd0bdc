// SPDX-License-Identifier: GPL-3.0-or-later
// Block conjugate gradients whose residuals are kept orthonormal [OLeary1980; Dubrulle2001]: as the load
// cases converge, their residuals become combinations of the few softest modes, and a plain block method
// loses its directions. Notation: q solution; residual r = w sigma with w^T z = 1, z = M^-1 w; directions p,
// s = H p, zeta = (p^T s)^-1.
#include "block_cg.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <granum/elastic/stiffness.hpp>

#include "core/vector/level.hpp"

namespace granum::network {

namespace {

using elastic::Matrix6;

// Directions whose scaled energy is below this are rounding noise of the others.
constexpr double dependent = 1e-13;
// A negative energy of this relative size is not rounding noise.
constexpr double indefinite = 1e-8;
// Forces below this part of the terms that cancel in them are rounding noise: a lattice has W = 0.
constexpr double noise = 1e-13;
// Residuals are relative to at least this fraction of those terms. In a lattice with rounded positions W is
// 1e-10 of them, and the tolerance would require less than the rounding of one force. The error of the work
// is r^T H^-1 r, with r = 1e-13 of the terms at the tolerance 1e-10.
constexpr double least_load = 1e-3;
// The recursive residual drifts from the true one; restarts begin with the true one.
constexpr int restarts = 5;
// Loose networks have modes without stiffness, and others with 1e-13 of the usual one. The former carry no
// load, but rounding can grow along them without limit. Growth of the residual over its least value that no
// regular solution shows:
constexpr double runaway = 1e6;
// Solutions with a smaller residual are kept: if the tolerance is below what rounding allows, later ones may
// be far worse.
constexpr double near_rounding = 1e-11;
// Springs to the ground with which the solver then restarts, over the mean k_n.
constexpr double holding_spring = 1e-14;

// An energy is a sum over contacts whose stiffness is about 1; the rounding of each is this fraction of the
// squares of the motion.
constexpr double rounding_of_energy = 1e-14;

using Vector6 = Eigen::Matrix<double, 6, 1>;

struct Whitening {
  Matrix6 matrix; ///< T with T^T m T = 1 on the independent directions; dropped directions are zero columns
  Vector6 negative = Vector6::Zero(); ///< a direction along which m is negative, if there is one
  [[nodiscard]] bool positive() const { return negative.isZero(0); }
};

/// Whitening of a positive semidefinite matrix m whose rows may differ in scale by many orders.
Whitening whitening(const Matrix6& m) {
  const Vector6 diagonal = m.diagonal();
  if (Eigen::Index least = 0; diagonal.minCoeff(&least) < 0)
    return {Matrix6::Zero(), Vector6::Unit(least)};
  const Vector6 scale = diagonal.unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.0; });
  const Matrix6 scaled = scale.asDiagonal() * ((m + m.transpose()) / 2) * scale.asDiagonal();
  const elastic::EigenSystem eigen = elastic::eigen_system(scaled);
  const double largest = eigen.values[5];
  if (eigen.values[0] < -indefinite * largest)
    return {Matrix6::Zero(), scale.asDiagonal() * eigen.vectors.col(0)};
  const Vector6 inverse_root =
      eigen.values.unaryExpr([&](double v) { return v > dependent * largest ? 1 / std::sqrt(v) : 0.0; });
  return {scale.asDiagonal() * eigen.vectors * inverse_root.asDiagonal()};
}

template <int Dof>
class Relaxation {
 public:
  Relaxation(const Backbone& backbone, const Preconditioner<Dof>& preconditioner,
             const ResponseOptions& options, const Workers& workers)
      : backbone_(backbone), preconditioner_(preconditioner), options_(options), workers_(workers),
        load_(affine_forces<Dof>(backbone)), q_(load_.size()), w_(load_.size()), p_(load_.size()),
        s_(load_.size()) {
    const PerCase terms = affine_force_scale(backbone);
    silence_noise(terms);
    size_ = norms(load_);
    for (std::size_t c = 0; c < size_.size(); ++c)
      if (size_[c] > 0)
        size_[c] = std::max(size_[c], least_load * terms[c]);
  }

  Solution run() {
    Solution solution;
    PerCase size = true_residual();
    for (int start = 0; start < restarts && !arrived(size) && solution.status == Status::converged; ++start) {
      solution.status = iterate(solution.iterations);
      if (ran_away_ && hold_ == 0) {
        hold_ = holding_spring;
        q_.assign(q_.size(), {});
      }
      size = true_residual();
    }
    if (!arrived(size) && !best_.empty() && best_residual_ < worst_of(size)) {
      q_ = best_;
      size = true_residual();
      if (solution.status ==
          Status::not_positive_definite) // it appeared after the best solution: by rounding
        solution.status = Status::iteration_limit;
    }
    if (solution.status == Status::converged && !arrived(size))
      solution.status = Status::iteration_limit;
    solution.residual = worst_of(size);
    solution.work = products<Dof>(workers_, load_, q_);
    solution.by_forces = force_energies<Dof>(backbone_, q_);
    if (options_.motions)
      solution.motions = motions();
    return solution;
  }

 private:
  [[nodiscard]] StrainMotions motions() const {
    StrainMotions out;
    for (int c = 0; c < load_cases; ++c)
      for (const Rows<Dof>& grain : q_) {
        GrainMotion& motion = out[static_cast<std::size_t>(c)].emplace_back();
        for (int d = 0; d < Dof; ++d)
          (d < 3 ? motion.displacement : motion.turn)[d % 3] = grain.row[d][c];
      }
    return out;
  }

  /// Whether the energy of a negative direction of p is beyond rounding. Never for contacts without
  /// prestress.
  [[nodiscard]] bool is_unstable(const Matrix6& energies, const Vector6& direction) const {
    const double energy = direction.dot(energies * direction);
    const double squares = direction.dot(products<Dof>(workers_, p_, p_) * direction);
    return energy < -rounding_of_energy * squares;
  }

  /// For load cases whose forces cancel on every grain, q = 0 is the solution.
  void silence_noise(const PerCase& terms) {
    const PerCase size = norms(load_);
    for (std::size_t c = 0; c < size.size(); ++c)
      if (size[c] <= noise * terms[c])
        for (Rows<Dof>& grain : load_)
          for (Lanes& row : grain.row)
            row[c] = 0;
  }

  [[nodiscard]] PerCase norms(const Field<Dof>& x) const {
    const Matrix6 squares = products<Dof>(workers_, x, x);
    PerCase result{};
    for (int c = 0; c < load_cases; ++c)
      result[static_cast<std::size_t>(c)] = std::sqrt(squares(c, c));
    return result;
  }

  [[nodiscard]] bool arrived(const PerCase& size) const {
    for (std::size_t c = 0; c < size.size(); ++c)
      if (!(size[c] <= options_.tolerance * size_[c]))
        return false;
    return true;
  }

  /// Largest residual over its load.
  [[nodiscard]] double worst_of(const PerCase& size) const {
    double worst = 0;
    for (std::size_t c = 0; c < size.size(); ++c)
      if (size_[c] > 0)
        worst = std::max(worst, size[c] / size_[c]);
    return worst;
  }

  /// w = -load - H q; returns its size.
  PerCase true_residual() {
    apply_stiffness<Dof>(backbone_, workers_, hold_, q_, s_);
    workers_.blocks(w_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t g = first; g < last; ++g)
        for (int d = 0; d < Dof; ++d)
          w_[g].row[d] = -load_[g].row[d] - s_[g].row[d];
    });
    return norms(w_);
  }

  /// Splits w = w' tau so that w'^T M^-1 w' = 1, leaves w' in w and p = M^-1 w' + p tau^T; returns tau.
  Matrix6 turn_directions() {
    Field<Dof>& z = s_; // never needed at the same time
    preconditioner_.solve(w_, z);
    const Matrix6 metric = products<Dof>(workers_, w_, z);
    const Matrix6 t = whitening(metric).matrix;
    const Matrix6 tau = t.transpose() * metric;
    turn<Dof>(workers_, t, w_, z, tau.transpose(), p_);
    return tau;
  }

  Status iterate(int& iterations) {
    preconditioner_.lift_coarse_residual(w_, q_);
    true_residual();
    p_.assign(p_.size(), {});
    Matrix6 sigma = turn_directions();
    double least = std::numeric_limits<double>::infinity();
    ran_away_ = false;
    while (iterations < options_.iteration_limit) {
      if (is_stopped(options_.stop_requested))
        return Status::stopped;
      ++iterations;
      apply_stiffness<Dof>(backbone_, workers_, hold_, p_, s_);
      const Matrix6 energies = products<Dof>(workers_, p_, s_);
      const Whitening energy = whitening(energies);
      if (!energy.positive())
        return is_unstable(energies, energy.negative) ? Status::not_positive_definite
                                                      : Status::iteration_limit;
      const Matrix6 zeta = energy.matrix * energy.matrix.transpose();
      const Matrix6 squares = advance<Dof>(workers_, p_, zeta * sigma, q_, s_, -zeta, w_);
      const PerCase size = residual_size(sigma, squares);
      if (arrived(size))
        return Status::converged;
      const double worst = worst_of(size);
      if (worst < best_residual_) {
        best_residual_ = worst;
        best_ = q_;
      }
      least = std::min(least, worst);
      ran_away_ = worst > runaway * least;
      if (ran_away_)
        return Status::converged; // the caller computes the true residual
      sigma = turn_directions() * sigma;
    }
    return Status::iteration_limit;
  }

  /// Size of the residual w sigma, of w^T w.
  static PerCase residual_size(const Matrix6& sigma, const Matrix6& squares) {
    const Matrix6 turned = sigma.transpose() * squares * sigma;
    PerCase size{};
    for (int c = 0; c < load_cases; ++c)
      size[static_cast<std::size_t>(c)] = std::sqrt(std::max(0.0, turned(c, c)));
    return size;
  }

  const Backbone& backbone_;
  const Preconditioner<Dof>& preconditioner_;
  const ResponseOptions& options_;
  const Workers& workers_;
  Field<Dof> load_, q_, w_, p_, s_;
  Field<Dof> best_; ///< q with the least residual near rounding
  double best_residual_ = near_rounding;
  PerCase size_{}; ///< of load_, or least_load of its terms; the unit of residuals
  double hold_ = 0;
  bool ran_away_ = false; ///< in the last iterations
};

Gram gram(const Matrix6& m) {
  Gram g;
  for (int r = 0; r < load_cases; ++r)
    for (int c = 0; c < load_cases; ++c)
      g.row[r][c] = m(r, c);
  return g;
}

Matrix6 sum(const std::vector<Gram>& parts) {
  Gram whole;
  for (const Gram& part : parts)
    for (int r = 0; r < load_cases; ++r)
      whole.row[r] += part.row[r];
  Matrix6 m;
  for (int r = 0; r < load_cases; ++r)
    for (int c = 0; c < load_cases; ++c)
      m(r, c) = whole.row[r][c];
  return m;
}

GRANUM_INLINE void add_products(const Lanes& x, const Lanes& y, Lanes* total) {
  for (int c = 0; c < load_cases; ++c)
    total[c] += x[c] * y;
}

/// value += x m
GRANUM_INLINE void add_combination(const Lanes& x, const Gram& m, Lanes& value) {
  for (int c = 0; c < load_cases; ++c)
    value += x[c] * m.row[c];
}

template <int Dof>
GRANUM_INLINE void products_of(std::size_t n, const Rows<Dof>* x, const Rows<Dof>* y, Gram* out) {
  Lanes total[load_cases] = {};
  for (std::size_t g = 0; g < n; ++g)
    for (int d = 0; d < Dof; ++d)
      add_products(x[g].row[d], y[g].row[d], total);
  for (int c = 0; c < load_cases; ++c)
    out->row[c] = total[c];
}

template <int Dof>
GRANUM_INLINE void advance_rows(std::size_t n, const Rows<Dof>* p, const Gram* a, Rows<Dof>* q,
                                const Rows<Dof>* s, const Gram* b, Rows<Dof>* w, Gram* out) {
  Lanes total[load_cases] = {};
  for (std::size_t g = 0; g < n; ++g)
    for (int d = 0; d < Dof; ++d) {
      add_combination(p[g].row[d], *a, q[g].row[d]);
      add_combination(s[g].row[d], *b, w[g].row[d]);
      add_products(w[g].row[d], w[g].row[d], total);
    }
  for (int c = 0; c < load_cases; ++c)
    out->row[c] = total[c];
}

template <int Dof>
GRANUM_INLINE void turn_rows(std::size_t n, const Gram* t, Rows<Dof>* w, const Rows<Dof>* z, const Gram* c,
                             Rows<Dof>* p) {
  for (std::size_t g = 0; g < n; ++g)
    for (int d = 0; d < Dof; ++d) {
      Lanes residual = {}, direction = {};
      add_combination(w[g].row[d], *t, residual);
      add_combination(z[g].row[d], *t, direction);
      add_combination(p[g].row[d], *c, direction);
      w[g].row[d] = residual;
      p[g].row[d] = direction;
    }
}

} // namespace

template <int Dof>
Solution relax(const Backbone& backbone, const Preconditioner<Dof>& preconditioner,
               const ResponseOptions& options, const Workers& workers) {
  return Relaxation<Dof>(backbone, preconditioner, options, workers).run();
}

template Solution relax<3>(const Backbone&, const Preconditioner<3>&, const ResponseOptions&, const Workers&);
template Solution relax<6>(const Backbone&, const Preconditioner<6>&, const ResponseOptions&, const Workers&);

template <int Dof>
Matrix6 products(const Workers& workers, const Field<Dof>& x, const Field<Dof>& y) {
  std::vector<Gram> parts(Workers::block_count(x.size()));
  workers.blocks(x.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      products_of<Dof>(last - first, &x[first], &y[first], &parts[block]);
    });
  });
  return sum(parts);
}

template <int Dof>
Matrix6 advance(const Workers& workers, const Field<Dof>& p, const Matrix6& a, Field<Dof>& q,
                const Field<Dof>& s, const Matrix6& b, Field<Dof>& w) {
  const Gram along = gram(a), back = gram(b);
  std::vector<Gram> parts(Workers::block_count(p.size()));
  workers.blocks(p.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      advance_rows<Dof>(last - first, &p[first], &along, &q[first], &s[first], &back, &w[first],
                        &parts[block]);
    });
  });
  return sum(parts);
}

template <int Dof>
void turn(const Workers& workers, const Matrix6& t, Field<Dof>& w, const Field<Dof>& z, const Matrix6& c,
          Field<Dof>& p) {
  const Gram fresh = gram(t), kept = gram(c);
  workers.blocks(w.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    at_vector_level([&](auto) __attribute__((always_inline)) {
      turn_rows<Dof>(last - first, &fresh, &w[first], &z[first], &kept, &p[first]);
    });
  });
}

template Matrix6 products<3>(const Workers&, const Field<3>&, const Field<3>&);
template Matrix6 products<6>(const Workers&, const Field<6>&, const Field<6>&);
template Matrix6 advance<3>(const Workers&, const Field<3>&, const Matrix6&, Field<3>&, const Field<3>&,
                            const Matrix6&, Field<3>&);
template Matrix6 advance<6>(const Workers&, const Field<6>&, const Matrix6&, Field<6>&, const Field<6>&,
                            const Matrix6&, Field<6>&);
template void turn<3>(const Workers&, const Matrix6&, Field<3>&, const Field<3>&, const Matrix6&, Field<3>&);
template void turn<6>(const Workers&, const Matrix6&, Field<6>&, const Field<6>&, const Matrix6&, Field<6>&);

} // namespace granum::network
