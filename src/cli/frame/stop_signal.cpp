// SPDX-License-Identifier: GPL-3.0-or-later
#include "stop_signal.hpp"

#include <csignal>
#include <ctime>

#include <unistd.h>

namespace granum::cli {

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
