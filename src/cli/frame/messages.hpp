// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// The only functions that write to standard output and standard error. Failures of standard error are
/// ignored, because the run is more important than its messages.
namespace granum::cli {

/// To be called before any file is opened: gives a standard stream that the program was started without a
/// file of its own, so that no result takes its number. Output to standard output then fails as on a full
/// disk; output to standard error is dropped.
void open_missing_streams() noexcept;

/// Call once: a pipe without reader and a file at its limit (ulimit -f) then give an error
/// from then on, not a signal that ends the program.
void take_writing_errors() noexcept;

/// Writes the text to standard output as it is. Where its reader has had enough, as of `granum ... | head`,
/// the program ends without a word, by SIGPIPE as other programs do.
/// \throws   FileError if it cannot be written
void print(std::string_view text);

/// Writes the text to standard error as it is.
void to_standard_error(std::string_view text) noexcept;

/// A line "granum: <kind>: <message>"; without the kind where it is empty. Control characters, as of
/// names, are written out.
void say(std::string_view kind, std::string_view message) noexcept;

} // namespace granum::cli
