// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <unistd.h>

#include <fmt/core.h>

#include "messages.hpp"

namespace granum::cli {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

ProgressLine::ProgressLine(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

void ProgressLine::show(const studies::Progress& progress) {
  if (!shown_)
    return;
  const double elapsed = seconds_since(start_);
  const double own = progress.done - progress.done_before;
  const double left = own > 0 ? elapsed * (1 - progress.done) / own : 0;
  to_standard_error(fmt::format("\r\033[K  {:3.0f} %  about {:.0f} s left  ({})", 100 * progress.done, left,
                                progress.what));
}

void ProgressLine::clear() {
  if (shown_)
    to_standard_error("\r\033[K");
}

} // namespace granum::cli
