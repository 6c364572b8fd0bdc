// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/anisotropy_estimate.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/error.hpp>
#include <granum/fabric/orientation.hpp>

namespace granum::fabric {

namespace {

void require_unit_normals(std::span<const Vec3> normals) {
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (const double length = norm(normals[i]); !(std::abs(length - 1) <= 1e-6))
      throw InvalidArgument("length of contact normal " + std::to_string(i), length, "", "1 +- 1e-6");
}

} // namespace

AnisotropyEstimate estimate_anisotropy(std::span<const Vec3> normals) {
  if (normals.size() < 2)
    throw InvalidArgument("number of contact normals", static_cast<double>(normals.size()), "", "[2, inf)");
  require_unit_normals(normals);
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
