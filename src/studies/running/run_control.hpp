// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace granum::studies {

/// How far a study is.
struct Progress {
  double done = 0; ///< share of the predicted work, 0..1
  std::string what;
  double done_before = 0; ///< fraction of the work in checkpoints of an earlier run
};

struct RunControl {
  std::function<void(const Progress&)> report = {}; ///< called from worker threads, one at a time
  const std::atomic<bool>* stop = nullptr; ///< set it to end the study early; finished results are kept
};

} // namespace granum::studies
