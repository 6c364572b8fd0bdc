// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/vector/level.hpp"

namespace granum::test {

/// Sets a vector level, and at its end the one that stood before.
class LevelSet {
 public:
  explicit LevelSet(VectorLevel level) : before_(vector_level()) { set_vector_level(level); }
  ~LevelSet() { set_vector_level(before_); }
  LevelSet(const LevelSet&) = delete;
  LevelSet& operator=(const LevelSet&) = delete;

 private:
  VectorLevel before_;
};

/// The levels beyond the baseline that this build has code for and this machine runs.
inline std::vector<VectorLevel> levels_beyond_baseline() {
  std::vector<VectorLevel> levels;
  for (const VectorLevel level : {VectorLevel::avx2, VectorLevel::avx512})
    if (runs_here(level))
      levels.push_back(level);
  return levels;
}

} // namespace granum::test
