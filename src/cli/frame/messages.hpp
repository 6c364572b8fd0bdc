// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// The one way to standard error. A run is worth more than what it says there: nothing here throws, and a
/// stream that is closed, full or read by nobody any more is left alone.
namespace granum::cli {

/// To be called before any file is opened: gives a standard stream that the program was started without a
/// file of its own, so that no result takes its number. What goes to standard output then is refused as by a
/// full disk; what goes to standard error is dropped.
void open_missing_streams() noexcept;

/// Writes the text as it is.
void to_standard_error(std::string_view text) noexcept;

/// A line "granum: <kind>: <message>"; without the kind where it is empty. Control characters, as of
/// names, are written out.
void say(std::string_view kind, std::string_view message) noexcept;

} // namespace granum::cli
