// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include "factor.hpp"
#include "grid.hpp"
#include "network/backbone.hpp"
#include "network/lanes.hpp"
#include "network/workers.hpp"

namespace granum::network {

/// Coarse space: motions P of the nodes of a grid, a shift and a rotation each, interpolated linearly to the
/// grains, with the stiffness P^T H P. It removes long waves from a residual [Nicolaides1987], for which the
/// iterations with the incomplete factor alone grow with the network.
template <int Dof>
class CoarseCorrection {
 public:
  /// \param    grains_a_node   about
  CoarseCorrection(const Backbone& backbone, const Workers& workers,
                   double grains_a_node = default_grains_a_node);

  /// Whether the network is large enough to gain time.
  [[nodiscard]] static bool pays(const Backbone& backbone);

  /// z += P (P^T H P)^+ P^T (r - H z). Not from two threads at once.
  void correct(const Field<Dof>& r, Field<Dof>& z) const;
  /// q += P (P^T H P)^+ P^T r
  void add_lifted(const Field<Dof>& r, Field<Dof>& q) const;

  /// Numbers in the factor of P^T H P.
  [[nodiscard]] std::size_t nonzeros() const { return factor_.nonzeros(); }

 private:
  static constexpr double default_grains_a_node = 200;

  template <class Force>
  void add_coarse_motion(const Force& force, Field<Dof>& u) const;

  const Backbone& backbone_;
  const Workers& workers_;
  CoarseGrid grid_;
  CoarseFactor factor_;
  mutable Field<Dof> force_; ///< H z
};

} // namespace granum::network
