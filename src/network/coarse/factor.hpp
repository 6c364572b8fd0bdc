// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <granum/elastic/stiffness.hpp>

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

} // namespace granum::network
