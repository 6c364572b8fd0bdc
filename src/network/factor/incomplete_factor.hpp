// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include <granum/network/linear_response.hpp>
#include <granum/packing/assembly.hpp>

#include "elimination.hpp"
#include "network/backbone.hpp"
#include "network/lanes.hpp"

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

/// Incomplete factor of a rule with uses_motions, made after a numbering that loses few pivots. Dropped terms
/// falsify the stiffness of soft motions, and their pivots spoil later ones. A factor with little fill finds
/// the grains of very soft motions; numbered first, as weakly supported ones, their elimination drops
/// nothing. Then the grains of pivots that the factor itself loses are numbered first as well, a few times.
/// If it still loses many, the rule is changed to SoftPivots::coupled.
/// \param    options    a stop request ends the search; the last factor is returned
/// \param    backbone   of the assembly and the options; numbered anew
template <int Dof>
[[nodiscard]] IncompleteFactor<Dof> factor_with_soft_first(const packing::Assembly& assembly,
                                                           const ResponseOptions& options, FactorRule rule,
                                                           const Workers& workers, Backbone& backbone);

} // namespace granum::network
