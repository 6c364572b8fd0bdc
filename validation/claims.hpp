// SPDX-License-Identifier: GPL-3.0-or-later
// What validation programs say of their records, line by line, and how they end.
#pragma once

#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include <granum/core/text.hpp>

#include "errors.hpp"

/// Counts the claims that do not hold; each is printed.
class Claims {
 public:
  void require(bool holds, const std::string& claim) {
    std::printf("%s  %s\n", holds ? "ok    " : "FAILED", claim.c_str());
    failed_ += !holds;
  }
  /// That at least these shares lie within one and within two stated errors, and no more within one.
  void require_covered(const Errors& errors, const std::string& of, double one = 0.55, double two = 0.90,
                       double most_one = 1) {
    require(errors.one() >= one && errors.one() <= most_one && errors.two() >= two,
            granum::detail::formatted(
                "%s: %.0f %% within one stated error (%.0f to %.0f), %.0f %% within two (%.0f)", of.c_str(),
                100 * errors.one(), 100 * one, 100 * most_one, 100 * errors.two(), 100 * two));
  }
  /// A goal that the record is known to miss, with the reason in its README.md: printed as missed, not
  /// counted.
  static void aim(bool reached, const std::string& goal) {
    std::printf("%s  %s\n", reached ? "ok    " : "MISSED", goal.c_str());
  }
  [[nodiscard]] int exit_code() const { return failed_ == 0 ? 0 : 1; }

 private:
  int failed_ = 0;
};

/// The exit code of a program: that of `run` of its arguments; 2 and its usage if that gives none; 1 after an
/// exception.
template <class Run>
int program(int argc, char** argv, const char* usage, const Run& run) {
  try {
    const std::optional<int> code = run(std::vector<std::string>(argv + 1, argv + argc));
    if (code)
      return *code;
    std::fprintf(stderr, "usage: %s %s\n", argv[0], usage);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
}
