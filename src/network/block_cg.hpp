// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include "backbone.hpp"
#include "force_energies.hpp"
#include "lanes.hpp"
#include "preconditioner.hpp"

namespace granum::network {

struct Solution {
  Status status = Status::converged;
  int iterations = 0;
  double residual = 0;                              ///< worst load case, relative to its right-hand side
  elastic::Matrix6 work = elastic::Matrix6::Zero(); ///< W^T q, the (negative) energy of relaxation
  ForceEnergies by_forces;                          ///< of the motions q, if the backbone has loaded contacts
};

/// Solves H q = -W for all load cases at once, in one shared Krylov space.
template <int Dof>
[[nodiscard]] Solution relax(const Backbone& backbone, const Preconditioner<Dof>& preconditioner,
                             const ResponseOptions& options, const Workers& workers);

} // namespace granum::network
