// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine_limits.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#if defined(__x86_64__)
#define GRANUM_AVX512 __attribute__((target("avx512f")))
#define GRANUM_AVX2 __attribute__((target("avx2,fma")))
#else
#define GRANUM_AVX512
#define GRANUM_AVX2
#endif

namespace granum::bench {

namespace {

bool has_avx512() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx512f") != 0;
#else
  return false;
#endif
}

bool has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return false;
#endif
}

/// Enough chains to hide the latency of a multiply-add: two a cycle, four or five cycles each.
constexpr std::size_t chains = 12;

using Vector8 = double __attribute__((vector_size(8 * sizeof(double))));
using Vector4 = double __attribute__((vector_size(4 * sizeof(double))));
using Vector2 = double __attribute__((vector_size(2 * sizeof(double))));

template <class Vector>
[[gnu::always_inline]] inline double run(double factor, double term) {
  Vector sum[chains];
#pragma GCC unroll 12
  for (std::size_t c = 0; c < chains; ++c)
    sum[c] = Vector{} + static_cast<double>(c);
  for (std::size_t n = 0; n < chain_instructions / chains; ++n)
#pragma GCC unroll 12
    for (std::size_t c = 0; c < chains; ++c)
      sum[c] = sum[c] * factor + term;
  Vector total{};
#pragma GCC unroll 12
  for (std::size_t c = 0; c < chains; ++c)
    total += sum[c];
  double result = 0;
  for (std::size_t k = 0; k < sizeof(Vector) / sizeof(double); ++k)
    result += total[k];
  return result;
}

GRANUM_AVX512 double run_avx512(double factor, double term) { return run<Vector8>(factor, term); }
GRANUM_AVX2 double run_avx2(double factor, double term) { return run<Vector4>(factor, term); }

[[gnu::always_inline]] inline void add_columns(const Streams& s) {
  const double* const __restrict a = s.a.data();
  const double* const __restrict b = s.b.data();
  const double* const __restrict c = s.c.data();
  double* const __restrict x = s.x.data();
  double* const __restrict y = s.y.data();
  for (std::size_t k = 0; k < s.x.size(); ++k) {
    x[k] = a[k] + b[k];
    y[k] = b[k] + c[k];
  }
}

GRANUM_AVX512 void add_columns_avx512(const Streams& s) { add_columns(s); }
GRANUM_AVX2 void add_columns_avx2(const Streams& s) { add_columns(s); }

} // namespace

std::size_t vector_lanes() { return has_avx512() ? 8 : has_avx2() ? 4 : 2; }

double run_chains(double factor, double term) {
  return has_avx512() ? run_avx512(factor, term)
         : has_avx2() ? run_avx2(factor, term)
                      : run<Vector2>(factor, term);
}

void stream_through_caches(const Streams& s) {
  if (has_avx512())
    add_columns_avx512(s);
  else if (has_avx2())
    add_columns_avx2(s);
  else
    add_columns(s);
}

#if defined(__x86_64__)

void stream_past_caches(const Streams& s) {
  for (std::size_t k = 0; k + 2 <= s.x.size(); k += 2) {
    const __m128d b = _mm_loadu_pd(&s.b[k]);
    _mm_stream_pd(&s.x[k], _mm_add_pd(_mm_loadu_pd(&s.a[k]), b));
    _mm_stream_pd(&s.y[k], _mm_add_pd(b, _mm_loadu_pd(&s.c[k])));
  }
  _mm_sfence();
}

GRANUM_AVX512 static void stream_lines_avx512(const Streams& s) {
  for (std::size_t k = 0; k + 8 <= s.x.size(); k += 8) {
    const __m512d b = _mm512_loadu_pd(&s.b[k]);
    _mm512_stream_pd(&s.x[k], _mm512_add_pd(_mm512_loadu_pd(&s.a[k]), b));
    _mm512_stream_pd(&s.y[k], _mm512_add_pd(b, _mm512_loadu_pd(&s.c[k])));
  }
  _mm_sfence();
}

bool stream_whole_lines(const Streams& s) {
  if (!has_avx512())
    return false;
  stream_lines_avx512(s);
  return true;
}

#else

void stream_past_caches(const Streams& s) { stream_through_caches(s); }
bool stream_whole_lines(const Streams&) { return false; }

#endif

} // namespace granum::bench
