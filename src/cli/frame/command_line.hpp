// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/error.hpp>

#include "option_row.hpp"

/// The parser of command lines, based on the option rows of a command. It joins units to their
/// numbers, and reports all errors before any work is done. Checked by tests/cli
namespace granum::cli {

/// An option as typed with its value, or a word without an option.
struct TypedArgument {
  std::string word;                  ///< "--pressure", "data.csv"
  const OptionRow* option = nullptr; ///< option of the command with this name
  std::vector<std::string> values;   ///< "100kPa"
  bool stray = false;                ///< neither an option nor an argument of the command
};

/// Separates the options of a command from their values. A separate unit is joined to its number: of
/// --pressure 100 kPa the value is "100kPa", of --vs 280 +- 5 m/s "280+-5m/s".
[[nodiscard]] std::vector<TypedArgument> read_arguments(const Command& command,
                                                        const std::vector<std::string>& words);

/// Passes the values to their rows. Reports one sentence for each unknown option, each word that is no
/// argument, each option without its value, each invalid number or choice, and each option that contradicts
/// an earlier one or lacks a required one, in the order of typing; then for each required option that is
/// missing.
/// \param    program  with all commands, to find the command of an unknown option
/// \return   the error; empty if every value was accepted
/// \throws   FileError for a file that is read immediately, if there is no other error
[[nodiscard]] std::vector<std::string> take_arguments(const Command& program, const Command& command,
                                                      const std::vector<TypedArgument>& arguments);

/// An input as it was typed, for the record of a run.
struct AskedOption {
  std::string option, value, meaning; ///< "--pressure", "100kPa", "Effective mean stress"
};
/// Those of the command that runs, without those of output.
[[nodiscard]] const std::vector<AskedOption>& asked_options();
/// To be called once, before the command runs.
void remember_asked(const std::vector<TypedArgument>& arguments);

/// The error with a number that the library refused named as it was typed, "--stress-h" for "stress_h"; as it
/// is where another number was typed: the refused one is of another state, such as a prediction. A text that
/// begins with a name, "column map: ", begins with the option if that was typed. Checked by tests/cli/rows
[[nodiscard]] InvalidArgument as_typed(const InvalidArgument& error,
                                       const std::vector<TypedArgument>& arguments);

} // namespace granum::cli
