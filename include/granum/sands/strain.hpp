// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <granum/sands/pooled_law.hpp>

/// Effect of shear strain on a sand: published laws of G over G at small strain.
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
