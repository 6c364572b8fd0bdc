// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <granum/elastic/stiffness.hpp>

#include "core/vector/level.hpp"
#include "network/backbone.hpp"
#include "network/lanes.hpp"

namespace granum::network {

[[nodiscard]] elastic::Matrix6 dense(const Block<6>& b);

/// Complete factorisation A = L D L^T of a sparse, symmetric, positive semidefinite matrix of 6 x 6 blocks.
/// Directions without stiffness are left out: D^+ in place of D^-1.
class CoarseFactor {
 public:
  using Coupling = std::pair<std::uint32_t, std::uint32_t>;

  /// A = 0, with storage for the diagonal and these off-diagonal blocks.
  /// \param    couplings   in any order, may repeat
  CoarseFactor(std::size_t size, const std::vector<Coupling>& couplings);

  /// Adds to a block of A and to its transpose.
  void add(std::uint32_t row, std::uint32_t column, const elastic::Matrix6& block);
  /// Call once, after all blocks have been added.
  void factorise(const Workers& workers);

  /// x = (L D L^T)^+ x
  void solve(Field<6>& x) const;
  [[nodiscard]] std::size_t nonzeros() const { return (lower_.size() + inverse_pivot_.size()) * 36; }

 private:
  /// A finished column, and its first entry that has not been used yet.
  struct Reaching {
    std::uint32_t column, entry;
  };
  void subtract_columns(std::uint32_t j, const std::vector<Reaching>& columns, const Workers& workers,
                        std::vector<Rows<6>>& work) const;
  void find_order(std::size_t size, const std::vector<Coupling>& couplings);
  void find_pattern(std::size_t size, const std::vector<Coupling>& couplings);

  std::vector<std::uint32_t> place_;        ///< of each row in the order of elimination
  std::vector<std::uint32_t> column_start_; ///< of the strictly lower blocks, by columns
  std::vector<std::uint32_t> row_;
  std::vector<Block<6>> lower_;
  std::vector<Block<6>> inverse_pivot_;
};

/// Equal boxes that fill the cell, each with its grains and a node at each of its eight corners, as many
/// nodes as boxes because the cell is periodic. Along an axis with one box only, both corners are the same
/// node.
class CoarseGrid {
 public:
  using Corners =
      std::array<std::uint32_t, 8>; ///< corner c is at the far end of axis k where bit k of c is set
  using Shares = std::array<double, 8>;

  /// \param    grains_a_box   on average, about
  CoarseGrid(const Backbone& backbone, double grains_a_box);

  /// Boxes, and nodes.
  [[nodiscard]] std::size_t size() const { return grains_start_.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> grains_of(std::size_t box) const {
    return std::span(grains_).subspan(grains_start_[box], grains_start_[box + 1] - grains_start_[box]);
  }
  [[nodiscard]] std::uint32_t box_of(std::size_t grain) const { return box_[grain]; }
  [[nodiscard]] Corners nodes_of(std::size_t box) const { return neighbours(box, 1); }
  /// The boxes that have a node as their corner 0, 1, ...
  [[nodiscard]] Corners boxes_around(std::size_t node) const { return neighbours(node, -1); }
  /// Weights of the corners of its box for a grain: linear along each edge, with the sum 1.
  [[nodiscard]] GRANUM_INLINE Shares shares_of(std::size_t grain) const {
    const Vec3& far = part_[grain];
    const Vec3 near{1 - far.x, 1 - far.y, 1 - far.z};
    Shares share;
    for (unsigned c = 0; c < share.size(); ++c)
      share[c] = ((c & 1U) != 0 ? far.x : near.x) * ((c & 2U) != 0 ? far.y : near.y) *
                 ((c & 4U) != 0 ? far.z : near.z);
    return share;
  }

 private:
  [[nodiscard]] Corners neighbours(std::size_t number, int direction) const;

  std::array<std::size_t, 3> along_{}; ///< boxes
  std::vector<Vec3> part_;             ///< position of each grain in its box, components in [0, 1]
  std::vector<std::uint32_t> box_;     ///< of each grain
  std::vector<std::uint32_t> grains_;  ///< box after box
  std::vector<std::uint32_t> grains_start_;
};

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
