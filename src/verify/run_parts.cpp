// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_parts.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

namespace granum::verify {

void Meter::add(double work, const std::string& what) {
  const std::lock_guard lock(mutex_);
  done_ += work;
  if (control_.report)
    control_.report({std::min(1.0, done_ / total_), what});
}

void side_by_side(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto worker = [&] {
    for (std::size_t k = next++; k < count; k = next++)
      work(k);
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < std::min(threads, count); ++t)
    others.emplace_back(worker);
  worker();
  for (std::thread& other : others)
    other.join();
}

std::string failure_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

std::string words(dem::Outcome outcome) {
  switch (outcome) {
  case dem::Outcome::converged:
    return "converged";
  case dem::Outcome::step_limit:
    return "did not come to rest within the allowed steps";
  case dem::Outcome::unstable:
    return "became unstable";
  case dem::Outcome::stopped:
    return stopped_on_request;
  }
  return "ended";
}

void require_rest(double unbalanced_force_ratio, const std::string& what) {
  constexpr double limit = 1e-6;
  if (!(unbalanced_force_ratio < limit))
    throw NotConverged(what + " did not come to rest: unbalanced force ratio " +
                       short_text(unbalanced_force_ratio));
}

} // namespace granum::verify
