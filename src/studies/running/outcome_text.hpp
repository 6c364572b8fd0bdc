// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include <granum/triaxial/specimen.hpp>

/// How the parts of a study end, in words.
namespace granum::studies {

inline constexpr const char* stopped_on_request = "stopped on request"; ///< the text of Stopped

[[nodiscard]] std::string words(dem::Outcome outcome);
/// Why a stage of compression is a failure; empty where it converged.
[[nodiscard]] std::string failure_of(const triaxial::Snapshot& stage);

/// Runs a part of a piece of work and turns an error into the text of a failure; empty if there was none.
/// \throws   FileError as work does: a file that cannot be written ends the whole study; Stopped as work
///           does: a stopped part has not failed, and runs again when the study is resumed; std::bad_alloc
[[nodiscard]] std::string failure_of(const std::function<void()>& work);

/// Runs a whole piece of work. As failure_of, but a stop on request also gives a text, stopped_on_request.
/// \throws   FileError as work does
[[nodiscard]] std::string failure_or_stop_of(const std::function<void()>& work);

} // namespace granum::studies
