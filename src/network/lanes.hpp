// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network. Storage of the six load cases side by side, so that one pass over the contacts
// serves all.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

// The marked function is compiled for three vector levels and the machine picks one at start. No level
// contracts products into fused multiply-adds (see granum_compile_settings), so all give the same bits. The
// thread sanitizer starts after the choice is made: it gets the plain one.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) &&             \
    !defined(__SANITIZE_THREAD__)
#define GRANUM_VECTOR_LEVELS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define GRANUM_VECTOR_LEVELS
#endif

namespace granum::network {

inline constexpr int load_cases = 6;
inline constexpr int lane_count =
    8; ///< the six load cases, padded to a whole vector register; lanes 6 and 7 stay zero

/// One number of every load case.
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

/// One number of every load case, where no pass over grains is made.
using PerCase = std::array<double, std::size_t{load_cases}>;

/// Degrees of freedom of one grain (rows) for every load case (lanes).
template <int Dof>
struct alignas(64) Rows {
  Lanes row[std::size_t{Dof}] = {};
};

/// A vector over all grains, for every load case.
template <int Dof>
using Field = std::vector<Rows<Dof>>;

/// Coupling of two grains, or of one with itself.
template <int Dof>
struct Block {
  double at[std::size_t{Dof}][std::size_t{Dof}] = {};
};

/// 6 x 6 products of two fields.
struct alignas(64) Gram {
  Lanes row[load_cases] = {};
};

} // namespace granum::network
