// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

/// What this machine can do at best, measured by loops that do nothing else.
namespace granum::bench {

/// Doubles in a vector register of the level that a kernel with target_clones runs on here: 8, 4 or 2.
[[nodiscard]] std::size_t vector_lanes();

/// Multiply-adds on independent chains at that level, so many vector instructions in one call.
inline constexpr std::size_t chain_instructions = 12 * 1360;
/// Runs them; the result depends on all.
[[nodiscard]] double run_chains(double factor, double term);

/// The columns of a batch: three are read, two are written.
struct Streams {
  std::span<const double> a, b, c;
  std::span<double> x, y;
};
/// x = a + b, y = b + c by ordinary stores, which read what they overwrite.
void stream_through_caches(const Streams& streams);
/// The same by stores that go past the caches, of 16 bytes as every x86-64 machine has them.
void stream_past_caches(const Streams& streams);
/// The same by stores of a whole cache line; false where the machine has none of that width.
bool stream_whole_lines(const Streams& streams);

} // namespace granum::bench
