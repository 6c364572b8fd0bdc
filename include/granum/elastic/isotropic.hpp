// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/vec3.hpp>
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

/// \file
/// Isotropic averages of an anisotropic material over all its orientations, as in a polycrystal of it.
/// Checked by tests/elastic/test_averages.cpp

/// Voigt averages the stiffness (equal strain, an upper bound of K and of G), Reuss the compliance (equal
/// stress, a lower bound), Hill is the mean of the two moduli.                                    [Hill1952]
/// Both moduli are in the order voigt >= hill >= reuss: where the material is isotropic to the last digits,
/// rounding is kept from turning it.
struct IsotropicAverages {
  Isotropic voigt;
  Isotropic hill;
  Isotropic reuss;
};

/// Averages of a full stiffness.
/// \throws   InvalidArgument unless the stiffness is finite, symmetric (stiffness.hpp) and positive definite
///           (smallest eigenvalue above 1e-12 of the largest)
/// Accuracy  voigt 4 ulp of the largest entry, reuss 8 ulp times the condition number.
[[nodiscard]] IsotropicAverages isotropic_averages(const VoigtStiffness& stiffness);

/// Averages of a transversely isotropic stiffness, in closed form.
/// \throws   InvalidArgument unless the stiffness is finite and positive definite
/// Accuracy  voigt 4 ulp of the largest entry, reuss 8 ulp times the condition number.
[[nodiscard]] IsotropicAverages isotropic_averages(const TransverselyIsotropic& stiffness);

/// \file
/// The moduli of a full stiffness along the axes and in their planes, whatever its symmetry.
/// Checked by tests/elastic/test_engineering_moduli.cpp

/// Seven moduli that a test on a cube with its edges along the axes would find [Pa]. Nothing is averaged over
/// directions: a stiffness that is not symmetric about axis 3 shows it.
struct EngineeringModuli {
  double bulk_modulus = 0; ///< K: mean stress over volumetric strain when all three axes are strained alike
  double E_1 = 0;          ///< axial stress over axial strain along axis 1, no other stress changing
  double E_2 = 0;
  double E_3 = 0;
  double C44 = 0; ///< shear stress over engineering shear in the plane 23, no other strain changing
  double C55 = 0; ///< in the plane 13
  double C66 = 0; ///< in the plane 12
};

/// Assumes   a positive semidefinite matrix, but for rounding.
/// \return   E = 0 along an axis where the packing gives way without stress
/// \throws   InvalidArgument for a stiffness that is not symmetric (stiffness.hpp) or not finite
/// Accuracy  1e-14 of the largest entry, E times the condition number of the matrix.
[[nodiscard]] EngineeringModuli engineering_moduli(const VoigtStiffness& stiffness);

/// \file
/// The symmetric material nearest to a given stiffness: its average over the rotations of the symmetry, which
/// is also the orthogonal projection in the Mandel norm. [Moakher2006]
/// A stiffness that is not symmetric (stiffness.hpp) or not finite is refused with InvalidArgument.
/// Accuracy  4 ulp of the largest entry.  Checked by tests/elastic/test_projection.cpp

/// Average over all rotations: K = (sum of the normal 3 x 3 block)/9,
/// G = (C44+C55+C66)/5 + (C11+C22+C33-C12-C13-C23)/15.
/// \throws   InvalidArgument unless both come out positive and finite
[[nodiscard]] Isotropic isotropic_projection(const VoigtStiffness& stiffness);

/// G of the nearest isotropic stiffness [Pa], as above; of any sign.
[[nodiscard]] double projected_shear_modulus(const TransverselyIsotropic& stiffness);

/// Average over the rotations about axis 3.
[[nodiscard]] TransverselyIsotropic transversely_isotropic_projection(const VoigtStiffness& stiffness);

/// Average over the rotations about any axis; index 3 of the result is that axis.
/// \param    axis   any vector but zero; its length and sense do not matter
/// \throws   InvalidArgument for a zero vector or one that is not finite
/// Accuracy  8 ulp of the largest entry.
[[nodiscard]] TransverselyIsotropic transversely_isotropic_projection(const VoigtStiffness& stiffness,
                                                                      const Vec3& axis);

/// Full Voigt matrix [Pa] of a material whose axis of symmetry, index 3 of `stiffness`, points along `axis`.
/// \throws   InvalidArgument for a zero vector or one that is not finite
/// Accuracy  8 ulp of the largest entry.
[[nodiscard]] VoigtStiffness voigt(const TransverselyIsotropic& stiffness, const Vec3& axis);

} // namespace granum::elastic
