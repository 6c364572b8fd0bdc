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
using BulkCoefficients = std::array<T, 7>;
template <class T>
using StretchCoefficients = std::array<T, 2>;

inline constexpr std::array<double, 8> shear_coefficients{
    0.394886158, 0.0979591203, 4.00190029, 0.182883796, 1.64754254, 2.17691838, 3.93019512, 0.901719668};
inline constexpr double shear_covariance[8][8] = {
    {1.1782e-05, 4.9905e-05, -8.9202e-05, -7.5805e-06, -5.7009e-05, 3.1847e-05, 6.3011e-06, 1.6002e-05},
    {4.9905e-05, 0.0020069, -0.006392, -0.00041097, -0.0031295, 0.001106, 0.00034453, 0.00012863},
    {-8.9202e-05, -0.006392, 0.025906, 0.0024031, 0.0085198, -0.0032835, -0.00069532, -0.00077535},
    {-7.5805e-06, -0.00041097, 0.0024031, 0.00034576, 0.00020573, -8.1758e-05, 2.1679e-05, -0.00011322},
    {-5.7009e-05, -0.0031295, 0.0085198, 0.00020573, 0.0060921, -0.0021356, -0.00071452, -0.00025911},
    {3.1847e-05, 0.001106, -0.0032835, -8.1758e-05, -0.0021356, 0.0010445, 0.00021381, 0.00019533},
    {6.3011e-06, 0.00034453, -0.00069532, 2.1679e-05, -0.00071452, 0.00021381, 0.00010291, -2.9943e-05},
    {1.6002e-05, 0.00012863, -0.00077535, -0.00011322, -0.00025911, 0.00019533, -2.9943e-05, 0.0011367}};
inline constexpr std::array<double, 7> bulk_coefficients{
    0.265292996, 3.46539399, 0.131842133, 3.05092423, 0.00453018283, 0.204114905, 1.98856498};
inline constexpr double bulk_covariance[7][7] = {
    {0.00016416, -0.00049142, -8.4899e-05, 0.00031156, -2.9647e-06, 0.00075212, -0.0009771},
    {-0.00049142, 0.0018804, 0.00016925, -0.00084069, 6.1763e-06, -0.0023669, 0.0046357},
    {-8.4899e-05, 0.00016925, 0.00028848, -0.001279, 7.2992e-07, 0.00051029, -0.0011731},
    {0.00031156, -0.00084069, -0.001279, 0.0062994, 3.5344e-06, -0.003208, 0.0056049},
    {-2.9647e-06, 6.1763e-06, 7.2992e-07, 3.5344e-06, 1.7705e-07, -2.7207e-05, 4.4065e-05},
    {0.00075212, -0.0023669, 0.00051029, -0.003208, -2.7207e-05, 0.019384, -0.033867},
    {-0.0009771, 0.0046357, -0.0011731, 0.0056049, 4.4065e-05, -0.033867, 0.070799}};
/// Relative variance of the forces: at the isostatic point, its decay with z*, and what the relative
/// variance of branches adds to it; its scatter.
inline constexpr std::array<double, 3> force_coefficients{
    0.705118281, 0.398407903, 13.230686};
inline constexpr double force_scatter = 0.159027084;
/// What that takes off the share, and what the variance of branches adds; scatter over b (1 - b).
inline constexpr std::array<double, 2> share_coefficients{
    0.659967698, 1.24120863};
inline constexpr double share_scatter = 0.0862837165;
inline constexpr std::array<double, 2> stretch_coefficients{
    2.15083026, 0.78701326};
inline constexpr double stretch_covariance[2][2] = {
    {0.017882, -0.0076709},
    {-0.0076709, 0.0051696}};

/// Relative scatter about a factor: base, and gain times d ln/dz* (shear) or d ln/d ln r (bulk), in
/// quadrature; of recipes about the curve, and of the packings of one recipe.
struct Scatter {
  double base;
  double gain;
};
inline constexpr Scatter shear_recipes{0.0133055903, 0.0099771903};
inline constexpr Scatter shear_packings{0.0165725217, 0.00923461211};
inline constexpr Scatter bulk_recipes{0.00239704926, 0.26103524};
inline constexpr Scatter bulk_packings{0.0119588824, 0.209036319};
/// Shift of z* in G at the isostatic point and its standard error, over the relative variance of the
/// lengths of branches.
inline constexpr double size_shift = 2.62367043;
inline constexpr double size_shift_error = 0.291816983;
/// What unequal grains lose of K, and its standard error.
inline constexpr double size_loss = 0.345175525;
inline constexpr double size_loss_error = 0.0316561444;
/// What they add to the scatter: of G over the root of that variance, of K over bulk_size_measure.
inline constexpr Scatter shear_sizes{0.0675735789, 0.19192426};
inline constexpr double bulk_sizes = 0.0602257875;
/// Scatter of K between codes: this times the looseness.
inline constexpr double bulk_codes = 0.136406291;
/// Scatter of ln C33/C11 over ln of the stretch.
inline constexpr double stretch_scatter = 0.138279055;
/// Further errors under unequal stresses, over |ln(stress_v/stress_h)|.
inline constexpr double shear_by_stress = 0.0208167397;
inline constexpr double bulk_by_stress = 0.0300479023;

/// z_0, A, q, s, c, k and the scatter of z* of a ClosingGapLaw; in the comments the standard errors.
// 0.0084, 1.7, 0.042, 0.048, 2.6, 0.37
inline constexpr std::array<double, 7> dense_gaps{
    6.01875909, 8.34677761, 0.534731715, -0.419000846, 3.37459987, 2.65634103, 0.0280293872};
// 0.019, 50, 0.038, 0.038, 0.01, 0.085
inline constexpr std::array<double, 7> loose_gaps{
    4.25025277, 192.563323, 0.714124535, 0.772011321, 0.18734024, 1.8496298, 0.037587591};

} // namespace granum::effective::kernel
