// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <type_traits>
#include <vector>

namespace granum::dem {

/// Threads that stand ready to work off the same job side by side: a step of an engine has some microseconds
/// for each of its jobs, too few to start threads or to wake them. They spin for a while, then let others
/// run, and sleep where no job comes.
class Team {
 public:
  /// \param    members   threads, that of the caller among them, at least 1
  explicit Team(std::size_t members);
  /// The members that are there go, also where one more could not be had.
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  [[nodiscard]] std::size_t size() const { return threads_.size() + 1; }

  /// Calls job(member) for every member, each on its own thread, and returns when all have returned. What was
  /// written before is seen by the members, and what they write, after. The job must not throw.
  template <class Job>
  void run(const Job& job) {
    start([](const void* what, std::size_t member) { (*static_cast<const Job*>(what))(member); }, &job);
    job(0);
    wait();
  }

 private:
  Team() = default;
  using Call = void (*)(const void*, std::size_t);

  void start(Call call, const void* job);
  void wait() const;
  void work(std::size_t member);

  Call call_ = nullptr; ///< null: no more jobs
  const void* job_ = nullptr;
  alignas(64) std::atomic<std::uint32_t> round_{0};
  alignas(64) std::atomic<std::uint32_t> busy_{0};
  std::vector<std::thread> threads_;
};

} // namespace granum::dem
