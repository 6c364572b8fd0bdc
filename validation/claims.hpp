// SPDX-License-Identifier: GPL-3.0-or-later
// What validation programs say of their records, line by line, and how they end.
#pragma once

#include <cstdio>
#include <exception>
#include <functional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
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

using Arguments = std::vector<std::string>;

/// What a program may be asked.
struct Command {
  std::string name;       ///< the first argument; empty: there is none
  std::string parameters; ///< names of the further arguments, those in brackets may be missing
  std::function<int(const Arguments&)> run;

  /// \param    run   of the further arguments; returns an exit code, or whether all is well, or nothing
  template <class Run>
  Command(std::string name_, std::string parameters_, const Run& run_)
      : name(std::move(name_)), parameters(std::move(parameters_)), run([run_](const Arguments& arguments) {
          using Result = decltype(run_(arguments));
          if constexpr (std::is_void_v<Result>)
            return run_(arguments), 0;
          else if constexpr (std::is_same_v<Result, bool>)
            return run_(arguments) ? 0 : 1;
          else
            return run_(arguments);
        }) {}
  [[nodiscard]] bool is_asked(const Arguments& all) const {
    std::size_t fewest = name.empty() ? 0 : 1, most = fewest;
    std::istringstream words(parameters);
    for (std::string word; words >> word; ++most)
      fewest += word.front() != '[';
    return all.size() >= fewest && all.size() <= most && (name.empty() || all.front() == name);
  }
};

/// The exit code of a program: 2 and its usage if none of the commands is asked, 1 after an exception.
inline int program(int argc, char** argv, const std::vector<Command>& commands) {
  const Arguments all(argv + 1, argv + argc);
  try {
    for (const Command& command : commands)
      if (command.is_asked(all))
        return command.run({all.begin() + (command.name.empty() ? 0 : 1), all.end()});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
  for (const Command& command : commands)
    std::fprintf(stderr, "usage: %s %s %s\n", argv[0], command.name.c_str(), command.parameters.c_str());
  return 2;
}
