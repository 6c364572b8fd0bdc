// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/sizes/distribution.hpp>

namespace granum::sizes {

/// How radii are drawn.
enum class Drawing {
  stratified, ///< one of each of N classes of equal number, shuffled: moments as near as N grains can be
  plain       ///< independently; a longer sample begins with the shorter
};

/// Radii x = r/<r> of grains, in no order. Random bits by Boost, then the quantile function: the same seed
/// gives the same bits on every machine for equal, bidisperse and uniform grains, elsewhere up to the last
/// digit of the C library's exp and log.
/// \param    count   number of grains, 0 allowed
/// \param    seed    any number; one seed, one sample
/// Accuracy  of moments: plain, the standard error of independent draws; stratified, far better for size
///           ratios up to 10. Beyond, few large grains have most of the mass: <x^3> of 20,000 grains of
///           uniformity:4 is 2 % off. Checked by tests/sizes/test_sampling.cpp
[[nodiscard]] std::vector<double> sample_radii(const Distribution& sizes, std::size_t count,
                                               std::uint64_t seed, Drawing drawing = Drawing::stratified);

} // namespace granum::sizes
