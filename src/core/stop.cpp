// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/stop.hpp>

#include <utility>

namespace granum {

namespace {

thread_local const StopRequest* current = nullptr;

} // namespace

StopScope::StopScope(StopRequest stop_requested)
    : stop_requested_(std::move(stop_requested)), outer_(std::exchange(current, &stop_requested_)) {}

StopScope::~StopScope() { current = outer_; }

void stop_point() {
  if (current != nullptr)
    throw_if_stopped(*current);
}

} // namespace granum
