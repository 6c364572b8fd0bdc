// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <vector>

#include "backbone.hpp"
#include "lanes.hpp"
#include "workers.hpp"

namespace granum::network {

/// Incomplete block factorisation H ~ L D L^T with one level of fill: the preconditioner of all six load
/// cases. Blocks are those of whole grains; a tiny part of the mean diagonal is added, so that free spins
/// (singular pivots) do no harm, and pivots that are not safely positive are made so, one by one.
template <int Dof>
class IncompleteFactor {
 public:
  IncompleteFactor(const Backbone& backbone, const Workers& workers);

  /// z = (L D L^T)^-1 r
  void solve(const Field<Dof>& r, Field<Dof>& z) const;

  [[nodiscard]] std::size_t mended_pivots() const { return mended_pivots_; }
  [[nodiscard]] std::size_t nonzeros() const { return (lower_.size() + inverse_pivot_.size()) * Dof * Dof; }

 private:
  void find_pattern(const Backbone& backbone);
  void assemble(const Backbone& backbone);
  void factorise();
  struct Work;
  [[nodiscard]] std::size_t factorise(Piece piece, double mean, Work& work);

  const std::vector<std::vector<Piece>>& stages_;
  const Workers& workers_;
  std::vector<std::uint32_t> row_start_; ///< of the strictly lower blocks, by rows
  std::vector<std::uint32_t> column_;
  std::vector<Block<Dof>> lower_; ///< transposed: block (i, j) is stored as L_ij^T
  std::vector<Block<Dof>> inverse_pivot_;
  std::size_t mended_pivots_ = 0;
};

} // namespace granum::network
