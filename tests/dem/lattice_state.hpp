// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <granum/dem/specimen.hpp>

namespace granum::test {

inline contact::PowerLaw quartz_sphere(double radius) {
  return contact::PowerLaw::sphere({.shear_modulus = 30e9, .poisson_ratio = 0.15}, radius);
}

inline dem::Material quartz(double radius, double friction) {
  return {.law = quartz_sphere(radius),
          .tangential_ratio = contact::mindlin_stiffness_ratio(0.15),
          .friction_coefficient = friction};
}

/// Face-centred cubic lattice of edges^3 cubic cells, spheres of radius R whose contacts overlap by
/// `overlap`.
inline dem::Specimen fcc(double radius, int edges, double overlap) {
  dem::Specimen state;
  state.radius = radius;
  const double edge = std::sqrt(2.0) * (2 * radius - overlap);
  state.cell = Mat3::diagonal(edges * edge, edges * edge, edges * edge);
  for (int x = 0; x < edges; ++x)
    for (int y = 0; y < edges; ++y)
      for (int z = 0; z < edges; ++z)
        for (const Vec3& site : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}})
          state.position.push_back(edge * (site + Vec3{x + 0.25, y + 0.25, z + 0.25}));
  state.velocity.resize(state.grain_count());
  state.angular_velocity.resize(state.grain_count());
  return state;
}

/// Of most grains of these tests [m].
constexpr double radius = 0.5e-3;

} // namespace granum::test
