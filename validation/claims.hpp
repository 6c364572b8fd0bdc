// SPDX-License-Identifier: GPL-3.0-or-later
// What validation programs say of their records, line by line.
#pragma once

#include <cstdio>
#include <string>

/// Counts the claims that do not hold; each is printed.
class Claims {
 public:
  void require(bool holds, const std::string& claim) {
    std::printf("%s  %s\n", holds ? "ok    " : "FAILED", claim.c_str());
    failed_ += !holds;
  }
  /// A goal that the record is known to miss, with the reason in its README.md: printed as missed, not
  /// counted.
  static void aim(bool reached, const std::string& goal) {
    std::printf("%s  %s\n", reached ? "ok    " : "MISSED", goal.c_str());
  }
  [[nodiscard]] int failed() const { return failed_; }

 private:
  int failed_ = 0;
};
