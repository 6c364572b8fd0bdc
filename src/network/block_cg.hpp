// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include "backbone.hpp"
#include "contact_operator.hpp"
#include "lanes.hpp"
#include "preconditioner.hpp"
#include "workers.hpp"

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
