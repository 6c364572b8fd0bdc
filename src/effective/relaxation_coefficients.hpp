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
template <class T>
using UnevennessCoefficients = std::array<T, 7>;
template <class T>
using DenseUnevenness = std::array<T, 5>;

inline constexpr std::array<double, 8> shear_coefficients{
    0.368985207, 0.208283469, 3.48105895, 0.135047061, 1.49166538, 1.09466552, 2.39875522, 3.95375863};
inline constexpr double shear_covariance[8][8] = {
    {3.0913e-05, 9.1261e-05, -0.00011149, -3.0723e-05, 8.2431e-06, -2.026e-05, -6.822e-05, 1.7251e-07},
    {9.1261e-05, 0.0028658, -0.0078217, -0.00097168, -0.0035694, 0.00018966, 0.0017089, 0.00032051},
    {-0.00011149, -0.0078217, 0.028645, 0.0040917, 0.0092779, 6.7356e-05, -0.0058206, -0.00040112},
    {-3.0723e-05, -0.00097168, 0.0040917, 0.00070529, 0.00086717, -8.1274e-05, -0.00059306, 9.812e-06},
    {8.2431e-06, -0.0035694, 0.0092779, 0.00086717, 0.0061526, -0.00054305, -0.0031062, -0.00058997},
    {-2.026e-05, 0.00018966, 6.7356e-05, -8.1274e-05, -0.00054305, 0.0025736, 0.00025563, 3.329e-05},
    {-6.822e-05, 0.0017089, -0.0058206, -0.00059306, -0.0031062, 0.00025563, 0.0024363, 0.00020902},
    {1.7251e-07, 0.00032051, -0.00040112, 9.812e-06, -0.00058997, 3.329e-05, 0.00020902, 9.084e-05}};
inline constexpr std::array<double, 6> bulk_coefficients{
    0.253319417, 3.45765967, 0.171392567, 2.92733103, 0.00484897423, 0.964571974};
inline constexpr double bulk_covariance[6][6] = {
    {6.5591e-05, -0.00015425, -8.2329e-05, 0.0002245, -1.7654e-06, 0.0004134},
    {-0.00015425, 0.0010194, 0.00014982, -0.00069195, 1.4978e-06, 0.0010817},
    {-8.2329e-05, 0.00014982, 0.000303, -0.0010974, 7.7209e-08, -0.00024114},
    {0.0002245, -0.00069195, -0.0010974, 0.0047334, 7.7794e-06, -0.00060418},
    {-1.7654e-06, 1.4978e-06, 7.7209e-08, 7.7794e-06, 1.9249e-07, -1.41e-05},
    {0.0004134, 0.0010817, -0.00024114, -0.00060418, -1.41e-05, 0.012944}};
inline constexpr std::array<double, 2> stretch_coefficients{
    2.14153075, 0.697036906};
inline constexpr double stretch_covariance[2][2] = {
    {0.016959, -0.0067894},
    {-0.0067894, 0.0042958}};

/// Coefficients of gain_by_unevenness, for G and K.
inline constexpr UnevennessCoefficients<double> shear_gain{
    1.0636293, -0.513400736, 0.0276846066, 0.257894239, -0.0758190749, -0.234322375, 0.686724799};
inline constexpr UnevennessCoefficients<double> bulk_gain{
    0.451254761, 0.720841257, 0.00184369864, 0.125684009, -0.0232991673, -0.00289621165, 0.355498935};
/// Coefficients of unevenness_of_dense, and the scatter about it: of equal grains, of others over the
/// root of the relative variance of the lengths of branches.
inline constexpr DenseUnevenness<double> dense_unevenness{
    -0.0410027768, -0.0524417654, -0.259882608, 0.178948819, -0.140170199};
inline constexpr std::array<double, 2> dense_unevenness_scatter{0.00210979624, 0.0295666975};
/// Relative scatter about a factor: base, and gain times d ln/dz* (shear) or d ln/d ln r (bulk), in
/// quadrature; of recipes about the curve, of the packings of one recipe, and what unequal grains add: of
/// G over the root of the relative variance of the lengths of branches, of K over bulk_size_measure.
struct Scatter {
  double base;
  double gain;
};
struct FactorScatter {
  Scatter recipes, packings, sizes;
};
inline constexpr FactorScatter shear_scatter{
    {0.0195759224, 0}, {0.0216562563, 0.00894248575}, {0.0779395464, 0.14738172}};
inline constexpr FactorScatter bulk_scatter{
    {0, 0.178222977}, {0.0130856473, 0.190067984}, {0.163176421, 0}};
/// The same where the unevenness of forces is known.
inline constexpr FactorScatter shear_scatter_known{
    {0.0161273782, 0.00991687376}, {0.0162250687, 0.00682276041}, {0.0283896997, 0.13522943}};
inline constexpr FactorScatter bulk_scatter_known{
    {0.00359545779, 0.189982585}, {0.0046628589, 0.153391259}, {0.0409547777, 0}};
/// Shift of z* in G at the isostatic point and its standard error, over the relative variance of the
/// lengths of branches.
inline constexpr double size_shift = 1.6285264;
inline constexpr double size_shift_error = 0.278480098;
/// What unequal grains lose of K, and its standard error.
inline constexpr double size_loss = 0.596426666;
inline constexpr double size_loss_error = 0.0662060459;
/// Scatter of K between codes: this times the looseness.
inline constexpr double bulk_codes = 0.179925756;
/// Scatter of ln C33/C11 over ln of the stretch.
inline constexpr double stretch_scatter = 0.140960362;
/// Further errors under unequal stresses, over |ln(stress_v/stress_h)|.
inline constexpr double shear_by_stress = 0.0603855213;
inline constexpr double bulk_by_stress = 0.0471801532;

/// Where the packings of the fit end: what G loses by b = 1, and the power of what K loses by the scatter of
/// forces; the further errors of G and K there, over 1 - h. Of power laws, of rough spheres.
inline constexpr std::array<double, 2> power_law_losses{0.0979290879, 1.50143676};
inline constexpr std::array<double, 2> power_law_errors{0.161809716, 0};
inline constexpr std::array<double, 2> rough_losses{0.373358084, 0.582227715};
inline constexpr std::array<double, 2> rough_errors{0.0136988214, 0};

/// z_0, A, q, s, c, k and the scatter of z* of a ClosingGapLaw; in the comments the standard errors.
// 0.0084, 1.7, 0.042, 0.048, 2.6, 0.37
inline constexpr std::array<double, 7> dense_gaps{
    6.01875909, 8.34677761, 0.534731715, -0.419000846, 3.37459987, 2.65634103, 0.0280293872};
// 0.019, 50, 0.038, 0.038, 0.01, 0.085
inline constexpr std::array<double, 7> loose_gaps{
    4.25025277, 192.563323, 0.714124535, 0.772011321, 0.18734024, 1.8496298, 0.037587591};

} // namespace granum::effective::kernel
