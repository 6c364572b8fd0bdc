// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <granum/sands/pooled_law.hpp>

/// What shear strain does to a sand: published laws of G over G at small strain.
namespace granum::sands {

/// A sand under shear.
struct StrainedSand {
  double strain = 0;      ///< amplitude of the shear strain, > 0, 0.01 % is 1e-4 [1]
  double void_ratio = 0;  ///< e > 0 [1]
  double mean_stress = 0; ///< p > 0 [Pa]
  Sand sand = {};
};

/// A published law of clean sand. Its constants are those that public codes carry; nobody checked them
/// against the printed pages.
struct StrainLaw {
  const char* key;
  const char* source; ///< entry of validation/references.bib
  const char* formula;
  double (*ratio)(const StrainedSand& sand) = nullptr; ///< G/G0, unchecked
};
/// [WangStokoe2022; Darendeli2001; Menq2003; IshibashiZhang1993]
[[nodiscard]] std::span<const StrainLaw> strain_laws();

/// G over G at small strain, and the damping that goes with it.
struct StrainAnswer {
  double ratio = 1;         ///< G/G0 by Wang and Stokoe, of e and C_u where that is known [1]
  double log_deviation = 0; ///< one standard deviation of ln(G/G0): the larger of a factor of 1.13 and the
                            ///< spread between the laws, but no more than the whole loss [1]
  double damping = 0;       ///< ratio of the critical one, by Ishibashi and Zhang from G/G0 [1]
  Validity validity;        ///< notes beyond 0.5 %, and where cycles compact the sand
};
/// \throws   InvalidArgument unless 0 < strain <= 0.05, and as pooled_shear_modulus
/// Accuracy  within 0.04 of the median of eight curves from 0.001 % to 0.1 %, 50 to 400 kPa.
///           Checked by tests/sands/test_strain.cpp
[[nodiscard]] StrainAnswer strained(const StrainedSand& sand);

/// Damping ratio of a sand whose G is a share `ratio` of that at small strain, 0.333 (0.586 r^2 - 1.547 r +
/// 1).
/// [IshibashiZhang1993]
[[nodiscard]] double damping_ratio(double ratio);

/// Friction coefficient of quartz grains, where slip at contacts is asked for.
inline constexpr double grain_friction = 0.5;

/// Below this strain a modulus is that of small strain to 5 %.
inline constexpr double small_strain = 1e-5;

} // namespace granum::sands
