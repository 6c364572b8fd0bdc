// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `contact_prior_fit coefficients states.csv unequal.csv codes.csv` from validation/relaxation;
// the test "validation: contact_prior" fits them again and compares. Not to be edited by hand.
// clang-format off
#pragma once

#include <array>

namespace granum::effective::kernel {

/// e_d, e_l, bend, squeeze, growth, further growth, mu_0, its power, closing, opening.
/// Standard errors: 0.00058, 0.008, 0.11, 0.095, 0.2, 0.2, 0.0036, 0.017, 0.37, 0.0014.
inline constexpr std::array<double, 10> contact_coefficients{
    0.56912606, 0.74770931, 1.2655064, 3.9345848, 9.2305765,
    1.8528286, 0.21784131, 0.89014835, 12.749331, 0.0099145841};
/// c, k, w_r.
/// Standard errors: 0.0072, 0.035, 1.1.
inline constexpr std::array<double, 3> rattler_coefficients{
    0.14405386, 1.1641672, 11.390889};
/// Standard deviations of z* of preparations left out of the fit: of those of the densest line, of
/// those with a friction, of carrying z* to another pressure, over root_of_way; and that of ln x_0.
inline constexpr double line_scatter = 0.10204;
inline constexpr double friction_scatter = 0.1025;
inline constexpr double carried_scatter = 0.44329;
inline constexpr double rattler_scatter = 0.2622;
/// What shift_by_grains takes, and of packings above the densest one of the same grains the standard
/// deviations of z*: of preparations left out; of sizes left out, over the root of the variance of
/// branches; between codes. Standard errors of the shift: 0.013, 0.034, 0.1.
inline constexpr std::array<double, 3> grain_shift{0.060282, -0.14136, -0.44022};
inline constexpr double above_densest_scatter = 0.088141;
inline constexpr double above_densest_size_scatter = 0.33847;
inline constexpr double above_densest_code_scatter = 0.11141;

} // namespace granum::effective::kernel
