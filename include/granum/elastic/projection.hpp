// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/vec3.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// The symmetric material nearest to a given stiffness: its average over the rotations of the symmetry, which
/// is also the orthogonal projection in the Mandel norm. [Moakher2006]
/// A stiffness that is not symmetric (mandel.hpp) or not finite is refused with InvalidArgument.
/// Accuracy  4 ulp of the largest entry.  Checked by tests/elastic/test_projection.cpp
namespace granum::elastic {

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
