// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include <granum/dem/engine.hpp>

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

/// Another vector for each grain, of components up to 1.
inline Vec3 scatter(std::size_t g) {
  const auto phase = static_cast<double>(g);
  return {std::sin(5 * phase), std::sin(3 * phase + 1), std::cos(2 * phase)};
}

/// Velocities and spins: contacts open, close and slide.
inline void set_in_motion(dem::Specimen& state) {
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    const auto phase = static_cast<double>(g);
    state.velocity[g] = 1e-2 * scatter(g);
    state.angular_velocity[g] = 2 * Vec3{std::cos(phase), std::sin(7 * phase), std::cos(4 * phase)};
  }
}

/// Two grains that touch with the given overlap along x.
inline dem::Specimen pair_state(double overlap, const std::vector<double>& size = {}) {
  dem::Specimen state;
  state.radius = radius;
  state.size = size;
  state.cell = Mat3::diagonal(8e-3, 8e-3, 8e-3);
  const double sizes = size.empty() ? 2 : size[0] + size[1];
  state.position = {{4e-3, 4e-3, 4e-3}, {4e-3 + radius * sizes - overlap, 4e-3, 4e-3}};
  state.velocity.resize(2);
  state.angular_velocity.resize(2);
  return state;
}

inline dem::Walls walls(double friction) { return {.friction_coefficient = friction, .history = {}}; }

inline void shear_on(dem::Engine& engine, int steps) {
  for (int k = 0; k < steps; ++k) {
    engine.set_velocity_gradient(4e-6 / engine.time_step() * Mat3::diagonal(1, -1.5, 0.2));
    engine.step();
  }
}

/// Saved and loaded.
inline dem::Engine reloaded(const dem::Engine& engine) {
  ByteWriter bytes;
  engine.save(bytes);
  ByteReader reader(bytes.bytes(), "bytes");
  return dem::Engine::load(reader, engine.material());
}

} // namespace granum::test
