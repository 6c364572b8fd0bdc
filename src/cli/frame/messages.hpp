// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// The only functions that write to standard output and standard error. Failures of standard error are
/// ignored, because the run matters more than its messages.
namespace granum::cli {

/// To be called before any file is opened: opens a file for each standard stream that is missing at the
/// start, so that no result gets its number. Output to standard output then fails as on a full disk; output
/// to standard error is dropped.
void open_missing_streams() noexcept;

/// To be called once: from then on a pipe without reader and a file at its limit (ulimit -f) give an error
/// instead of a signal that ends the program.
void take_writing_errors() noexcept;

/// Writes the text to standard output unchanged. If its reader has closed the pipe, as in `granum ... |
/// head`, the program ends silently, by SIGPIPE as other programs do.
/// \throws   FileError if it cannot be written
void print(std::string_view text);

/// Writes the text to standard error unchanged.
void to_standard_error(std::string_view text) noexcept;

/// Writes a line "granum: <kind>: <message>", or "granum: <message>" without a kind. Control characters, for
/// instance in names, are escaped.
void say(std::string_view kind, std::string_view message) noexcept;

} // namespace granum::cli
