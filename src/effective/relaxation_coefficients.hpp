// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `relaxation_fit coefficients states.csv` from validation/relaxation/states.csv; the test
// "validation: relaxation" fits them again and compares. Not to be edited by hand.
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
    0.373035145, 0.236535767, 3.41807032, 0.108555568, 1.50153098, 1.23562721, 2.40850271, 3.95720986};
inline constexpr double shear_covariance[8][8] = {
    {1.1714e-05, -3.0556e-06, 0.00011678, 2.0388e-05, 4.8348e-05, -1.6855e-05, -6.2848e-05, -9.9942e-07},
    {-3.0556e-06, 0.0017255, -0.0050512, -0.00051122, -0.0023424, -0.00078457, 0.0011604, 0.0001753},
    {0.00011678, -0.0050512, 0.019675, 0.0024613, 0.0068169, 0.0030182, -0.0042869, -0.00023439},
    {2.0388e-05, -0.00051122, 0.0024613, 0.00039907, 0.00053846, 0.00020605, -0.00043938, 9.1529e-06},
    {4.8348e-05, -0.0023424, 0.0068169, 0.00053846, 0.0043186, 0.0010307, -0.0021317, -0.00033143},
    {-1.6855e-05, -0.00078457, 0.0030182, 0.00020605, 0.0010307, 0.0021218, -0.00052388, -3.5731e-05},
    {-6.2848e-05, 0.0011604, -0.0042869, -0.00043938, -0.0021317, -0.00052388, 0.0015806, 0.00011233},
    {-9.9942e-07, 0.0001753, -0.00023439, 9.1529e-06, -0.00033143, -3.5731e-05, 0.00011233, 4.7329e-05}};
inline constexpr std::array<double, 6> bulk_coefficients{
    0.232756283, 3.54076974, 0.172070561, 2.93962972, 0.00490798221, 0.771910798};
inline constexpr double bulk_covariance[6][6] = {
    {6.4757e-05, -0.0002259, -4.3051e-05, 4.6344e-05, -1.8541e-06, 0.0004632},
    {-0.0002259, 0.0024568, -0.00014161, 0.0005782, 8.8093e-07, 0.0030172},
    {-4.3051e-05, -0.00014161, 0.00027443, -0.0009884, 8.2754e-07, -0.00059241},
    {4.6344e-05, 0.0005782, -0.0009884, 0.0044373, 4.8146e-06, 0.00035293},
    {-1.8541e-06, 8.8093e-07, 8.2754e-07, 4.8146e-06, 1.6305e-07, -2.084e-05},
    {0.0004632, 0.0030172, -0.00059241, 0.00035293, -2.084e-05, 0.020829}};
inline constexpr std::array<double, 2> stretch_coefficients{
    2.24485671, 0.644213446};
inline constexpr double stretch_covariance[2][2] = {
    {0.0073914, -0.0020303},
    {-0.0020303, 0.0013054}};

/// Relative scatter of specimens about a factor: base, and gain times d ln/dz* (shear) or d ln/d ln r
/// (bulk), in quadrature; of ln C33/C11 over ln of the stretch.
struct Scatter {
  double base;
  double gain;
};
inline constexpr Scatter shear_scatter{0.0265715032, 0.00688491406};
inline constexpr Scatter bulk_scatter{0.0142401681, 0.260639701};
inline constexpr double stretch_scatter = 0.13517564;
/// Further errors under unequal stresses, over |ln(stress_v/stress_h)|.
inline constexpr double shear_by_stress = 0.0447173518;
inline constexpr double bulk_by_stress = 0.0408911272;

/// z_0, A, q, s, c, k and the scatter of z* of a ClosingGapLaw; in the comments the standard errors.
// 0.01, 1.8, 0.039, 0.054, 3.8, 0.25
inline constexpr std::array<double, 7> dense_gaps{
    6.03461723, 9.42445636, 0.557854885, -0.374389876, 7.45403893, 3.05825334, 0.0235712522};
// 0.03, 72, 0.057, 0.059, 0.0096, 0.1
inline constexpr std::array<double, 7> loose_gaps{
    4.24866557, 179.591677, 0.705165227, 0.778953478, 0.179032393, 1.86940707, 0.0424926297};

} // namespace granum::effective::kernel
