// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src.
#pragma once

#include <cstddef>

#if defined(__wasm__)
#define GRANUM_HAS_THREADS 0
#else
#define GRANUM_HAS_THREADS 1
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>
#endif

namespace granum {

#if GRANUM_HAS_THREADS
/// Threads that run the same job side by side. They stay alive between jobs: a job in a step of an engine
/// takes some microseconds, less than starting or waking a thread. Without a job they spin for a while, then
/// yield the processor, then sleep.
class Team {
 public:
  /// \param    members   threads, that of the caller among them, at least 1
  explicit Team(std::size_t members);
  /// Ends the threads that were started, also where starting another one failed.
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  [[nodiscard]] std::size_t size() const { return threads_.size() + 1; }

  /// Calls job(member) for every member, each on its own thread, and returns when all have returned. Members
  /// see what was written before the call, and the caller sees what they wrote. The job must not throw.
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
#else
/// The same where there are no threads: the members' parts of a job are done one after the other.
class Team {
 public:
  explicit Team(std::size_t members) : members_(members) {}

  [[nodiscard]] std::size_t size() const { return members_; }
  template <class Job>
  void run(const Job& job) {
    for (std::size_t member = 0; member < members_; ++member)
      job(member);
  }

 private:
  std::size_t members_;
};
#endif

} // namespace granum
