// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "methods.hpp"

namespace granum::bench {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// Iterations of one load case.
constexpr int patience = 5000;

/// The same matrix by columns: it is symmetric.
Eigen::Map<const Sparse> view(const Matrix& m) {
  return {m.rows(),           m.rows(),        static_cast<Eigen::Index>(m.value.size()),
          m.row_start.data(), m.column.data(), m.value.data()};
}

template <class Ordering>
Preconditioner incomplete(const network::Backbone&, Matrix&& matrix) {
  const int rows = matrix.rows();
  const auto factor = std::make_shared<Eigen::IncompleteCholesky<double, Eigen::Lower, Ordering>>();
  {
    const Matrix given = std::move(matrix);
    factor->compute(Sparse(view(given)));
  }
  return case_by_case(rows, [factor](const std::vector<double>& r, std::vector<double>& z) {
    const auto size = static_cast<Eigen::Index>(r.size());
    Eigen::Map<Vector>(z.data(), size) = factor->solve(Eigen::Map<const Vector>(r.data(), size));
  });
}

using Cg = Eigen::ConjugateGradient<Sparse, Eigen::Lower | Eigen::Upper,
                                    Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<int>>>;

/// Eigen's own conjugate gradients, load case by load case.
std::function<Solved(const Motions&, double)> one_by_one(const network::Backbone& backbone, Matrix&& matrix) {
  struct State {
    Sparse h;
    Cg cg;
  };
  const auto state = std::make_shared<State>();
  {
    const Matrix given = std::move(matrix);
    state->h = view(given);
  }
  state->cg.compute(state->h);
  return [state, &backbone](const Motions& load, double tolerance) {
    Solved solved{.motions = Motions(load.size())};
    state->cg.setTolerance(tolerance);
    state->cg.setMaxIterations(patience);
    Vector right(state->h.rows());
    for (int c = 0; c < network::load_cases; ++c) {
      take_case(load, c, right.data());
      const Vector x = state->cg.solve(-right);
      put_case(x.data(), c, solved.motions);
      solved.iterations += static_cast<int>(state->cg.iterations());
    }
    solved.residual = residual_of(backbone, load, solved.motions);
    return solved;
  };
}

} // namespace

std::vector<Method> eigen_methods() {
  return {{.name = "eigen-ic", .make = incomplete<Eigen::AMDOrdering<int>>},
          {.name = "eigen-ic-natural", .make = incomplete<Eigen::NaturalOrdering<int>>},
          {.name = "eigen-cg", .shift = 0, .make = {}, .make_solver = one_by_one}};
}

} // namespace granum::bench
