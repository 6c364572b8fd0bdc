// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <vector>

#include "backbone.hpp"
#include "lanes.hpp"

namespace granum::network {

/// Incomplete block factorisation H ~ L D L^T with one level of fill: the preconditioner of all six load
/// cases. Blocks are those of whole grains; a small multiple of the mean diagonal is added, so that free
/// spins (singular pivots) do no harm, and is raised until every pivot is safely positive.
template <int Dof>
class IncompleteFactor {
 public:
  explicit IncompleteFactor(const Backbone& backbone);

  /// z = (L D L^T)^-1 r
  void solve(const Field<Dof>& r, Field<Dof>& z) const;

  [[nodiscard]] double shift() const { return shift_; }
  [[nodiscard]] std::size_t nonzeros() const { return (lower_.size() + inverse_pivot_.size()) * Dof * Dof; }

 private:
  void find_pattern(const Backbone& backbone);
  void assemble(const Backbone& backbone);
  [[nodiscard]] bool factorise();

  std::vector<std::uint32_t> row_start_; ///< of the strictly lower blocks, by rows
  std::vector<std::uint32_t> column_;
  std::vector<Block<Dof>> lower_; ///< transposed: block (i, j) is stored as L_ij^T
  std::vector<Block<Dof>> inverse_pivot_;
  double shift_ = 0;
};

} // namespace granum::network
