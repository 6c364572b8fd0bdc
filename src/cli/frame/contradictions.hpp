// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "command_line.hpp"

/// Options that cannot stand on one command line, as their rows have it. Checked by tests/cli/people.cmake
namespace granum::cli {

/// What is said where one thing is told twice, by options or by a row of a table.
namespace said_twice {
inline constexpr const char* density =
    "the density is given more than once: give one of --void-ratio, --porosity, --solid-fraction, "
    "--relative-density";
inline constexpr const char* stress = "--pressure sets both stresses: leave out --stress-v and --stress-h";
inline constexpr const char* rattlers =
    "--mechanical-coordination-number and --rattler-fraction say the same: give one";
inline constexpr const char* size = "--radius and --d50 say the same: give one";
inline constexpr const char* grain =
    "--grain-poisson-ratio and --grain-bulk-modulus are of one solid, with its shear modulus: give one";
inline constexpr const char* sizes = "--sizes, --sieve and --uniformity say the same: give one of them, once";
} // namespace said_twice

/// "--slope goes with --contact cone, not with --contact sphere".
[[nodiscard]] std::string belongs_to_other_contact(const std::string& option, std::string_view wanted,
                                                   std::string_view chosen);

/// Finds what contradicts what on one command line, option by option.
class Contradictions {
 public:
  explicit Contradictions(const std::vector<TypedArgument>& arguments);

  /// What option `index` contradicts among those before it, or needs and has not; empty where that is
  /// nothing, or was said of another one.
  [[nodiscard]] std::string of(std::size_t index);

 private:
  [[nodiscard]] const TypedArgument* typed(std::string_view name) const;
  [[nodiscard]] bool any_typed(std::string_view names) const;
  [[nodiscard]] std::string excluded(std::size_t index) const;
  [[nodiscard]] std::string lacking(const TypedArgument& argument) const;
  [[nodiscard]] std::string belonging(const TypedArgument& argument) const;

  const std::vector<TypedArgument>& arguments_;
  bool all_known_ = true; ///< no word is an option that the command lacks: what seems missing may be that one
  std::set<std::string> said_;
};

} // namespace granum::cli
