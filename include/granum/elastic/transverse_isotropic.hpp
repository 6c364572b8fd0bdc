// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/elastic/stiffness.hpp>

/// Transverse isotropy about axis 3 (vertical, "v"); axes 1 and 2 are horizontal ("h"). Closed forms; the
/// matrix inverse is only a test's business.
/// Checked by tests/elastic/test_transverse_isotropic.cpp
namespace granum::elastic {

/// The five Voigt stiffnesses [Pa]. C66 follows from them.
/// Young's moduli and Poisson's ratios exist for positive definite values only and throw InvalidArgument for
/// others; the remaining members are plain sums, valid for any value.
struct TransverselyIsotropic {
  double C11 = 0; ///< s11 by e11
  double C33 = 0; ///< s33 by e33
  double C12 = 0; ///< s11 by e22
  double C13 = 0; ///< s11 by e33
  double C44 = 0; ///< s23 by 2 e23

  /// s12 by 2 e12 [Pa]: (C11-C12)/2.
  [[nodiscard]] double C66() const { return (C11 - C12) / 2; }
  /// Shear modulus of the horizontal plane [Pa]: C66.
  [[nodiscard]] double G_hh() const { return C66(); }
  /// Shear modulus of a vertical plane [Pa]: C44.
  [[nodiscard]] double G_vh() const { return C44; }
  /// Young's modulus of vertical loading [Pa]: C33 - 2 C13^2/(C11+C12).
  [[nodiscard]] double E_v() const;
  /// Young's modulus of horizontal loading along one axis [Pa].
  [[nodiscard]] double E_h() const;
  /// Vertical loading: -e_h/e_v [1].
  [[nodiscard]] double nu_vh() const;
  /// Horizontal loading: minus vertical strain over the strain along the load [1]; nu_hv/E_h = nu_vh/E_v.
  [[nodiscard]] double nu_hv() const;
  /// Horizontal loading: minus the other horizontal strain over the strain along the load [1].
  [[nodiscard]] double nu_hh() const;
  /// Mean stress by volumetric strain under equal strains [Pa]: (2 C11 + C33 + 2 C12 + 4 C13)/9.
  [[nodiscard]] double bulk_modulus() const { return (2 * C11 + C33 + 2 * C12 + 4 * C13) / 9; }

  /// Strain energy is positive for every strain other than zero.
  [[nodiscard]] bool positive_definite() const;

  bool operator==(const TransverselyIsotropic&) const = default;
};

/// Direction of a load along one axis.
enum class Loading { vertical, horizontal };

/// Young's modulus of any stiffness [Pa]: E_v or E_h, 0 in the limit of vanishing shear stiffness (C44 = C66
/// = 0), empty if no stable material has this stiffness.
[[nodiscard]] std::optional<double> young_modulus(const TransverselyIsotropic& stiffness, Loading loading);

/// The five Voigt compliances [1/Pa]: e11 = S11 s11 + S12 s22 + S13 s33 and so on, 2 e23 = S44 s23.
struct TransverselyIsotropicCompliance {
  double S11 = 0;
  double S33 = 0;
  double S12 = 0;
  double S13 = 0;
  double S44 = 0;

  /// 2 e12 by s12 [1/Pa]: 2 (S11-S12).
  [[nodiscard]] double S66() const { return 2 * (S11 - S12); }

  bool operator==(const TransverselyIsotropicCompliance&) const = default;
};

/// Compliance of a stiffness.
/// \throws   InvalidArgument unless the stiffness is finite and positive definite
/// Accuracy  4 ulp times the condition number.
[[nodiscard]] TransverselyIsotropicCompliance compliance(const TransverselyIsotropic& stiffness);
/// Stiffness of a compliance: the inverse of the above.
/// \throws   InvalidArgument unless the compliance is finite and positive definite
[[nodiscard]] TransverselyIsotropic stiffness(const TransverselyIsotropicCompliance& compliance);

/// The full Voigt matrix [Pa].
[[nodiscard]] VoigtStiffness voigt(const TransverselyIsotropic& stiffness);

} // namespace granum::elastic
