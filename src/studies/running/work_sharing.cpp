// SPDX-License-Identifier: GPL-3.0-or-later
#include "work_sharing.hpp"

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace granum::studies {

void Meter::report(const std::string& what) const {
  if (control_.report)
    control_.report({std::min(1.0, done_ / total_), what, std::min(1.0, found_ / total_)});
}

void Meter::add(double work, const std::string& what) {
  const std::lock_guard lock(mutex_);
  done_ += work;
  report(what);
}

void Meter::found(double work, const std::string& what) {
  const std::lock_guard lock(mutex_);
  done_ += work;
  found_ += work;
  report(what);
}

void side_by_side(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr error;
  const auto worker = [&] {
    try {
      for (std::size_t k = next++; k < count; k = next++)
        work(k);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!error)
        error = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < std::min(threads, count); ++t)
    others.emplace_back(worker);
  worker();
  for (std::thread& other : others)
    other.join();
  if (error)
    std::rethrow_exception(error);
}

} // namespace granum::studies
