// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include <granum/dem/quasistatic.hpp>

/// How the parts of a study end, in words.
namespace granum::studies {

inline constexpr const char* stopped_on_request = "stopped on request"; ///< as Stopped says it

[[nodiscard]] std::string words(dem::Outcome outcome);

/// Runs a part of a piece of work and turns an error into the text of a failure; empty if there was none.
/// \throws   FileError as work does: a file that cannot be written ends the whole study; Stopped as work
///           does: the piece has then not failed of this part, and goes on with it when it is taken up again
[[nodiscard]] std::string failure_of(const std::function<void()>& work);

/// Runs a whole piece of work; that it was stopped is told like a failure.
/// \throws   FileError as work does
[[nodiscard]] std::string ending_of(const std::function<void()>& work);

} // namespace granum::studies
