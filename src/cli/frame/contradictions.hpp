// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "command_line.hpp"

/// Options that exclude each other, according to their rows. Checked by tests/cli/rows/people.txt
namespace granum::cli {

/// "--slope goes with --contact cone, not with --contact sphere".
[[nodiscard]] std::string belongs_to_other_contact(const std::string& option, std::string_view wanted,
                                                   std::string_view chosen);

/// Finds contradictions on one command line, option by option.
class Contradictions {
 public:
  explicit Contradictions(const std::vector<TypedArgument>& arguments);

  /// The contradiction of option `index` with an earlier one, or a missing option that it needs; empty if
  /// there is none, or if it was already reported.
  [[nodiscard]] std::string of(std::size_t index);

 private:
  [[nodiscard]] const TypedArgument* typed(std::string_view name) const;
  [[nodiscard]] bool any_typed(std::string_view names) const;
  [[nodiscard]] std::string excluded(std::size_t index) const;
  [[nodiscard]] std::string lacking(const TypedArgument& argument) const;
  [[nodiscard]] std::string belonging(const TypedArgument& argument) const;

  const std::vector<TypedArgument>& arguments_;
  bool all_known_ = true; ///< no unknown options; a missing option might be one of them
  std::set<std::string> said_;
};

} // namespace granum::cli
