// SPDX-License-Identifier: GPL-3.0-or-later
// What validation programs count of errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// Errors of one quantity, and how many lie within one and within two of their stated standard errors.
class Errors {
 public:
  void add(double error) {
    sum_ += error;
    squares_ += error * error;
    lowest_ = std::min(lowest_, error);
    highest_ = std::max(highest_, error);
    ++count_;
  }
  void add(double error, double stated) {
    add(error);
    within_one_ += std::abs(error) < stated;
    within_two_ += std::abs(error) < 2 * stated;
    within_three_ += std::abs(error) < 3 * stated;
    largest_stated_ = std::max(largest_stated_, stated);
    worst_in_stated_ = std::max(worst_in_stated_, std::abs(error) / stated);
  }
  void add(const Errors& more) {
    sum_ += more.sum_;
    squares_ += more.squares_;
    lowest_ = std::min(lowest_, more.lowest_);
    highest_ = std::max(highest_, more.highest_);
    count_ += more.count_;
    within_one_ += more.within_one_;
    within_two_ += more.within_two_;
    within_three_ += more.within_three_;
    largest_stated_ = std::max(largest_stated_, more.largest_stated_);
    worst_in_stated_ = std::max(worst_in_stated_, more.worst_in_stated_);
  }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] double rms() const { return count_ > 0 ? std::sqrt(squares_ / count_) : 0; }
  [[nodiscard]] double mean() const { return count_ > 0 ? sum_ / count_ : 0; }
  [[nodiscard]] double lowest() const { return lowest_; }
  [[nodiscard]] double highest() const { return highest_; }
  [[nodiscard]] double worst() const { return count_ > 0 ? std::max(-lowest_, highest_) : 0; }
  /// Shares within the stated errors; not a number without errors.
  [[nodiscard]] double one() const { return static_cast<double>(within_one_) / count_; }
  [[nodiscard]] double two() const { return static_cast<double>(within_two_) / count_; }
  [[nodiscard]] double three() const { return static_cast<double>(within_three_) / count_; }
  [[nodiscard]] int beyond_two() const { return count_ - within_two_; }
  [[nodiscard]] double largest_stated() const { return largest_stated_; }
  [[nodiscard]] double worst_in_stated() const { return worst_in_stated_; }

 private:
  double sum_ = 0, squares_ = 0, largest_stated_ = 0, worst_in_stated_ = 0;
  double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_;
  int count_ = 0, within_one_ = 0, within_two_ = 0, within_three_ = 0;
};

struct ErrorsOfBoth {
  Errors G, K;

  void add(const ErrorsOfBoth& more) {
    G.add(more.G);
    K.add(more.K);
  }
};

/// With its standard error.
struct Mean {
  double value = 0, error = 0;
};
inline Mean mean_of(const std::vector<double>& values) {
  const double count = static_cast<double>(values.size());
  Mean mean;
  for (const double value : values)
    mean.value += value / count;
  for (const double value : values)
    mean.error += (value - mean.value) * (value - mean.value);
  mean.error = count > 1 ? std::sqrt(mean.error / (count - 1) / count) : 0;
  return mean;
}

/// A line: of each quantity its errors in that unit, a hundredth being per cent, and what is stated of them.
inline void print_errors(const std::string& what,
                         const std::vector<std::pair<const char*, const Errors*>>& quantities,
                         double unit = 0.01) {
  const char* const sign = unit == 0.01 ? " %" : "";
  const int digits = unit == 1 ? 3 : 2;
  std::printf("%-40s %5d", what.c_str(), quantities.front().second->count());
  for (const auto& [name, e] : quantities) {
    std::printf(" | %s rms %.*f%s mean %+.*f worst %.*f", name, digits, e->rms() / unit, sign, digits,
                e->mean() / unit, digits, e->worst() / unit);
    if (e->largest_stated() > 0)
      std::printf(", within one %.0f %% two %.0f %% of %.*f%s at most", 100 * e->one(), 100 * e->two(),
                  digits - 1, e->largest_stated() / unit, sign);
  }
  std::printf("\n");
}
inline void print_errors(const std::string& what, const ErrorsOfBoth& both) {
  print_errors(what, {{"G", &both.G}, {"K", &both.K}});
}
