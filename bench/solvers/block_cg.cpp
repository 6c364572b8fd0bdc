// SPDX-License-Identifier: GPL-3.0-or-later
// Notation as in src/network/block_cg.cpp: residual r = w sigma with w^T z = 1, z = M^-1 w; directions p,
// s = H p, zeta = (p^T s)^-1.
#include "block_cg.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <granum/elastic/stiffness.hpp>

#include "network/block_cg.hpp"
#include "network/contact_operator.hpp"

namespace granum::bench {

namespace {

using elastic::Matrix6;
using network::Workers;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// As in src/network/block_cg.cpp.
constexpr double dependent = 1e-13;
constexpr double indefinite = 1e-8;
constexpr int restarts = 5;

/// T with T^T m T = 1 on the independent directions; nothing where m is not positive semidefinite.
std::optional<Matrix6> whitening(const Matrix6& m) {
  const Vector6 diagonal = m.diagonal();
  if (!(diagonal.minCoeff() >= 0))
    return {};
  const Vector6 scale = diagonal.unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.0; });
  const elastic::EigenSystem eigen =
      elastic::eigen_system(Matrix6(scale.asDiagonal() * ((m + m.transpose()) / 2) * scale.asDiagonal()));
  const double largest = eigen.values[5];
  if (eigen.values[0] < -indefinite * largest)
    return {};
  const Vector6 inverse_root =
      eigen.values.unaryExpr([&](double v) { return v > dependent * largest ? 1 / std::sqrt(v) : 0.0; });
  return Matrix6(scale.asDiagonal() * eigen.vectors * inverse_root.asDiagonal());
}

Vector6 sizes(const Matrix6& squares) { return squares.diagonal().cwiseMax(0).cwiseSqrt(); }

/// w = -load - H q
Motions true_residual(const network::Backbone& backbone, const Motions& load, const Motions& q) {
  Motions w;
  network::apply_stiffness<6>(backbone, Workers(), 0, q, w);
  for (std::size_t g = 0; g < w.size(); ++g)
    for (std::size_t d = 0; d < 6; ++d)
      w[g].row[d] = -load[g].row[d] - w[g].row[d];
  return w;
}

} // namespace

double residual_of(const network::Backbone& backbone, const Motions& load, const Motions& q) {
  const Workers alone;
  const Motions w = true_residual(backbone, load, q);
  return sizes(network::products<6>(alone, w, w))
      .cwiseQuotient(sizes(network::products<6>(alone, load, load)))
      .maxCoeff();
}

Solved block_cg(const network::Backbone& backbone, const Motions& load, const Preconditioner& precondition,
                double tolerance, int iteration_limit) {
  const Workers alone;
  const Vector6 goal = tolerance * sizes(network::products<6>(alone, load, load));
  Solved solved{.motions = Motions(load.size())};
  Motions w, p(load.size()), s(load.size());
  const auto turn_directions = [&]() -> std::optional<Matrix6> {
    precondition(w, s);
    const Matrix6 metric = network::products<6>(alone, w, s);
    const std::optional<Matrix6> t = whitening(metric);
    if (!t)
      return {};
    const Matrix6 tau = t->transpose() * metric;
    network::turn<6>(alone, *t, w, s, tau.transpose(), p);
    return tau;
  };
  for (int start = 0; start < restarts; ++start) {
    w = true_residual(backbone, load, solved.motions);
    if ((sizes(network::products<6>(alone, w, w)).array() <= goal.array()).all())
      break;
    p.assign(p.size(), {});
    std::optional<Matrix6> sigma = turn_directions();
    while (sigma && solved.iterations < iteration_limit) {
      ++solved.iterations;
      network::apply_stiffness<6>(backbone, alone, 0, p, s);
      const std::optional<Matrix6> energy = whitening(network::products<6>(alone, p, s));
      if (!energy)
        break;
      const Matrix6 zeta = *energy * energy->transpose();
      const Matrix6 squares = network::advance<6>(alone, p, zeta * *sigma, solved.motions, s, -zeta, w);
      if ((sizes(sigma->transpose() * squares * *sigma).array() <= goal.array()).all())
        break;
      const std::optional<Matrix6> tau = turn_directions();
      sigma = tau ? std::optional<Matrix6>(*tau * *sigma) : std::nullopt;
    }
  }
  solved.residual = residual_of(backbone, load, solved.motions);
  return solved;
}

} // namespace granum::bench
