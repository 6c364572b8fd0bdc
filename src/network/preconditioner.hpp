// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <optional>
#include <utility>

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

} // namespace granum::network
