// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include <granum/core/error.hpp>
#include <granum/sands/known_sands.hpp>

/// Estimates for a sand from the measurements of many sands: G at small strain, its exponent of stress,
/// Poisson's ratio, anisotropy, and the error of each. Fitted to 789 tests of 38 clean sands [Lo2021] and,
/// for the effect of C_u and the stated factors, to half of the laboratories of a second collection;
/// validation/sands has the errors of the fits.
namespace granum::sands {

/// C_u if none is given.
inline constexpr double uniform_sand = 1.5;
/// Largest C_u of the tested sands. From here on a sand counts as coarse.
inline constexpr double largest_tested_uniformity = 8;
/// Diameter below which grains are silt or clay [m], the share of these up to which a sand is clean, and the
/// share above which the ground is no sand.
inline constexpr double silt_size = 0.063e-3, clean_fines = 0.05, largest_fines = 0.5;
/// Mean stresses of the tests [Pa].
inline constexpr double least_tested_stress = 25e3, largest_tested_stress = 500e3;

/// Known properties of a sand besides its void ratio.
struct Sand {
  std::optional<double> uniformity = {};         ///< C_u = d60/d10 >= 1 [1]
  std::optional<double> d50 = {};                ///< [m]
  std::optional<double> least_void_ratio = {};   ///< e_min [1]
  std::optional<double> largest_void_ratio = {}; ///< e_max > e_min [1]
  std::optional<double> relative_density = {};   ///< D_r, used unless both limits are known [1]
  std::optional<double> fines = {};              ///< share of the mass finer than silt_size [1]
  std::optional<SandTests> tests = {};           ///< tests of this sand
  double level_factor = 1;   ///< G of this ground over the fit, > 0; 1 if not measured [1]
  double exponent_shift = 0; ///< added to s, at every stress
  double poisson_shift = 0;  ///< added to Poisson's ratio, at every stress
  bool quartz = true; ///< grains of quartz or feldspar; shells and the like are softer and scatter more

  bool operator==(const Sand&) const = default;
};

/// Refuses ground that is no sand.
/// \throws   InvalidArgument for a d50 below silt_size, for fines above largest_fines and for C_u outside of
///           1 to 20
/// Checked by tests/sands/test_pooled_law.cpp
void require_sand(const Sand& sand);

/// Known properties of a sand by its name.
[[nodiscard]] Sand sand_of(const KnownSand& known);

/// D_r at a void ratio: between the limits if both are known, else that of the sand, if it is known [1].
[[nodiscard]] std::optional<double> relative_density_of(const Sand& sand, double void_ratio);

/// Refuses a sand that is looser than its loosest state, or far denser than its densest, and a relative
/// density that is not that of the void ratio between known limits.
/// \throws   InvalidArgument as require_void_ratio_limits, for D_r outside of [0, 1.2] or off by more than
///           0.02, and for a void ratio that one known limit excludes
/// Checked by tests/sands/test_pooled_law.cpp
void require_density(const Sand& sand, double void_ratio);

/// The fit that is used: the first in this order, from best to worst, whose inputs are known.
enum class PooledForm {
  own_tests,          ///< level, power and exponent of the sand's own tests
  density_and_limits, ///< 92.7 MPa 10^(0.294 D_r - 0.287 e_min) (p/p_a)^s
  grading,            ///< 36.4 MPa (2.97-e)^2/(1+e) C_u^-0.126 (p/p_a)^s, C_u held at 8
  relative_density,   ///< 69.2 MPa 10^(0.241 D_r) (p/p_a)^s
  void_ratio          ///< 33.6 MPa (2.97-e)^2/(1+e) (p/p_a)^s, of uniform sands
};
[[nodiscard]] PooledForm form_of(const Sand& sand);
/// The formula of form_of() as text, p_a = 100 kPa.
[[nodiscard]] std::string formula(const Sand& sand);

inline constexpr double low_stress = 50e3; ///< p below which sands soften faster [Pa]

/// Exponent s of G ~ p^s and its standard deviation.
struct GrowthExponent {
  double value = 0;
  double deviation = 0;
};
/// Above 50 kPa 0.40 C_u^0.18 (C_u = 1.5 if not known), or the value of the sand's own tests, +- 0.045; below
/// 50 kPa 0.50 +- 0.07, as sands soften faster there.
/// \param    mean_stress   p >= 0 [Pa]
/// Accuracy  of 33 sands: mean residual 0.001, s.d. 0.053, 0.044 without one outlier.
///           Checked by tests/sands/test_pooled_law.cpp
[[nodiscard]] GrowthExponent growth_exponent(const Sand& sand, double mean_stress);

/// G(p) over G(100 kPa), continuous; the same law for an answer, a path and a forecast.
/// \param    mean_stress   p >= 0 [Pa]
[[nodiscard]] double growth_factor(const Sand& sand, double mean_stress);

/// Variance of ln G of a forecast from one mean stress to another of one sand: 0.04^2 for deviations of the
/// sand from one law, plus (deviation of s times ln of the stress ratio)^2, separately below and above 50
/// kPa. The error of the measurement is not included. For pairs of tests at one void ratio, 67 to 78 % lie
/// within the predicted standard deviation and 92 to 97 % within two, by classes of the stress ratio; the two
/// deviations were chosen on these pairs.
/// [validation/sands]
[[nodiscard]] double forecast_variance(const Sand& sand, double from, double to);

/// G of the vertical plane under isotropic stress, from the fit of form_of().
/// \return   [Pa], 0 without stress
/// \throws   InvalidArgument if a member of the sand is out of its range, or the void ratio is not in
///           (0, 2.97), or (0, 2.17) for a sand's own tests, and as require_sand and require_density
/// Accuracy  stated_factor(). Checked by tests/sands/test_pooled_law.cpp
[[nodiscard]] double pooled_shear_modulus(const Sand& sand, double void_ratio, double mean_stress);

/// The same without require_density: for states that are changed by a standard deviation.
/// \throws   InvalidArgument as pooled_shear_modulus, but not for D_r
[[nodiscard]] double extrapolated_shear_modulus(const Sand& sand, double void_ratio, double mean_stress);

/// One standard deviation of G as a factor; two deviations are its square. 1.4 if e is known, 1.45 from D_r
/// alone, 1.35 if e_min and e_max are known; 1.6 with fines, for grains other than quartz and for limits that
/// no tested sand has; 1.9 for gravel and for C_u of 8 and more. The effect of C_u is uncertain by
/// 0.2 ln(C_u/1.5). A sand with tests of its own has 1.15 within their void ratios and stresses, and the
/// factor of other sands far outside. Outside of the stresses and void ratios of all tests the factor grows
/// to 1.9.
/// Accuracy  taken over from a count on half of the laboratories of a second collection, which is not public;
///           in the first collection 97 % of tests lie within. Checked by tests/sands/test_pooled_law.cpp
[[nodiscard]] double stated_factor(const Sand& sand, double void_ratio, double mean_stress);

/// A note on a measured G that differs by more than a factor of 2.5 from sands of the same density and stress
/// (cementation, or an error in a value or unit); else empty.
/// \param    level   measured G over G of the sand, > 0 [1]
/// Checked by tests/sands/test_pooled_law.cpp
[[nodiscard]] std::string level_remark(double level);

/// Notes on the properties of a sand outside of the tests; the results then have a wider range. Stresses
/// below those of the tests occur in every ground: they widen the range without a note.
[[nodiscard]] Validity outside_of_tests(const Sand& sand, double void_ratio, double mean_stress);

/// Poisson's ratio of dry or drained sand at small strain: 0.20 - 0.05 log10(p/100 kPa) +- 0.06 from 10 kPa
/// to 10 MPa, constant beyond, within [0.08, 0.35]; 0.05 more and +- 0.08 for C_u above 3.
/// Young's modulus hardly depends on it, V_p by some 10 %, the bulk modulus by a factor of 1.5.
/// [Domenico1977; own readings of laboratory signals]
struct PoissonRatio {
  double value = 0;
  double deviation = 0;
};
[[nodiscard]] PoissonRatio poisson_ratio(const Sand& sand, double mean_stress);

/// Standard deviation of ln G from test to test of one sand about one law.
inline constexpr double scatter_within_a_sand = 0.04;

/// How the exponent of G_vh is split: m of sigma_h and n of sigma_v over s, +- 0.05; the stress along the
/// third axis has no effect.
inline constexpr double horizontal_share = 0.55, vertical_share = 0.45, share_deviation = 0.05;
/// G_hh over G_vh, and E_h over E_v, under isotropic stress; laboratories differ.
inline constexpr double shear_anisotropy = 1.1, shear_anisotropy_deviation = 0.1;
inline constexpr double young_anisotropy = 1.0, young_anisotropy_deviation = 0.15;

/// Limits of the void ratio of sands that have this C_u.
struct UsualLimits {
  double least = 0;     ///< e_min [1]
  double largest = 0;   ///< e_max [1]
  double deviation = 0; ///< of the void ratio at a relative density, one standard deviation [1]
};
/// e_max = 0.907 - 0.120 ln(C_u/1.5) and e_min = 0.601 - 0.164 ln(C_u/1.5), with C_u held at 8, fitted to
/// half of 38 sands.
/// \param    uniformity   C_u >= 1; 1.5 and a larger deviation if it is not known [1]
/// Accuracy  the other half of the sands: 0.07, root mean square. Checked by tests/sands/test_pooled_law.cpp
[[nodiscard]] UsualLimits usual_limits(const std::optional<double>& uniformity);

} // namespace granum::sands
