// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include <granum/core/stop.hpp>

namespace granum::test {

/// A wish to stop that comes at a given question, counted from 1, and stays; 0: never. Copies count together.
class StopAt {
 public:
  explicit StopAt(std::size_t question) : question_(question) {}

  bool operator()() const {
    ++*asked_;
    return question_ > 0 && *asked_ >= question_;
  }
  /// Questions so far.
  [[nodiscard]] std::size_t asked() const { return *asked_; }

 private:
  std::size_t question_;
  std::shared_ptr<std::size_t> asked_ = std::make_shared<std::size_t>(0);
};

} // namespace granum::test
