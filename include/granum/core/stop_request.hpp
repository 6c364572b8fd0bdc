// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <granum/core/error.hpp>

namespace granum {

/// Whether long work is to end early; empty: never. Loops ask before every step, so that a program that sets
/// a flag on Ctrl-C is heard within a second, however many grains a step moves. The answer stays true once it
/// is, and may be asked for from any thread.
using StopRequest = std::function<bool()>;

[[nodiscard]] inline bool is_stopped(const StopRequest& stop_requested) {
  return stop_requested && stop_requested();
}

/// \throws   Stopped if so asked
inline void throw_if_stopped(const StopRequest& stop_requested) {
  if (is_stopped(stop_requested))
    throw Stopped();
}

} // namespace granum
