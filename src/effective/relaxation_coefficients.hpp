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
    0.372843011, 0.231471728, 3.43338602, 0.109011276, 1.51056783, 1.22329105, 2.39446337, 3.95690625};
inline constexpr double shear_covariance[8][8] = {
    {1.2354e-05, -3.4798e-06, 0.00012306, 2.1232e-05, 5.2088e-05, -1.9033e-05, -6.5108e-05, -1.1864e-06},
    {-3.4798e-06, 0.0017989, -0.0053628, -0.00050914, -0.0025491, -0.0010324, 0.0011977, 0.00018619},
    {0.00012306, -0.0053628, 0.021115, 0.0025304, 0.0075559, 0.0037424, -0.0045694, -0.0002696},
    {2.1232e-05, -0.00050914, 0.0025304, 0.00041034, 0.00053522, 0.00022701, -0.00044201, 1.1183e-05},
    {5.2088e-05, -0.0025491, 0.0075559, 0.00053522, 0.0049492, 0.0014269, -0.0023395, -0.00036756},
    {-1.9033e-05, -0.0010324, 0.0037424, 0.00022701, 0.0014269, 0.0025576, -0.00074149, -6.5112e-05},
    {-6.5108e-05, 0.0011977, -0.0045694, -0.00044201, -0.0023395, -0.00074149, 0.0016257, 0.0001194},
    {-1.1864e-06, 0.00018619, -0.0002696, 1.1183e-05, -0.00036756, -6.5112e-05, 0.0001194, 4.9382e-05}};
inline constexpr std::array<double, 6> bulk_coefficients{
    0.231920843, 3.54150384, 0.169930211, 2.95798152, 0.00501551369, 0.760847391};
inline constexpr double bulk_covariance[6][6] = {
    {7.5799e-05, -0.00023672, -6.0398e-05, 8.9935e-05, -2.2441e-06, 0.00062101},
    {-0.00023672, 0.0025312, -0.00013125, 0.00055848, 1.4129e-06, 0.0029972},
    {-6.0398e-05, -0.00013125, 0.0003221, -0.0011084, 1.4068e-06, -0.00073169},
    {8.9935e-05, 0.00055848, -0.0011084, 0.0047494, 3.3893e-06, 0.00068943},
    {-2.2441e-06, 1.4129e-06, 1.4068e-06, 3.3893e-06, 1.8007e-07, -2.4375e-05},
    {0.00062101, 0.0029972, -0.00073169, 0.00068943, -2.4375e-05, 0.024547}};
inline constexpr std::array<double, 2> stretch_coefficients{
    2.24803714, 0.644051821};
inline constexpr double stretch_covariance[2][2] = {
    {0.0074278, -0.0020993},
    {-0.0020993, 0.0013776}};

/// Relative scatter of specimens about a factor: base, and gain times d ln/dz* (shear) or d ln/d ln r
/// (bulk), in quadrature; of ln C33/C11 over ln of the stretch.
struct Scatter {
  double base;
  double gain;
};
inline constexpr Scatter shear_scatter{0.0267488252, 0.00745327808};
inline constexpr Scatter bulk_scatter{0.0145576296, 0.265856464};
inline constexpr double stretch_scatter = 0.134618592;
/// Further errors under unequal stresses, over |ln(stress_v/stress_h)|.
inline constexpr double shear_by_stress = 0.0470719893;
inline constexpr double bulk_by_stress = 0.0407006751;

/// z_0, A, q, s, c, k and the scatter of z* of a ClosingGapLaw; in the comments the standard errors.
// 0.01, 1.8, 0.039, 0.054, 3.8, 0.25
inline constexpr std::array<double, 7> dense_gaps{
    6.03461723, 9.42445636, 0.557854885, -0.374389876, 7.45403893, 3.05825334, 0.0235712522};
// 0.03, 72, 0.057, 0.059, 0.0096, 0.1
inline constexpr std::array<double, 7> loose_gaps{
    4.24866557, 179.591677, 0.705165227, 0.778953478, 0.179032393, 1.86940707, 0.0424926297};

} // namespace granum::effective::kernel
