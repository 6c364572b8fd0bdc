// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// Isotropic elasticity and its engineering constants.
/// Checked by tests/elastic/test_isotropic.cpp
namespace granum::elastic {

/// An isotropic elastic solid, given by bulk and shear modulus: 0 < K <= inf, 0 < G < inf. K = inf is the
/// incompressible limit nu = 0.5; every accessor but voigt() has its limit there.
/// Accuracy  4 ulp, and nu to
/// 4 ulp of 1.
class Isotropic {
 public:
  /// \throws   InvalidArgument unless both are positive, shear_modulus finite [Pa]
  static Isotropic from_bulk_and_shear(double bulk_modulus, double shear_modulus);
  /// \throws   InvalidArgument unless young_modulus > 0 [Pa] and -1 < poisson_ratio <= 0.5
  static Isotropic from_young_and_poisson(double young_modulus, double poisson_ratio);
  /// \throws   InvalidArgument unless shear_modulus > 0 [Pa] and -1 < poisson_ratio <= 0.5
  static Isotropic from_shear_and_poisson(double shear_modulus, double poisson_ratio);
  /// \throws   InvalidArgument unless shear_modulus > 0 and lame_lambda > -2/3 shear_modulus [Pa]
  static Isotropic from_lame(double lame_lambda, double shear_modulus);

  /// K [Pa].
  [[nodiscard]] double bulk_modulus() const { return bulk_modulus_; }
  /// G [Pa].
  [[nodiscard]] double shear_modulus() const { return shear_modulus_; }
  /// E = 9KG/(3K+G) [Pa].
  [[nodiscard]] double young_modulus() const;
  /// nu = (3K-2G)/(2(3K+G)) [1], in (-1, 0.5].
  [[nodiscard]] double poisson_ratio() const;
  /// lambda = K - 2G/3 [Pa].
  [[nodiscard]] double lame_lambda() const { return bulk_modulus_ - 2 * shear_modulus_ / 3; }

 private:
  Isotropic(double bulk_modulus, double shear_modulus)
      : bulk_modulus_(bulk_modulus), shear_modulus_(shear_modulus) {}

  double bulk_modulus_;
  double shear_modulus_;
};

/// The same solid as a transversely isotropic one.
/// \throws   InvalidArgument for the incompressible limit
[[nodiscard]] TransverselyIsotropic transversely_isotropic(const Isotropic& solid);
/// The full Voigt matrix [Pa].
/// \throws   InvalidArgument for the incompressible limit
[[nodiscard]] VoigtStiffness voigt(const Isotropic& solid);

} // namespace granum::elastic
