// SPDX-License-Identifier: GPL-3.0-or-later
// What validation programs count of errors.
#pragma once

#include <algorithm>
#include <cmath>

/// Errors of one quantity.
class Errors {
 public:
  void add(const Errors& more) {
    sum_ += more.sum_;
    squares_ += more.squares_;
    worst_ = std::max(worst_, more.worst_);
    count_ += more.count_;
  }
  void add(double error) {
    sum_ += error;
    squares_ += error * error;
    worst_ = std::max(worst_, std::abs(error));
    ++count_;
  }
  [[nodiscard]] double rms() const { return count_ > 0 ? std::sqrt(squares_ / count_) : 0; }
  [[nodiscard]] double mean() const { return count_ > 0 ? sum_ / count_ : 0; }
  [[nodiscard]] double worst() const { return worst_; }
  [[nodiscard]] int count() const { return count_; }

 private:
  double sum_ = 0, squares_ = 0;
  double worst_ = 0;
  int count_ = 0;
};

/// How many lie within one and within two of their stated standard errors.
struct Coverage {
  int count = 0, within_one = 0, within_two = 0;
  double largest_stated = 0;

  void add(const Coverage& more) {
    count += more.count;
    within_one += more.within_one;
    within_two += more.within_two;
    largest_stated = std::max(largest_stated, more.largest_stated);
  }
  void add(double error, double stated) {
    ++count;
    within_one += std::abs(error) < stated;
    within_two += std::abs(error) < 2 * stated;
    largest_stated = std::max(largest_stated, stated);
  }
  [[nodiscard]] double one() const { return static_cast<double>(within_one) / count; }
  [[nodiscard]] double two() const { return static_cast<double>(within_two) / count; }
};
