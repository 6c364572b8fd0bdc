// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `contact_prior_fit coefficients states.csv` from validation/relaxation/states.csv; the test
// "validation: contact_prior" fits them again and compares. Not to be edited by hand.
// clang-format off
#pragma once

#include <array>

namespace granum::effective::kernel {

/// e_d, e_l, bend, squeeze, growth, further growth, mu_0, its power, closing, opening.
/// Standard errors: 0.0012, 0.0048, 0.066, 0.16, 0.2, 0.21, 0.0038, 0.021, 0.36, 0.0018.
inline constexpr std::array<double, 10> contact_coefficients{
    0.57027407, 0.74304176, 1.262954, 4.0605668, 9.3750164,
    1.8655083, 0.21621524, 0.90352895, 13.034544, 0.013260507};
/// c, k, w_r.
/// Standard errors: 0.0046, 0.029, 1.3.
inline constexpr std::array<double, 3> rattler_coefficients{
    0.14508203, 1.2219899, 11.491106};
/// Standard deviations of z* of preparations left out of the fit: of those of the densest line, of
/// those with a friction, of carrying z* to another pressure; and that of ln x_0.
inline constexpr double line_scatter = 0.078039;
inline constexpr double friction_scatter = 0.12205;
inline constexpr double carried_scatter = 0.055197;
inline constexpr double rattler_scatter = 0.27032;

} // namespace granum::effective::kernel
