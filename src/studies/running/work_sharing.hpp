// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "studies/running/run_control.hpp"
#include <granum/core/stop.hpp>

/// How studies share work among threads and report their progress.
namespace granum::studies {

/// Adds up the predicted work of the finished pieces and reports its share of the whole.
class Meter {
 public:
  Meter(const RunControl& control, double total) : control_(control), total_(total) {}

  void add(double work, const std::string& what);
  /// Work that an earlier run of the same study has done; it does not count for the speed of this run.
  void found(double work, const std::string& what);
  /// Makes stopped() true for all pieces, as RunControl::stop does.
  void stop_all() { all_stopped_ = true; }
  [[nodiscard]] bool stopped() const {
    return all_stopped_ || (control_.stop != nullptr && control_.stop->load());
  }
  /// For the loops of a piece of work. The meter must outlive it.
  [[nodiscard]] StopRequest stop_request() const {
    return [this] { return stopped(); };
  }

 private:
  const RunControl& control_;
  double total_;
  void report(const std::string& what) const;

  double done_ = 0;
  double found_ = 0;
  std::atomic<bool> all_stopped_ = false;
  std::mutex mutex_;
};

/// A piece of work for one thread.
struct Job {
  std::function<void()> work;
  double cost = 0;                  ///< predicted, in any unit
  std::optional<std::size_t> after; ///< an earlier job of the list, which has to be done before this one
};

/// Does all jobs, each once, on several threads. Among the jobs that may begin, a free thread takes the one
/// at the head of the costliest chain, so that no thread ends up alone with a long one; of equal ones the
/// first. After the first error no more work is begun; when all threads are through, that error is thrown.
/// Checked by tests/studies/test_work_sharing.cpp
void side_by_side(const std::vector<Job>& jobs, std::size_t threads);
/// The same for work(0) .. work(count - 1), begun in that order.
void side_by_side(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work);

} // namespace granum::studies
