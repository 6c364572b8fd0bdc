// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "backbone.hpp"
#include "factor_rule.hpp"
#include "fill_pattern.hpp"
#include "lanes.hpp"
#include "workers.hpp"

namespace granum::network {

/// Incomplete block factorisation H ~ L D L^T with some fill: the preconditioner of all six load cases.
/// Blocks are those of whole grains; a tiny part of the mean diagonal is added, so that free spins (singular
/// pivots) do no harm. A direction d in which a pivot is not safely positive is held while the others are
/// eliminated, and gets the stiffness v^T H v of the motion v = L^-T d afterwards. Where the rule says so, as
/// floppy networks have many such directions that bear little, it gets a small stiffness at once; then L is
/// kept in double precision, for rounding drives modes without stiffness, else in single.
template <int Dof>
class IncompleteFactor {
 public:
  IncompleteFactor(const Backbone& backbone, const Workers& workers, const FactorRule& rule);

  /// z = (L D L^T)^-1 r
  void solve(const Field<Dof>& r, Field<Dof>& z) const;

  [[nodiscard]] std::size_t mended_pivots() const { return mended_pivots_; }
  [[nodiscard]] std::size_t nonzeros() const { return (pattern_.size() + inverse_pivot_.size()) * Dof * Dof; }

 private:
  struct Work;
  /// Of a pivot that was not safely positive.
  struct HeldDirection {
    std::uint32_t row = 0;
    std::array<double, std::size_t{Dof}> direction{};
  };
  using Held = std::vector<HeldDirection>;
  void begin_row(std::uint32_t i, Work& work) const;
  template <class Number>
  using Lower = std::vector<Block<Dof, Number>>;
  template <class Number>
  void factorise(Lower<Number>& lower);
  template <class Number>
  void factorise(Piece piece, double mean, Work& work, Lower<Number>& lower);
  [[nodiscard]] bool invert_pivot(std::uint32_t i, double mean, Held& held);
  template <class Number>
  void release(const Held& held, double mean, const Lower<Number>& lower);
  template <class Number>
  void eliminate(std::uint32_t i, Work& work, Lower<Number>& lower, Block<Dof>& pivot);
  template <class Number>
  void solve(const Lower<Number>& lower, const Field<Dof>& r, Field<Dof>& z) const;
  template <class Number>
  void solve_upper(const Lower<Number>& lower, Field<Dof>& z) const;

  const Backbone& backbone_;
  const Workers& workers_;
  FactorRule rule_;
  FillPattern pattern_;                             ///< of the strictly lower blocks
  std::variant<Lower<float>, Lower<double>> lower_; ///< transposed: block (i, j) is stored as L_ij^T
  std::vector<Block<Dof>> inverse_pivot_;
  std::size_t mended_pivots_ = 0;
};

} // namespace granum::network
