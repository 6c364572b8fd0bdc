// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <granum/core/units.hpp>
#include <granum/core/validity.hpp>
#include <nlohmann/json.hpp>

namespace CLI {
class App;
class Option;
class Validator;
} // namespace CLI

/// What the subcommands share: exit codes, options that all of them take, and the way results leave the
/// program.
namespace granum::cli {

/// What a table shows as an empty cell.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

enum class ExitCode : int {
  ok = 0,
  fell_short = 1,    ///< some rows failed, or a check fell short
  usage = 2,         ///< arguments that cannot be
  file = 3,          ///< a file that cannot be read or written
  not_converged = 4, ///< numerics did not arrive, or --strict and outside validity
  // work that was left undone has 128 and the number of the signal: exit_code_of_stop
};

/// Of parts that did not arrive, such as networks or samples: ok if none, fell_short if some, not_converged
/// if all.
[[nodiscard]] ExitCode code_of_failed(std::size_t failed, std::size_t all);

/// A subcommand: its parser, and its work, which runs after parsing. The work throws granum's errors, and
/// main turns them into a message and an exit code. Each subcommand has one file with one function `Command
/// add_<name>(App&)`.
struct Command {
  CLI::App* app = nullptr;
  std::function<ExitCode()> run;
};

Command add_analyse(CLI::App& program);
Command add_estimate(CLI::App& program);
Command add_export(CLI::App& program);
Command add_fit(CLI::App& program);
Command add_infer(CLI::App& program);
Command add_plan(CLI::App& program);
Command add_reference(CLI::App& program);
Command add_reproduce(CLI::App& program);
Command add_sweep(CLI::App& program);
Command add_trade(CLI::App& program);
Command add_verify(CLI::App& program);

/// Options that every subcommand takes.
struct OutputOptions {
  bool json = false;
  bool strict = false;
  bool force = false;
  std::string out; ///< file; empty for standard output
};

void add_output_options(CLI::App& command, OutputOptions& options);

/// An option that takes a number with its unit, into SI. `target` holds the default; InvalidArgument for bad
/// text.
CLI::Option* add_quantity(CLI::App& command, const std::string& name, double& target, Dimension dimension,
                          const std::string& help);

/// The same for a quantity that is given or not.
CLI::Option* add_quantity(CLI::App& command, const std::string& name, std::optional<double>& target,
                          Dimension dimension, const std::string& help);

/// "1 thread", "2 threads".
[[nodiscard]] std::string threads_text(std::size_t threads);

/// The two ends of a range, "0m..30m"; nothing for another text, as one with three points.
[[nodiscard]] std::optional<std::array<std::string, 2>> ends_of_range(const std::string& text);

/// An option that takes the name of a file or folder. Empty text, as of a shell variable that is not set, is
/// refused: `target` stays empty where the option is not given.
CLI::Option* add_path(CLI::App& command, const std::string& name, std::string& target,
                      const std::string& help);

/// --picture, to which --force speaks as well.
/// Assumes   the command has the options for output
CLI::Option* add_picture(CLI::App& command, std::string& target, const std::string& help);

/// Other words for a choice, and the choice: "hertz" for sphere.
using OtherWords = std::vector<std::pair<std::string, std::string>>;

/// For transform() of an option that takes one of a few words, in large or small letters; what is near to one
/// of them is asked back.
CLI::Validator one_of(const std::vector<std::string>& words, const OtherWords& others = {});

/// For check() of an option whose text `read` takes, or refuses with InvalidArgument: what it says then is
/// told beside other mistakes.
CLI::Validator taken_by(const std::function<void(const std::string&)>& read);

/// The object that a JSON result begins with: program, version, compiler, command.
nlohmann::ordered_json json_head(std::string_view command);

/// A result as it is written, with U+FFFD for what is no UTF-8 in names and headings.
/// \param    indent  of each level; -1 for one line without an end
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

/// The warnings stand in the JSON too, so that its reader does not need standard error.
[[nodiscard]] nlohmann::ordered_json with_warnings(nlohmann::ordered_json json, const Validity& validity);

/// Makes the folder that results go to, before any work is done.
/// \param    names   of the files that will be written there
/// \throws   FileError if it cannot be made or written to, or holds one of the files and force is not set
void prepare_folder(const std::filesystem::path& folder, std::span<const char* const> names, bool force);

/// The folder for the results of a command: the one asked for, or, where `out` is empty, the first free
/// granum-COMMAND-N.
/// \throws   FileError as prepare_folder, which makes it
[[nodiscard]] std::filesystem::path results_folder(const std::string& out, std::string_view command,
                                                   std::span<const char* const> names, bool force);

/// Delivers a result, `table` or `json` as the options ask, to standard output or the file, and the notes of
/// its validity as warnings to standard error.
/// \return   ok, or not_converged if there are notes and --strict
/// is given
/// \throws   FileError if the result cannot be written, or the file exists and --force is not given
ExitCode deliver(const OutputOptions& options, const std::string& table, const nlohmann::ordered_json& json,
                 const Validity& validity);

} // namespace granum::cli
