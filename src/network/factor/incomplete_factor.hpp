// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "elimination.hpp"
#include "factor_rule.hpp"
#include "fill_pattern.hpp"
#include "network/backbone.hpp"
#include "network/lanes.hpp"
#include "network/workers.hpp"

namespace granum::network {

/// Incomplete block factorisation with some fill, R^T H R ~ L L^T (symbols: elimination.cpp): the
/// preconditioner of all six load cases. One block is one grain. L is in single precision; for floppy
/// networks (SoftPivots::stiffened) in double, because there rounding drives modes without stiffness.
template <int Dof>
class IncompleteFactor {
 public:
  IncompleteFactor(const Backbone& backbone, const Workers& workers, const FactorRule& rule);

  /// z = R (L L^T)^-1 R^T r
  void solve(const Field<Dof>& r, Field<Dof>& z) const;

  [[nodiscard]] std::size_t mended_pivots() const { return mended_pivots_; }
  /// As in Eliminated.
  [[nodiscard]] const std::vector<std::uint32_t>& lost_grains() const { return lost_grains_; }
  [[nodiscard]] std::size_t nonzeros() const { return (pattern_.size() + root_.size()) * Dof * Dof; }

 private:
  template <class Number>
  using Lower = std::vector<std::vector<Block<Dof, Number>>>;
  void round(Lower<double>& lower);
  template <class Body>
  void for_piece(std::size_t piece_number, Piece piece, const Body& body) const;

  const Backbone& backbone_;
  const Workers& workers_;
  FillPattern pattern_;                             ///< of the strictly lower blocks
  std::variant<Lower<float>, Lower<double>> lower_; ///< as in Eliminated
  std::vector<Block<Dof>> root_;                    ///< as in Eliminated
  std::size_t mended_pivots_ = 0;
  std::vector<std::uint32_t> lost_grains_;
};

} // namespace granum::network
