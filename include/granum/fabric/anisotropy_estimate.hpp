// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>

namespace granum::fabric {

/// Fabric anisotropy measured on a sample of contact normals.
struct AnisotropyEstimate {
  double anisotropy = 0;     ///< a of E(gamma; a), never clipped
  double standard_error = 0; ///< of a, for contacts drawn independently
  double F33 = 0;            ///< mean of n3^2
  std::size_t contacts = 0;
  Validity validity; ///< a note if |a| > 1
};

/// a of E(gamma; a) from the mean of n3^2, with da/dF33 times its standard error from the scatter of n3^2.
/// Assumes   axis 3 is the axis of symmetry. Contacts of a packing exclude one another on a grain, so that
///           they scatter less than independent ones: the error is on the safe side.
/// \param    normals   one unit vector a contact, either sense; at least 2
/// \throws   InvalidArgument for fewer than 2 normals, or one whose length differs from 1 by more than 1e-6
/// Accuracy  absolute 1e-15 sqrt(contacts).  Checked by tests/fabric/test_anisotropy_estimate.cpp
[[nodiscard]] AnisotropyEstimate estimate_anisotropy(std::span<const Vec3> normals);

/// Standard error of a for independent contacts of isotropic directions, sqrt(45/16)/sqrt(contacts): the
/// measure of what still counts as isotropic.
/// \param    contacts   N_c > 0
/// \throws   InvalidArgument for no contacts
/// Accuracy  2 ulp.  Checked by tests/fabric/test_anisotropy_estimate.cpp
[[nodiscard]] double isotropic_standard_error(std::size_t contacts);

} // namespace granum::fabric
