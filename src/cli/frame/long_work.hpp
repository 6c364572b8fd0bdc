// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>

#include "frame.hpp"
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

/// From now on the first stop signal ends long work in an orderly way: Ctrl-C (SIGINT), SIGTERM, or the
/// SIGHUP of a closed terminal, unless ignored by nohup(1). A further signal two seconds later ends the
/// program immediately, with the same exit code; the delay exists because some callers, such as timeout(1),
/// send each signal more than once. Call it before the folder of results is created: to callers, the folder
/// shows that signals are handled.
/// \return   true if the work is to end
const std::atomic<bool>& listen_for_stop();

/// The exit code of stopped work: 129 after SIGHUP, 130 after SIGINT, 143 after SIGTERM.
[[nodiscard]] ExitCode exit_code_of_stop();

} // namespace granum::cli
