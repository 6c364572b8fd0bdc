// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include <granum/dem/quasistatic.hpp>

/// How the parts of a study end, in words.
namespace granum::verify {

inline constexpr const char* stopped_on_request = "stopped on request";

[[nodiscard]] std::string words(dem::Outcome outcome);

/// Runs work and turns an error into the text of a failure; empty if there was none.
/// \throws   FileError as work does: a file that cannot be written ends the whole study
[[nodiscard]] std::string failure_of(const std::function<void()>& work);

} // namespace granum::verify
