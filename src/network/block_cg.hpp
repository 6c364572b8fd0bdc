// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <optional>
#include <utility>

#include "backbone.hpp"
#include "contact_operator.hpp"
#include "lanes.hpp"
#include "network/coarse/correction.hpp"
#include "network/factor/incomplete_factor.hpp"

namespace granum::network {

/// M^-1 of the conjugate gradients: an incomplete factor for short waves, motions of the nodes of a coarse
/// grid for long ones. It is symmetric and positive definite for residuals that do no work on the motions of
/// the nodes.
template <int Dof>
class Preconditioner {
 public:
  Preconditioner(const Backbone& backbone, const Workers& workers, IncompleteFactor<Dof> factor)
      : factor_(std::move(factor)) {
    if (CoarseCorrection<Dof>::pays(backbone))
      coarse_.emplace(backbone, workers);
  }

  /// z = M^-1 r
  void solve(const Field<Dof>& r, Field<Dof>& z) const {
    factor_.solve(r, z);
    if (coarse_)
      coarse_->correct(r, z);
  }

  /// Changes q such that its residual does no work on the motions of the nodes.
  void lift_coarse_residual(const Field<Dof>& r, Field<Dof>& q) const {
    if (coarse_)
      coarse_->add_lifted(r, q);
  }

  [[nodiscard]] const IncompleteFactor<Dof>& factor() const { return factor_; }
  [[nodiscard]] std::size_t nonzeros() const {
    return factor_.nonzeros() + (coarse_ ? coarse_->nonzeros() : 0);
  }

 private:
  IncompleteFactor<Dof> factor_;
  std::optional<CoarseCorrection<Dof>> coarse_;
};

struct Solution {
  Status status = Status::converged;
  int iterations = 0;
  double residual = 0;                              ///< worst load case, relative to its right-hand side
  elastic::Matrix6 work = elastic::Matrix6::Zero(); ///< W^T q, the (negative) energy of relaxation
  ForceEnergies by_forces;                          ///< of the motions q, if the backbone has loaded contacts
  StrainMotions motions; ///< q in the order and units of the backbone, if options.motions
};

/// Solves H q = -W for all load cases at once, in one shared Krylov space.
template <int Dof>
[[nodiscard]] Solution relax(const Backbone& backbone, const Preconditioner<Dof>& preconditioner,
                             const ResponseOptions& options, const Workers& workers);

// Sums and products of fields, in blocks of rows whose results are added in order.

/// x^T y
template <int Dof>
[[nodiscard]] elastic::Matrix6 products(const Workers& workers, const Field<Dof>& x, const Field<Dof>& y);

/// One step along p with H p = s: q += p a, w += s b. Returns w^T w.
template <int Dof>
[[nodiscard]] elastic::Matrix6 advance(const Workers& workers, const Field<Dof>& p, const elastic::Matrix6& a,
                                       Field<Dof>& q, const Field<Dof>& s, const elastic::Matrix6& b,
                                       Field<Dof>& w);

/// New directions: w = w t, p = z t + p c.
template <int Dof>
void turn(const Workers& workers, const elastic::Matrix6& t, Field<Dof>& w, const Field<Dof>& z,
          const elastic::Matrix6& c, Field<Dof>& p);

} // namespace granum::network
