// SPDX-License-Identifier: GPL-3.0-or-later
#include "work_sharing.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <set>
#include <thread>
#include <utility>

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

namespace {

/// The jobs of one call, and how far they are; its functions are called by all threads.
class Queue {
 public:
  explicit Queue(const std::vector<Job>& jobs)
      : jobs_(jobs), chain_(jobs.size()), followers_(jobs.size()), waiting_(jobs.size()) {
    for (std::size_t k = jobs.size(); k-- > 0;) {
      chain_[k] += jobs[k].cost;
      if (const auto before = jobs[k].after) {
        chain_.at(*before) = std::max(chain_.at(*before), chain_[k]);
        followers_[*before].push_back(k);
      }
    }
    for (std::size_t k = 0; k < jobs.size(); ++k)
      if (!jobs[k].after)
        may_begin_.emplace(-chain_[k], k);
  }

  void work_off() {
    for (std::optional<std::size_t> k = take(); k; k = take()) {
      std::exception_ptr error;
      try {
        jobs_[*k].work();
      } catch (...) {
        error = std::current_exception();
      }
      finish(*k, error);
    }
  }

  void throw_error() const {
    if (error_)
      std::rethrow_exception(error_);
  }

 private:
  /// Waits until a job may begin and returns the head of the costliest chain; empty if none is left.
  std::optional<std::size_t> take() {
    std::unique_lock lock(mutex_);
    while (!error_ && waiting_ > 0) {
      if (!may_begin_.empty()) {
        const std::size_t next = may_begin_.begin()->second;
        may_begin_.erase(may_begin_.begin());
        --waiting_;
        return next;
      }
      finished_.wait(lock);
    }
    return std::nullopt;
  }

  void finish(std::size_t k, const std::exception_ptr& error) {
    const std::lock_guard lock(mutex_);
    for (const std::size_t follower : followers_[k])
      may_begin_.emplace(-chain_[follower], follower);
    if (!error_)
      error_ = error;
    finished_.notify_all();
  }

  const std::vector<Job>& jobs_;
  std::vector<double> chain_; ///< cost of a job and of the costliest chain of jobs that wait for it
  std::vector<std::vector<std::size_t>> followers_;
  std::set<std::pair<double, std::size_t>> may_begin_; ///< less the cost of its chain, and a job
  std::size_t waiting_;                                ///< jobs that no thread has started
  std::exception_ptr error_;                           ///< the first
  std::mutex mutex_;
  std::condition_variable finished_;
};

} // namespace

void side_by_side(const std::vector<Job>& jobs, std::size_t threads) {
  Queue queue(jobs);
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < std::min(threads, jobs.size()); ++t)
    others.emplace_back([&queue] { queue.work_off(); });
  queue.work_off();
  for (std::thread& other : others)
    other.join();
  queue.throw_error();
}

void side_by_side(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work) {
  std::vector<Job> jobs;
  for (std::size_t k = 0; k < count; ++k)
    jobs.push_back({.work = [&work, k] { work(k); }, .cost = 1, .after = {}});
  side_by_side(jobs, threads);
}

} // namespace granum::studies
