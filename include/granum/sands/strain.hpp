// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <granum/sands/pooled_law.hpp>

/// Effect of shear strain on a sand: G over G at small strain and damping, and published laws beside them.
namespace granum::sands {

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
/// Where a law needs C_u or D_r and the sand has none, C_u is 1.5, and D_r that of the void ratio between
/// usual limits. [WangStokoe2022; Darendeli2001; Menq2003; IshibashiZhang1993; OztoprakBolton2013]
[[nodiscard]] std::span<const StrainLaw> strain_laws();

/// By how many standard deviations each part of the law of strain is moved from its middle.
struct StrainMoves {
  double reference_strain = 0; ///< the strain at G/G0 = 1/2, a factor of 1.6 each, and G/G0, 0.01 each
  double least_damping = 0;    ///< D at small strain, a factor of 1.6 each
  double damping_growth = 0;   ///< growth of D with the loss of G, a factor of 1.3 each
};

/// G over G at small strain, and damping.
struct StrainAnswer {
  double ratio = 1;   ///< G/G0 in [0, 1]
  double damping = 0; ///< damping ratio, 0.01 for 1 % [1]
  Validity validity;  ///< notes beyond 1 %, and if cycles compact the sand
};
/// G/G0 = 1/(1 + (g/g_r)^0.81), g_r = 0.062 % C_u^-0.3 (p/p_a)^0.37, fitted to half of the laboratories of
/// 240 measured curves; C_u is 1.5 where it is not known. Void ratio, relative density and d50 were found to
/// change nothing. D = 0.8 % (p/p_a)^-0.15 + 19.5 % (1 - G/G0)^1.22 is a centre of ten published laws.
/// \throws   InvalidArgument unless 0 < strain <= 0.05, and as extrapolated_shear_modulus
/// Accuracy  root mean square 0.06 of G/G0 in the fitted half, 73 % of it within one deviation and 95 %
///           within two. Checked by tests/sands/test_strain.cpp
[[nodiscard]] StrainAnswer strained(const StrainedSand& sand, const StrainMoves& moves = {});

/// Friction coefficient of quartz grains, used for slip at contacts.
inline constexpr double grain_friction = 0.5;

/// Below this strain a modulus equals the small-strain modulus within 5 %.
inline constexpr double small_strain = 1e-5;

} // namespace granum::sands
