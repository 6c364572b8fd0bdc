// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>

namespace granum::fabric {

/// Fabric anisotropy by maximum likelihood.
struct LikelihoodEstimate {
  double anisotropy = 0;          ///< a of E(gamma; a), the most likely one in [-1, 1]
  double standard_error = 0;      ///< of a, from the observed information; infinite if there is none
  double log_likelihood_gain = 0; ///< ln L(a) - ln L(0) >= 0: gain over isotropy
  bool at_boundary = false;       ///< a = -1 or 1 because the likelihood still rises there: the error is then
                                  ///< only a scale, the estimate is not normally distributed
  std::size_t contacts = 0;
  Validity validity; ///< a note at a boundary, or if the directions barely constrain a
};

/// a that makes the sample most likely. In terms of a_c = 4a/(3-a) the log-likelihood, the sum of
/// ln(1 + a_c P2(cos gamma)), is concave: there is one maximum, found by Newton's rule within a bracket.
/// Scatters less than the moment estimate (estimate_anisotropy) the further a is from 0, but leans on
/// E(gamma; a) being the density: test_density of goodness_of_fit.hpp.
/// Assumes   axis 3 is the axis of symmetry, contacts drawn independently. Contacts of a packing exclude one
///           another on a grain, so that they scatter less: the error is on the safe side.
/// \param    normals   one unit vector a contact, either sense; at least 2
/// \throws   InvalidArgument for fewer than 2 normals, or one whose length differs from 1 by more than 1e-6
/// Accuracy  the maximum to 1e-14.  Checked by tests/fabric/test_likelihood_estimate.cpp
[[nodiscard]] LikelihoodEstimate estimate_anisotropy_by_likelihood(std::span<const Vec3> normals);

} // namespace granum::fabric
