// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <granum/core/error.hpp>

namespace granum {

/// Returns whether long work is to end early; empty: never. Loops call it before every step, so that a flag
/// set on Ctrl-C takes effect within a second for any number of grains. Once true it stays true. Any thread
/// may call it.
using StopRequest = std::function<bool()>;

[[nodiscard]] inline bool is_stopped(const StopRequest& stop_requested) {
  return stop_requested && stop_requested();
}

/// \throws   Stopped if the request is true
inline void throw_if_stopped(const StopRequest& stop_requested) {
  if (is_stopped(stop_requested))
    throw Stopped();
}

} // namespace granum
