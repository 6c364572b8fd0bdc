// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/core/units.hpp>

namespace CLI {
class App;
class Option;
} // namespace CLI

/// What people type, as the parser takes it. Checked by tests/cli
namespace granum::cli {

/// An option as it was typed with its value, or a word that belongs to none.
struct TypedArgument {
  std::string word;                    ///< "--pressure", "data.csv"
  const CLI::Option* option = nullptr; ///< that the command knows by this word
  std::vector<std::string> values;     ///< "100kPa"
  bool joined = false;                 ///< typed as --pressure=100kPa
};

/// Tells the options of a command and their values apart. A unit that stands apart goes to its number: of
/// --pressure 100 kPa the value is "100kPa", of --vs 280 +- 5 m/s "280+-5m/s".
[[nodiscard]] std::vector<TypedArgument> read_arguments(const CLI::App& command,
                                                        const std::vector<std::string>& words);
/// The words for the parser.
[[nodiscard]] std::vector<std::string> words_of(const std::vector<TypedArgument>& arguments);

/// A value as an option's own checks leave it, one of several choices in the letters of the choice; and what
/// they say against it, empty where that is nothing.
struct CheckedValue {
  std::string value;
  std::string complaint;
};
[[nodiscard]] CheckedValue checked(const CLI::Option& option, const std::string& value);

[[nodiscard]] std::string in_small_letters(std::string text);

/// How help calls a number of this dimension: PRESSURE, LENGTH, ..., NUMBER.
[[nodiscard]] std::string type_name(Dimension dimension);
/// What an option's number is, as its type name tells; nothing for other options.
[[nodiscard]] std::optional<Dimension> dimension_of(const CLI::Option& option);

} // namespace granum::cli
