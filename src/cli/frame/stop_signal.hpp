// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

#include "frame.hpp"

namespace granum::cli {

/// From now on the first signal to stop ends long work in order: Ctrl-C (SIGINT), SIGTERM, or the SIGHUP of a
/// terminal that is closed, unless nohup(1) had it ignored. Another one two seconds later ends the program at
/// once, with the same exit code. Some callers, such as timeout(1), send each signal more than once. Call it
/// before the folder of results is made, so that callers know from the folder that signals are handled.
/// \return   true once the work is to end
const std::atomic<bool>& listen_for_stop();

/// The exit code of work that was left undone: 129 after SIGHUP, 130 after SIGINT, 143 after SIGTERM.
[[nodiscard]] ExitCode exit_code_of_stop();

} // namespace granum::cli
