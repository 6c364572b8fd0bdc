// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `relaxation_fit coefficients` in validation/relaxation, whose README says from which files; the
// test "validation: relaxation" fits them again and compares. Not to be edited by hand.
// clang-format off
#pragma once

#include <array>

namespace granum::effective::kernel {

template <class T>
using ShearCoefficients = std::array<T, 8>;
template <class T>
using BulkCoefficients = std::array<T, 6>;
template <class T>
using StretchCoefficients = std::array<T, 2>;

inline constexpr std::array<double, 8> shear_coefficients{
    0.3672767, 0.243494499, 3.47584074, 0.136017104, 1.44804889, 1.14019579, 2.4018506, 3.96651821};
inline constexpr double shear_covariance[8][8] = {
    {3.3405e-05, 8.1586e-05, -5.57e-05, -2.2483e-05, 3.43e-05, -2.7977e-05, -8.1623e-05, -1.8388e-06},
    {8.1586e-05, 0.0036472, -0.010998, -0.0012527, -0.0042693, -0.001564, 0.0022956, 0.00023325},
    {-5.57e-05, -0.010998, 0.039169, 0.0049336, 0.012779, 0.0055843, -0.0079379, -0.00045817},
    {-2.2483e-05, -0.0012527, 0.0049336, 0.0007865, 0.0011663, 0.00028604, -0.00078945, -9.1284e-06},
    {3.43e-05, -0.0042693, 0.012779, 0.0011663, 0.0066684, 0.0017084, -0.0037208, -0.00041335},
    {-2.7977e-05, -0.001564, 0.0055843, 0.00028604, 0.0017084, 0.0050959, -0.00077824, -7.1618e-05},
    {-8.1623e-05, 0.0022956, -0.0079379, -0.00078945, -0.0037208, -0.00077824, 0.0028321, 0.00018831},
    {-1.8388e-06, 0.00023325, -0.00045817, -9.1284e-06, -0.00041335, -7.1618e-05, 0.00018831, 3.8881e-05}};
inline constexpr std::array<double, 6> bulk_coefficients{
    0.24635774, 3.49603438, 0.165955543, 2.94908803, 0.00486451851, 0.921615252};
inline constexpr double bulk_covariance[6][6] = {
    {8.2286e-05, -0.00026647, -7.9732e-05, 0.00018261, -2.1246e-06, 0.00047316},
    {-0.00026647, 0.0022422, 1.57e-05, -6.6466e-05, 6.6825e-07, 0.0021034},
    {-7.9732e-05, 1.57e-05, 0.00031066, -0.001128, 8.8451e-07, -0.00060309},
    {0.00018261, -6.6466e-05, -0.001128, 0.0049641, 6.4543e-06, 0.00036724},
    {-2.1246e-06, 6.6825e-07, 8.8451e-07, 6.4543e-06, 2.5171e-07, -2.0162e-05},
    {0.00047316, 0.0021034, -0.00060309, 0.00036724, -2.0162e-05, 0.017504}};
inline constexpr std::array<double, 2> stretch_coefficients{
    2.25066901, 0.663096326};
inline constexpr double stretch_covariance[2][2] = {
    {0.0083441, -0.002787},
    {-0.002787, 0.0021533}};

/// Relative scatter about a factor: base, and gain times d ln/dz* (shear) or d ln/d ln r (bulk), in
/// quadrature; of recipes about the curve, and of the packings of one recipe.
struct Scatter {
  double base;
  double gain;
};
inline constexpr Scatter shear_recipes{0.0189100323, 0.00569109521};
inline constexpr Scatter shear_packings{0.0222611579, 0.0081302599};
inline constexpr Scatter bulk_recipes{0, 0.185159964};
inline constexpr Scatter bulk_packings{0.0131222741, 0.193066505};
/// Shift of z* in G at the isostatic point and its standard error, over the relative variance of the
/// lengths of branches.
inline constexpr double size_shift = 1.58222691;
inline constexpr double size_shift_error = 0.202457619;
/// What unequal grains lose of K, and its standard error.
inline constexpr double size_loss = 0.559645464;
inline constexpr double size_loss_error = 0.0521487593;
/// What they add to the scatter: of G over the root of that variance, of K over bulk_size_measure.
inline constexpr Scatter shear_sizes{0.0791708164, 0.143617664};
inline constexpr double bulk_sizes = 0.153525038;
/// Scatter of K between codes: this times the looseness.
inline constexpr double bulk_codes = 0.181222182;
/// Scatter of ln C33/C11 over ln of the stretch.
inline constexpr double stretch_scatter = 0.136071463;
/// Further errors under unequal stresses, over |ln(stress_v/stress_h)|.
inline constexpr double shear_by_stress = 0.0527703676;
inline constexpr double bulk_by_stress = 0.0432989516;

/// z_0, A, q, s, c, k and the scatter of z* of a ClosingGapLaw; in the comments the standard errors.
// 0.01, 1.8, 0.039, 0.054, 3.8, 0.25
inline constexpr std::array<double, 7> dense_gaps{
    6.03461723, 9.42445637, 0.557854885, -0.374389876, 7.45403893, 3.05825334, 0.0235712522};
// 0.03, 72, 0.057, 0.059, 0.0096, 0.1
inline constexpr std::array<double, 7> loose_gaps{
    4.24866557, 179.591677, 0.705165227, 0.778953478, 0.179032393, 1.86940707, 0.0424926297};

} // namespace granum::effective::kernel
