// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `relaxation_rolling coefficients rolling.csv` in validation/relaxation; the test "validation:
// relaxation rolling" fits them again and compares. Not to be edited by hand.
// clang-format off
#pragma once

#include <array>

namespace granum::effective::kernel {

template <class T>
using RollingShear = std::array<T, 5>;
template <class T>
using RollingBulk = std::array<T, 3>;

/// Coefficients of rolled_coupling and of left_of_bulk_loss.
inline constexpr RollingShear<double> rolling_shear{
    0.804263983, 0.690808834, 5.41188299, -0.235211983, 4.05699692};
inline constexpr RollingBulk<double> rolling_bulk{
    1.43584081, 0.386774813, 3.89899447};
/// Errors of G and K of packings left out of the fit, over the root of the share of the modulus
/// that rolling resistance makes.
inline constexpr std::array<double, 2> rolling_errors{
    0.0554068257, 0.0508347191};

} // namespace granum::effective::kernel
