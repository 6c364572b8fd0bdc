// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in the place of Boost's header of that name where there is one thread: its mutex needs std::mutex, which the
// C++ library for WebAssembly leaves out.
#pragma once

namespace boost::detail {

class lightweight_mutex {
 public:
  class scoped_lock {
   public:
    explicit scoped_lock(lightweight_mutex& /*mutex*/) {}
  };
};

} // namespace boost::detail
