// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Stores that go past the caches, where the processor has them: memory that is wholly
// overwritten need not be read first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace granum {

/// Copies numbers that begin at a multiple of 16 bytes.
inline void store_past_caches(const double* from, std::size_t count, double* to) {
#if defined(__SSE2__)
  if (reinterpret_cast<std::uintptr_t>(to) % 16 == 0 && count % 2 == 0) {
    for (std::size_t k = 0; k < count; k += 2)
      _mm_stream_pd(to + k, _mm_load_pd(from + k));
    return;
  }
#endif
  std::copy_n(from, count, to);
}

/// Orders the stores of store_past_caches() before all that follows.
inline void finish_stores() {
#if defined(__SSE2__)
  _mm_sfence();
#endif
}

} // namespace granum
