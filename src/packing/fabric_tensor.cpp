// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/fabric_tensor.hpp>

#include <granum/core/error.hpp>

namespace granum::packing {

std::vector<Vec3> contact_normals(const Assembly& assembly) {
  require_valid(assembly);
  std::vector<Vec3> normals;
  normals.reserve(assembly.contacts.size());
  for (const Contact& c : assembly.contacts)
    normals.push_back(normal(c));
  return normals;
}

Mat3 fabric_tensor(const Assembly& assembly) { return fabric_tensor(contact_normals(assembly)); }

Mat3 fabric_tensor(std::span<const Vec3> normals) {
  if (normals.empty())
    throw InvalidArgument("fabric_tensor: the assembly has no contacts");
  const auto count = static_cast<double>(normals.size());
  Mat3 mean;
  for (const Vec3& n : normals)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        mean(i, j) += n[i] * n[j] / count;
  return mean;
}

} // namespace granum::packing
