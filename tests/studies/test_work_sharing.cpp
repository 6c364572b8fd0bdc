// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/running/work_sharing.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "unit.hpp"

using namespace granum::studies;

namespace {

/// Jobs that write down their numbers as they run.
struct Recorded {
  std::vector<Job> jobs;
  std::vector<std::size_t> order;
  std::mutex mutex;

  void add(double cost, std::optional<std::size_t> after = {}) {
    const std::size_t number = jobs.size();
    jobs.push_back({.work =
                        [this, number] {
                          const std::lock_guard lock(mutex);
                          order.push_back(number);
                        },
                    .cost = cost,
                    .after = after});
  }
};

} // namespace

TEST_CASE("one thread takes jobs by the cost of those that wait for them, numbered work in its order") {
  Recorded recorded;
  recorded.add(1);    // 0: 1 + 5 = 6
  recorded.add(2);    // 1: 2 + 7 + 4 = 13
  recorded.add(5, 0); // 2
  recorded.add(7, 1); // 3: 7 + 4 = 11
  recorded.add(4, 3); // 4
  recorded.add(5);    // 5: as costly as 2, and later in the list
  side_by_side(recorded.jobs, 1);
  CHECK(recorded.order == std::vector<std::size_t>{1, 3, 0, 2, 5, 4});
  std::vector<std::size_t> order;
  side_by_side(3, 1, [&](std::size_t k) { order.push_back(k); });
  CHECK(order == std::vector<std::size_t>{0, 1, 2});
  CHECK_NOTHROW(side_by_side(std::vector<Job>{}, 2));
}

/// Two chains for four threads: two of them have nothing to do but to begin too early.
TEST_CASE("on several threads a job begins when the one before it is done, and is done once") {
  std::vector<std::atomic<int>> done(60);
  std::atomic<int> too_early = 0;
  std::vector<Job> jobs;
  for (std::size_t k = 0; k < done.size(); ++k) {
    const std::optional<std::size_t> after = k < 2 ? std::nullopt : std::optional(k - 2);
    jobs.push_back({.work =
                        [&, k, after] {
                          if (after && done[*after] != 1)
                            ++too_early;
                          std::this_thread::sleep_for(std::chrono::microseconds(200));
                          ++done[k];
                        },
                    .cost = 1,
                    .after = after});
  }
  side_by_side(jobs, 4);
  CHECK(too_early == 0);
  for (const std::atomic<int>& times : done)
    CHECK(times == 1);
}

TEST_CASE("after an error no more work is begun, and the error is thrown") {
  std::atomic<int> begun = 0;
  std::vector<Job> jobs;
  jobs.push_back({.work = [] { throw std::runtime_error("no room"); }, .cost = 9, .after = {}});
  for (int k = 0; k < 20; ++k)
    jobs.push_back({.work = [&] { ++begun; }, .cost = 1, .after = 0});
  for (const std::size_t threads : {std::size_t{1}, std::size_t{3}}) {
    CHECK_THROWS_WITH_AS(side_by_side(jobs, threads), "no room", std::runtime_error);
    CHECK(begun == 0);
  }
}

/// Of 200,000, as a study of 900 seeds has in many sizes; to look at all of them for each would take minutes.
TEST_CASE("of many jobs each is found at once") {
  Recorded recorded;
  constexpr std::size_t many = 200000;
  for (std::size_t k = 0; k < many; ++k)
    recorded.add(1, k % 2 == 0 ? std::nullopt : std::optional(k - 1));
  side_by_side(recorded.jobs, 1);
  std::vector<std::size_t> expected(many);
  for (std::size_t k = 0; k < many; ++k)
    expected[k % 2 * (many / 2) + k / 2] = k; // the even ones first
  CHECK(recorded.order == expected);
}
