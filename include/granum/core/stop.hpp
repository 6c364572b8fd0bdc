// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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

/// \file
/// A stop request for functions that have no argument for one: readers of files, measurements on packings,
/// samples, fits.
/// Checked by tests/core/test_stop_scope.cpp

/// While it lives, long work of this thread ends with the exception Stopped once the request is true. An
/// inner scope replaces an outer one until it ends. Threads that this one starts have none.
class StopScope {
 public:
  explicit StopScope(StopRequest stop_requested);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

 private:
  StopRequest stop_requested_;
  const StopRequest* outer_;
};

/// Called by loops that may last, a few times in a tenth of a second or more often.
/// \throws   Stopped if the request of this thread's scope is true
void stop_point();

/// The same in a loop of short steps, in every 256th of them.
inline void stop_point(std::size_t step) {
  if (step % 256 == 0) [[unlikely]]
    stop_point();
}

} // namespace granum
