// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network. Storage of the six load cases side by side, so that one pass over the contacts
// serves all; and the threads that share a pass.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <granum/core/stop.hpp>

#include "core/team.hpp"
#include "core/vector/level.hpp"

namespace granum::network {

inline constexpr int load_cases = 6;

/// One number of every load case; lanes 6 and 7 stay zero.
using Lanes = Eight;

/// One number of every load case, outside of passes over grains.
using PerCase = std::array<double, std::size_t{load_cases}>;

/// Degrees of freedom of one grain (rows) for every load case (lanes).
template <int Dof>
struct alignas(64) Rows {
  Lanes row[std::size_t{Dof}] = {};
};

/// A vector over all grains, for every load case.
template <int Dof>
using Field = std::vector<Rows<Dof>>;

/// Coupling of two grains, or of one with itself.
template <int Dof, class Number = double>
struct Block {
  Number at[std::size_t{Dof}][std::size_t{Dof}] = {};
};

template <int Dof>
void add(const Block<Dof>& from, Block<Dof>& to) {
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      to.at[r][c] += from.at[r][c];
}

/// 6 x 6 products of two fields.
struct alignas(64) Gram {
  Lanes row[load_cases] = {};
};

/// The threads of one solution. The division of work does not depend on their number, and parts that run at
/// the same time write to different data: the same bits for any number of threads.
class Workers {
 public:
  /// \param    team   null: only the calling thread
  explicit Workers(Team* team = nullptr) : team_(team) {}

  /// part(k) for every k below `count`, in any order. Stop points in them count on one thread only.
  template <class Part>
  void each(std::size_t count, const Part& part) const {
    if (team_ == nullptr || count < 2) {
      for (std::size_t k = 0; k < count; ++k)
        part(k);
      return;
    }
    const StopScope none({}); // jobs of a team must not throw
    team_->run([&](std::size_t member) {
      for (std::size_t k = member; k < count; k += team_->size())
        part(k);
    });
  }

  /// part(block, first, last) for blocks of rows, the last one shorter.
  template <class Part>
  void blocks(std::size_t rows, const Part& part) const {
    each(block_count(rows), [&](std::size_t block) {
      part(block, block * block_rows, std::min(rows, (block + 1) * block_rows));
    });
  }
  [[nodiscard]] static std::size_t block_count(std::size_t rows) {
    return (rows + block_rows - 1) / block_rows;
  }

 private:
  static constexpr std::size_t block_rows = 1024;
  Team* team_;
};

} // namespace granum::network
