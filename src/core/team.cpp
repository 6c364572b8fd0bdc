// SPDX-License-Identifier: GPL-3.0-or-later
#include "team.hpp"

#if GRANUM_HAS_THREADS
namespace granum {

namespace {

/// A waiting thread checks its condition `looks` times (some ten microseconds), then yields the processor
/// `turns` times (a tenth of a millisecond), then sleeps. Where each thread has its own processor the wait is
/// over before that, and no time goes into waking threads, which takes longer than a thread's share of a
/// step. On a busy machine other threads may have to wait for a processor much longer; sleeping frees one.
constexpr int looks = 300;
constexpr int turns = 500;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Whether the condition came true before it is time to sleep.
template <class Condition>
bool came_true(const Condition& condition) {
  for (int k = 0; k < looks; ++k) {
    if (condition())
      return true;
    pause();
  }
  for (int k = 0; k < turns; ++k) {
    if (condition())
      return true;
    std::this_thread::yield();
  }
  return false;
}

} // namespace

Team::Team(std::size_t members) : Team() { // complete from here on: a failure below runs the destructor
  for (std::size_t member = 1; member < members; ++member)
    threads_.emplace_back([this, member] { work(member); });
}

Team::~Team() {
  start(nullptr, nullptr);
  for (std::thread& thread : threads_)
    thread.join();
}

void Team::start(Call call, const void* job) {
  call_ = call;
  job_ = job;
  busy_.store(static_cast<std::uint32_t>(threads_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void Team::wait() const {
  if (came_true([this] { return busy_.load(std::memory_order_acquire) == 0; }))
    return;
  for (std::uint32_t busy = 0; (busy = busy_.load(std::memory_order_acquire)) != 0;)
    busy_.wait(busy, std::memory_order_acquire);
}

void Team::work(std::size_t member) {
  for (std::uint32_t round = 0;; ++round) {
    const auto begun = [&] { return round_.load(std::memory_order_acquire) != round; };
    if (!came_true(begun))
      round_.wait(round, std::memory_order_acquire);
    if (call_ == nullptr)
      return;
    call_(job_, member);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1)
      busy_.notify_one();
  }
}

} // namespace granum
#endif
