// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace granum::cli {

/// From now on the first Ctrl-C (or termination) asks long work to end in order; another one two seconds
/// later ends the program at once, with exit code 130. Some callers, such as timeout(1), send each signal
/// more than once.
/// \return   true once the work is to end
const std::atomic<bool>& listen_for_stop();

} // namespace granum::cli
