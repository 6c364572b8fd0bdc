// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Loops over many numbers are compiled for several vector levels; the machine uses the
// widest that it has: over grains and pairs (dem), rows of packings (effective), contacts of a network
// (network). None reorders sums. AVX2 with FMA and AVX-512 give the same bits. The baseline has no fused
// multiply-adds: code with fused() differs there by round-off, other code has the same bits everywhere
// (tests/dem/test_vector_levels.cpp, tests/effective/test_batch.cpp, tests/network/test_vector_levels.cpp).
#pragma once

#include <type_traits>

#define GRANUM_INLINE [[gnu::always_inline]] inline

namespace granum {

/// Vectors of numbers, of the compiler's own kind: a level with narrower registers works them out in parts.
using Two = double __attribute__((vector_size(2 * sizeof(double))));
using Four = double __attribute__((vector_size(4 * sizeof(double))));
using Eight = double __attribute__((vector_size(8 * sizeof(double))));

/// To read and write them where single numbers are stored.
using TwoInMemory __attribute__((may_alias)) = Two;
using FourInMemory __attribute__((may_alias)) = Four;
using EightInMemory __attribute__((may_alias)) = Eight;

enum class VectorLevel { baseline, avx2, avx512 };

/// Whether this build has code for the level and this machine runs it.
[[nodiscard]] bool runs_here(VectorLevel level);
/// The level in use: the widest that runs here, unless another was set.
[[nodiscard]] VectorLevel vector_level();
/// For tests and measurements; not while another thread computes.
void set_vector_level(VectorLevel level);

template <VectorLevel level>
using AtLevel = std::integral_constant<VectorLevel, level>;

/// a b + c, rounded once where the level has an instruction for it.
template <VectorLevel level>
GRANUM_INLINE double fused(double a, double b, double c) {
  if constexpr (level == VectorLevel::baseline)
    return a * b + c;
  else
    return __builtin_fma(a, b, c);
}

#if defined(__x86_64__) && defined(__GNUC__)
#define GRANUM_HAS_VECTOR_LEVELS 1
template <class Body>
[[gnu::target("avx2,fma")]] void run_avx2(const Body& body) {
  body(AtLevel<VectorLevel::avx2>{});
}
template <class Body>
[[gnu::target("arch=x86-64-v4")]] void run_avx512(const Body& body) {
  body(AtLevel<VectorLevel::avx512>{});
}
#else
#define GRANUM_HAS_VECTOR_LEVELS 0
#endif

/// Runs a body with an AtLevel argument, compiled for the level in use. The body, and all that it calls, must
/// be marked always_inline. Short bodies need not query the level each time.
template <class Body>
void at_vector_level(const Body& body, VectorLevel level = vector_level()) {
#if GRANUM_HAS_VECTOR_LEVELS
  if (level == VectorLevel::avx512)
    return run_avx512(body);
  if (level == VectorLevel::avx2)
    return run_avx2(body);
#else
  static_cast<void>(level);
#endif
  body(AtLevel<VectorLevel::baseline>{});
}

} // namespace granum
