// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

#include "frame.hpp"

namespace granum::cli {

/// From now on the first Ctrl-C (SIGINT, or SIGTERM) asks long work to end in order; another one two seconds
/// later ends the program at once, with the same exit code. Some callers, such as timeout(1), send each
/// signal more than once. To be called before the folder of results is made, which tells callers that signals
/// are heard.
/// \return   true once the work is to end
const std::atomic<bool>& listen_for_stop();

/// The exit code of work that was left undone: 130 after SIGINT, 143 after SIGTERM.
[[nodiscard]] ExitCode exit_code_of_stop();

} // namespace granum::cli
