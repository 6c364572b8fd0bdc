// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/walls.hpp>

namespace granum::dem {

std::array<WallPlane, wall_count> wall_planes(const Mat3& cell) {
  std::array<WallPlane, wall_count> planes;
  for (int k = 0; k < 3; ++k) {
    const Vec3 across = column(cell, k), u = column(cell, (k + 1) % 3), v = column(cell, (k + 2) % 3);
    const Vec3 face = cross(u, v);
    const double area = norm(face);
    const Vec3 normal = (1 / area) * face;
    const Vec3 centre = 0.5 * (u + v);
    const auto lower = static_cast<std::size_t>(2 * k);
    planes[lower] = {centre, normal, area};
    planes[lower + 1] = {centre + across, -normal, area};
  }
  return planes;
}

Vec3 wall_stress(const WallForces& forces, const std::array<WallPlane, wall_count>& planes) {
  Vec3 stress;
  for (std::size_t w = 0; w < wall_count; ++w)
    stress[static_cast<int>(w / 2)] += dot(forces.force[w], planes[w].normal) / planes[w].area / 2;
  return stress;
}

} // namespace granum::dem
