// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>

#include <granum/dem/quasistatic.hpp>
#include <granum/verify/study.hpp>

/// What long studies share: pieces of work side by side, their progress, and what became of them.
namespace granum::verify {

/// Shares the predicted work among the finished pieces and passes it on.
class Meter {
 public:
  Meter(const RunControl& control, double total) : control_(control), total_(total) {}

  void add(double work, const std::string& what);
  [[nodiscard]] bool stopped() const { return control_.stop != nullptr && control_.stop->load(); }

 private:
  const RunControl& control_;
  double total_;
  double done_ = 0;
  std::mutex mutex_;
};

/// Calls work(0) .. work(count - 1), each once, on several threads.
void side_by_side(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work);

/// Runs work and turns an error of granum's into the text of a failure.
[[nodiscard]] std::string failure_of(const std::function<void()>& work);

inline constexpr const char* stopped_on_request = "stopped on request";

/// "converged", "became unstable", ...
[[nodiscard]] std::string words(dem::Outcome outcome);

/// Rest that is good enough for moduli: an escaping rattler may keep a specimen above the tolerance that is
/// aimed at.
/// \throws   NotConverged above an unbalanced force ratio of 1e-6
void require_rest(double unbalanced_force_ratio, const std::string& what);

} // namespace granum::verify
