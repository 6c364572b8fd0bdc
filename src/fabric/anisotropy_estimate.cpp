// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/anisotropy_estimate.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/fabric/orientation.hpp>

#include "normals.hpp"

namespace granum::fabric {

AnisotropyEstimate estimate_anisotropy(std::span<const Vec3> normals) {
  require_normals(normals, 2);
  const auto count = static_cast<double>(normals.size());
  double sum = 0;
  for (const Vec3& n : normals)
    sum += n.z * n.z;
  const double F33 = std::min(sum / count, 1.0); // lengths may exceed 1 by their rounding
  double squares = 0;
  for (const Vec3& n : normals)
    squares += (n.z * n.z - F33) * (n.z * n.z - F33);
  const double error_of_F33 = std::sqrt(squares / (count - 1) / count);
  const double slope = 40 / ((5 * F33 + 1) * (5 * F33 + 1)); // da/dF33

  AnisotropyEstimate estimate{.anisotropy = anisotropy_from_F33(F33),
                              .standard_error = slope * error_of_F33,
                              .F33 = F33,
                              .contacts = normals.size(),
                              .validity = {}};
  estimate.validity = anisotropy_validity(estimate.anisotropy);
  return estimate;
}

double isotropic_standard_error(std::size_t contacts) {
  if (contacts == 0)
    throw InvalidArgument("number of contacts", 0, "", "[1, inf)");
  return std::sqrt(45.0 / 16 / static_cast<double>(contacts));
}

} // namespace granum::fabric
