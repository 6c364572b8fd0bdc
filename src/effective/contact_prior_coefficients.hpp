// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `contact_prior_fit coefficients states.csv` from validation/relaxation/states.csv; the test
// "validation: contact_prior" fits them again and compares. Not to be edited by hand.
// clang-format off
#pragma once

#include <array>

namespace granum::effective::kernel {

/// e_d, e_l, bend, squeeze, growth, further growth, mu_0, its power, closing, opening.
/// Standard errors: 0.00065, 0.0078, 0.1, 0.1, 0.19, 0.19, 0.0036, 0.017, 0.34, 0.0016.
inline constexpr std::array<double, 10> contact_coefficients{
    0.56844324, 0.74720876, 1.2518939, 3.9615908, 9.2136031,
    1.844, 0.22277573, 0.88366742, 13.457553, 0.014176684};
/// c, k, w_r.
/// Standard errors: 0.0072, 0.035, 1.1.
inline constexpr std::array<double, 3> rattler_coefficients{
    0.14405386, 1.1641672, 11.390889};
/// Standard deviations of z* of preparations left out of the fit: of those of the densest line, of
/// those with a friction, of carrying z* to another pressure, over root_of_way; and that of ln x_0.
inline constexpr double line_scatter = 0.10054;
inline constexpr double friction_scatter = 0.099651;
inline constexpr double carried_scatter = 0.444;
inline constexpr double rattler_scatter = 0.2622;

} // namespace granum::effective::kernel
