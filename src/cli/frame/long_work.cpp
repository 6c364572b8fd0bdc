// SPDX-License-Identifier: GPL-3.0-or-later
#include "long_work.hpp"

#include <csignal>
#include <ctime>

#include <fmt/core.h>
#include <unistd.h>

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

namespace {

std::atomic<bool> stop_requested = false;
std::atomic<int> signal_number = SIGINT;
std::atomic<std::time_t> first_signal = 0;

extern "C" void granum_stop(int number) {
  const std::time_t now = std::time(nullptr);
  if (!stop_requested) {
    signal_number = number;
    stop_requested = true;
    first_signal = now;
  } else if (now - first_signal >= 2) {
    _exit(128 + signal_number);
  }
}

} // namespace

const std::atomic<bool>& listen_for_stop() {
  struct sigaction action = {};
  action.sa_handler = granum_stop;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction of_nohup = {};
  if (sigaction(SIGHUP, nullptr, &of_nohup) == 0 && of_nohup.sa_handler != SIG_IGN)
    sigaction(SIGHUP, &action, nullptr);
  return stop_requested;
}

ExitCode exit_code_of_stop() { return static_cast<ExitCode>(128 + signal_number); }

} // namespace granum::cli
