// SPDX-License-Identifier: GPL-3.0-or-later
#include "level.hpp"

#include <atomic>

#include <granum/core/error.hpp>

namespace granum {

namespace {

VectorLevel widest() {
  for (const VectorLevel level : {VectorLevel::avx512, VectorLevel::avx2})
    if (runs_here(level))
      return level;
  return VectorLevel::baseline;
}

std::atomic<VectorLevel>& setting() {
  static std::atomic<VectorLevel> level{widest()};
  return level;
}

} // namespace

bool runs_here(VectorLevel level) {
#if GRANUM_HAS_VECTOR_LEVELS
  const bool avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  if (level == VectorLevel::avx2)
    return avx2;
  // x86-64-v4, a name that not every compiler knows
  if (level == VectorLevel::avx512)
    return avx2 && __builtin_cpu_supports("bmi") != 0 && __builtin_cpu_supports("bmi2") != 0 &&
           __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
           __builtin_cpu_supports("avx512cd") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512vl") != 0;
#endif
  return level == VectorLevel::baseline;
}

VectorLevel vector_level() { return setting().load(std::memory_order_relaxed); }

void set_vector_level(VectorLevel level) {
  if (!runs_here(level))
    throw InvalidArgument("vector level: this machine does not have it");
  setting().store(level, std::memory_order_relaxed);
}

} // namespace granum
