// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "studies/running/run_control.hpp"

namespace granum::cli {

/// Wall time since then [s].
[[nodiscard]] double seconds_since(std::chrono::steady_clock::time_point start);

/// One line on the terminal, overwritten in place; silent elsewhere.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows the fraction done, the remaining time at the mean speed so far, and the last finished part.
  void show(const studies::Progress& progress);
  void clear();

 private:
  bool shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace granum::cli
