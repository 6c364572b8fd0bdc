// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "option_row.hpp"

/// The parser of command lines, from the rows of a command's options. It joins units to their
/// numbers, and finds all that is wrong before any work is done. Checked by tests/cli
namespace granum::cli {

/// An option as it was typed with its value, or a word that belongs to none.
struct TypedArgument {
  std::string word;                  ///< "--pressure", "data.csv"
  const OptionRow* option = nullptr; ///< that the command knows by this word
  std::vector<std::string> values;   ///< "100kPa"
  bool stray = false;                ///< is no option, and no argument of the command
};

/// Separates the options of a command from their values. A separate unit is joined to its number: of
/// --pressure 100 kPa the value is "100kPa", of --vs 280 +- 5 m/s "280+-5m/s".
[[nodiscard]] std::vector<TypedArgument> read_arguments(const Command& command,
                                                        const std::vector<std::string>& words);

/// Hands the values to their rows. One sentence for each option that the command does not know, each word
/// that belongs to no option where the command takes none, each option without its value, each number or
/// choice that cannot be taken, and each option that contradicts one before it or lacks one that it needs; in
/// the order in which they were typed. Then for each option that is required and not there.
/// \param    program  with all commands, of which another may know the option
/// \return   the error; empty if every value was accepted
/// \throws   FileError of a value that is read at once, where nothing else is wrong
[[nodiscard]] std::vector<std::string> take_arguments(const Command& program, const Command& command,
                                                      const std::vector<TypedArgument>& arguments);

} // namespace granum::cli
