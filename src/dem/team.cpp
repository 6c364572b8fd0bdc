// SPDX-License-Identifier: GPL-3.0-or-later
#include "team.hpp"

namespace granum::dem {

namespace {

/// A few microseconds of looking, then as many turns given to others.
constexpr int looks = 300;
constexpr int turns = 200;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Whether it came true within the time that is worth waiting awake.
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

Team::Team(std::size_t members) {
  for (std::size_t member = 1; member < members; ++member)
    threads_.emplace_back([this, member] { work(member); });
}

Team::~Team() { start(nullptr, nullptr); }

void Team::start(Call call, const void* job) {
  call_ = call;
  job_ = job;
  busy_.store(threads_.size(), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void Team::wait() const {
  const auto done = [this] { return busy_.load(std::memory_order_acquire) == 0; };
  while (!came_true(done)) {
  }
}

void Team::work(std::size_t member) {
  for (std::uint32_t round = 0;; ++round) {
    const auto begun = [&] { return round_.load(std::memory_order_acquire) != round; };
    if (!came_true(begun))
      round_.wait(round, std::memory_order_acquire);
    if (call_ == nullptr)
      return;
    call_(job_, member);
    busy_.fetch_sub(1, std::memory_order_release);
  }
}

} // namespace granum::dem
