// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <algorithm>
#include <cstddef>

#include <granum/core/stop.hpp>

#include "core/team.hpp"

namespace granum::network {

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
