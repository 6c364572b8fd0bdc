// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>
#include <nlohmann/json.hpp>

#include "option_row.hpp"

/// Common to all subcommands: exit codes, shared options, and the output of results.
namespace granum::cli {

/// Text of an empty cell.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Exit code for failed parts, such as networks or samples: ok if none failed, fell_short if some,
/// not_converged if all.
[[nodiscard]] ExitCode code_of_failed(std::size_t failed, std::size_t all);

// The commands, one file each.
[[nodiscard]] Command make_analyse();
[[nodiscard]] Command make_estimate();
[[nodiscard]] Command make_export();
[[nodiscard]] Command make_fit();
[[nodiscard]] Command make_infer();
[[nodiscard]] Command make_plan();
[[nodiscard]] Command make_reference(const Command& program);
[[nodiscard]] Command make_reproduce();
[[nodiscard]] Command make_sweep();
[[nodiscard]] Command make_trade();
[[nodiscard]] Command make_verify();

/// Whether files may be replaced: with --force only.
[[nodiscard]] inline io::Existing existing(bool force) {
  return force ? io::Existing::replace : io::Existing::keep;
}

/// Options of every subcommand.
struct OutputOptions {
  bool json = false;
  bool strict = false;
  bool force = false;
  std::string out; ///< file; empty for standard output
};

void add_output_options(Command& command, OutputOptions& options);
/// Adds --out for a folder or file, and --force to replace existing ones.
void add_output_place(Command& command, std::string& out, bool& force, std::string type, std::string out_help,
                      const std::string& replaced);
/// Adds --picture, to which --force applies too.
/// Assumes   the command has the options for output
void add_picture(Command& command, std::string& target, const std::string& help);
/// Checks the output files before any work is done.
/// \throws   InvalidArgument if the picture's name does not end in .svg; FileError if a file exists and
///           --force is not given
void require_free(const OutputOptions& output, const std::string& picture);

/// "1 thread", "2 threads".
[[nodiscard]] std::string threads_text(std::size_t threads);

/// The two ends of a range, "0m..30m"; empty for any other text, such as one with three points.
[[nodiscard]] std::optional<std::array<std::string, 2>> ends_of_range(const std::string& text);

/// The first members of a JSON result: program, version, compiler, command.
nlohmann::ordered_json json_head(std::string_view command);

/// A result as text, with U+FFFD for invalid UTF-8 in names and headings.
/// \param    indent  of each level; -1 for one line without an end
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

/// Adds the warnings to JSON, so that standard error is not needed.
[[nodiscard]] nlohmann::ordered_json with_warnings(nlohmann::ordered_json json, const Validity& validity);

/// Creates the folder of the results, before any work is done.
/// \param    names   of the files that will be written there
/// \throws   FileError if it cannot be made or written to, or contains one of the files without force
void prepare_folder(const std::filesystem::path& folder, std::span<const char* const> names, bool force);

/// The folder for the results of a command: `out`, or, if that is empty, the first free
/// granum-COMMAND-N.
/// \throws   FileError as prepare_folder, which creates it
[[nodiscard]] std::filesystem::path results_folder(const std::string& out, std::string_view command,
                                                   std::span<const char* const> names, bool force);

/// Writes a result, `table` or `json` according to the options, to standard output or the file, and its
/// validity notes as warnings to standard error.
/// \return   ok, or not_converged with --strict if there are notes
/// \throws   FileError if the result cannot be written, or the file exists and --force is not given
ExitCode deliver(const OutputOptions& options, const std::string& table, const nlohmann::ordered_json& json,
                 const Validity& validity);

} // namespace granum::cli
