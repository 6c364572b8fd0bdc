// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// The one way to standard output and to standard error. A run is worth more than what it says on standard
/// error: one that is closed, full or read by nobody any more is left alone.
namespace granum::cli {

/// To be called before any file is opened: gives a standard stream that the program was started without a
/// file of its own, so that no result takes its number. What goes to standard output then is refused as by a
/// full disk; what goes to standard error is dropped.
void open_missing_streams() noexcept;

/// To be called once: a pipe that nobody reads any more and a file at its limit (ulimit -f) give an error
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
