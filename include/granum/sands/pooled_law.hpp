// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include <granum/core/error.hpp>
#include <granum/sands/known_sands.hpp>

/// Estimates for a sand from the measurements of many sands: G at small strain, its exponent of stress,
/// Poisson's ratio, anisotropy, and the error of each. Fitted to 789 tests of 38 clean sands [Lo2021];
/// validation/sands repeats the errors of the fits, including those for sands left out of the fit.
namespace granum::sands {

/// C_u if none is given.
inline constexpr double uniform_sand = 1.5;
/// Largest C_u of the tested sands.
inline constexpr double largest_tested_uniformity = 8;
/// Mean stresses of the tests [Pa].
inline constexpr double least_tested_stress = 25e3, largest_tested_stress = 500e3;

/// Known properties of a sand besides its void ratio.
struct Sand {
  std::optional<double> uniformity = {};         ///< C_u = d60/d10 >= 1 [1]
  std::optional<double> d50 = {};                ///< [m]
  std::optional<double> least_void_ratio = {};   ///< e_min [1]
  std::optional<double> largest_void_ratio = {}; ///< e_max > e_min [1]
  std::optional<double> relative_density = {};   ///< D_r, used unless both limits are known [1]
  std::optional<SandTests> tests = {};           ///< tests of this sand
  double level_factor = 1;   ///< G of this ground over the fit, > 0; 1 if not measured [1]
  double exponent_shift = 0; ///< added to s, at every stress
  double poisson_shift = 0;  ///< added to Poisson's ratio, at every stress
  bool quartz = true; ///< grains of quartz or feldspar; shells and the like are softer and scatter more

  bool operator==(const Sand&) const = default;
};

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
  grading,            ///< 39.4 MPa (2.97-e)^2/(1+e) C_u^-0.252 (p/p_a)^s
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
/// Above 50 kPa 0.40 C_u^0.18 (C_u = 1.5 if not known), or the value of the sand's own tests, +- 0.05; below
/// 50 kPa 0.50 +- 0.07, as sands soften faster there.
/// \param    mean_stress   p >= 0 [Pa]
/// Accuracy  of 33 sands: mean residual 0.001, s.d. 0.053. Checked by tests/sands/test_pooled_law.cpp
[[nodiscard]] GrowthExponent growth_exponent(const Sand& sand, double mean_stress);

/// G(p) over G(100 kPa), continuous; the same law for an answer, a path and a forecast.
/// \param    mean_stress   p >= 0 [Pa]
[[nodiscard]] double growth_factor(const Sand& sand, double mean_stress);

/// Variance of ln G of a forecast from one mean stress to another of one sand: 0.05^2 for deviations of the
/// sand from one law, plus (deviation of s times ln of the stress ratio)^2, separately below and above 50
/// kPa. The error of the measurement is not included. For pairs of tests at one void ratio, the root mean
/// square error is 0.9 to 1.3 times the predicted standard deviation.
/// [validation/sands]
[[nodiscard]] double forecast_variance(const Sand& sand, double from, double to);

/// G of the vertical plane under isotropic stress, from the fit of form_of().
/// \return   [Pa], 0 without stress
/// \throws   InvalidArgument if a member of the sand is out of its range, or the void ratio is not in
///           (0, 2.97), or (0, 2.17) for a sand's own tests, and as require_density
/// Accuracy  stated_factor(). Checked by tests/sands/test_pooled_law.cpp
[[nodiscard]] double pooled_shear_modulus(const Sand& sand, double void_ratio, double mean_stress);

/// The same without require_density: for states that are changed by a standard deviation.
/// \throws   InvalidArgument as pooled_shear_modulus, but not for D_r
[[nodiscard]] double extrapolated_shear_modulus(const Sand& sand, double void_ratio, double mean_stress);

/// One standard deviation of G as a factor: 1.15 for a sand with tests of its own, 1.25 if e_min and e_max
/// are known, 1.3 for any clean quartz sand, 1.6 for other ground (C_u above 8, gravel, shells); larger
/// outside of the tested stresses and void ratios, and outside of e_min to e_max, at most 1.6.
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
inline constexpr double scatter_within_a_sand = 0.05;

/// How the exponent of G_vh is split: m of sigma_h and n of sigma_v over s, +- 0.05; the stress along the
/// third axis has no effect.
inline constexpr double horizontal_share = 0.55, vertical_share = 0.45, share_deviation = 0.05;
/// G_hh over G_vh, and E_h over E_v, under isotropic stress; laboratories differ.
inline constexpr double shear_anisotropy = 1.1, shear_anisotropy_deviation = 0.1;
inline constexpr double young_anisotropy = 1.0, young_anisotropy_deviation = 0.15;

/// The void ratio at a relative density if no limits are known: from the mean limits of the tested sands,
/// e_max
/// 0.91 and e_min 0.58, with a standard deviation of 0.11.
inline constexpr double usual_least_void_ratio = 0.58, usual_largest_void_ratio = 0.91,
                        usual_void_ratio_deviation = 0.11;

/// \file
/// Effect of shear strain on a sand: published laws of G over G at small strain.

/// A sand under shear.
struct StrainedSand {
  double strain = 0;      ///< amplitude of the shear strain, > 0, 0.01 % is 1e-4 [1]
  double void_ratio = 0;  ///< e > 0 [1]
  double mean_stress = 0; ///< p > 0 [Pa]
  Sand sand = {};
};

/// A published law of clean sand. Its constants are taken from public codes; they were not checked against
/// the printed pages.
struct StrainLaw {
  const char* key;
  const char* source; ///< entry of validation/references.bib
  const char* formula;
  double (*ratio)(const StrainedSand& sand) = nullptr; ///< G/G0, unchecked
};
/// [WangStokoe2022; Darendeli2001; Menq2003; IshibashiZhang1993]
[[nodiscard]] std::span<const StrainLaw> strain_laws();

/// G over G at small strain, and the corresponding damping.
struct StrainAnswer {
  double ratio = 1;         ///< G/G0 by Wang and Stokoe, from e and, if known, C_u [1]
  double log_deviation = 0; ///< one standard deviation of ln(G/G0): the larger of a factor of 1.13 and the
                            ///< spread between the laws, but no more than the whole loss [1]
  double damping = 0;       ///< damping ratio, by Ishibashi and Zhang from G/G0 [1]
  Validity validity;        ///< notes beyond 0.5 %, and if cycles compact the sand
};
/// \throws   InvalidArgument unless 0 < strain <= 0.05, and as pooled_shear_modulus
/// Accuracy  within 0.04 of the median of eight curves from 0.001 % to 0.1 %, 50 to 400 kPa.
///           Checked by tests/sands/test_strain.cpp
[[nodiscard]] StrainAnswer strained(const StrainedSand& sand);

/// Damping ratio at G/G0 = `ratio`, 0.333 (0.586 r^2 - 1.547 r + 1).
/// [IshibashiZhang1993]
[[nodiscard]] double damping_ratio(double ratio);

/// Friction coefficient of quartz grains, used for slip at contacts.
inline constexpr double grain_friction = 0.5;

/// Below this strain a modulus equals the small-strain modulus within 5 %.
inline constexpr double small_strain = 1e-5;

} // namespace granum::sands
