// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>

namespace granum::bench {

/// A line of /proc/self/status in bytes: VmRSS is held now, VmHWM the most since the last reset.
inline double memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name + ":"))
      return 1024 * std::stod(line.substr(name.size() + 1));
  throw std::runtime_error("no " + name + " in /proc/self/status");
}

/// What a call takes.
class Meter {
 public:
  Meter() {
    std::ofstream("/proc/self/clear_refs") << "5\n"; // forgets the most that was held
    before_ = memory("VmRSS");
    cpu_ = std::clock();
    begin_ = std::chrono::steady_clock::now();
  }
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  [[nodiscard]] double cpu_seconds() const {
    return static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC;
  }
  [[nodiscard]] double bytes() const { return memory("VmHWM") - before_; }

 private:
  double before_;
  std::clock_t cpu_;
  std::chrono::steady_clock::time_point begin_;
};

} // namespace granum::bench
