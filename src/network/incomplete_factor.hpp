// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Eigenvalues>

#include "backbone.hpp"
#include "factor_rule.hpp"
#include "fill_pattern.hpp"
#include "lanes.hpp"
#include "local_motion.hpp"
#include "workers.hpp"

namespace granum::network {

/// Incomplete block factorisation H ~ L D L^T with some fill: the preconditioner of all six load cases.
/// Blocks are those of whole grains; what becomes of soft pivots, the rule says. Free spins get a tiny part
/// of the mean diagonal. L is kept in single precision, but in double for floppy networks, whose pivots are
/// stiffened: there rounding drives modes without stiffness.
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
  using PivotSystem = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Dof, Dof>>;
  using Vector = Eigen::Matrix<double, Dof, 1>;
  template <class Number>
  void factorise(Lower<Number>& lower);
  template <class Number>
  void factorise(Piece piece, double mean, Work& work, Lower<Number>& lower);
  template <class Number>
  [[nodiscard]] bool invert_pivot(std::uint32_t i, double mean, Work& work, const Lower<Number>& lower);
  static void hold(std::uint32_t i, const PivotSystem& pivot, int k, Held& held, Vector& inverses);
  template <class Number>
  [[nodiscard]] Vector judged_values(std::uint32_t i, const PivotSystem& pivot, double mean, Work& work,
                                     const Lower<Number>& lower) const;
  template <class Number>
  [[nodiscard]] PerCase motion_energy(std::uint32_t i, const Rows<Dof>& directions, double negligible,
                                      Work& work, const Lower<Number>& lower) const;
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
  std::optional<LinksOfGrains> links_;              ///< where pivots are judged
  FillPattern pattern_;                             ///< of the strictly lower blocks
  std::variant<Lower<float>, Lower<double>> lower_; ///< transposed: block (i, j) is stored as L_ij^T
  std::vector<Block<Dof>> inverse_pivot_;
  std::size_t mended_pivots_ = 0;
};

} // namespace granum::network
