// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network. Sums and products of fields, in blocks of rows whose results are added in order.
#pragma once

#include <granum/elastic/stiffness.hpp>

#include "lanes.hpp"
#include "workers.hpp"

namespace granum::network {

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
