// SPDX-License-Identifier: GPL-3.0-or-later
// Assemblies that the tests of `assembly` and `network` share.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <granum/packing/assembly.hpp>

namespace granum::samples {

/// Same numbers on every machine, unlike the distributions of the standard library.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : bits_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  Vec3 vector(double size) {
    Vec3 v;
    for (int k = 0; k < 3; ++k)
      v[k] = (*this)(-size, size);
    return v;
  }

 private:
  std::mt19937_64 bits_;
};

/// Joins every pair of grains, images included, that is closer than reach times the sum of its radii.
inline void connect(packing::Assembly& a, double reach) {
  for (std::uint32_t i = 0; i < a.grain_count(); ++i)
    for (std::uint32_t j = i + 1; j < a.grain_count(); ++j)
      for (int p = -1; p <= 1; ++p)
        for (int q = -1; q <= 1; ++q)
          for (int r = -1; r <= 1; ++r) {
            const Vec3 image{static_cast<double>(p), static_cast<double>(q), static_cast<double>(r)};
            const Vec3 branch = a.position[j] - a.position[i] + a.cell * image;
            const double sum = a.radius[i] + a.radius[j];
            if (norm(branch) < reach * sum)
              a.contacts.push_back(
                  {.i = i, .j = j, .branch = branch, .overlap = sum - norm(branch), .tangential_force = {}});
          }
}

struct Lattice {
  Vec3 edges;              ///< of the conventional cell, in diameters
  std::vector<Vec3> sites; ///< fractions of the edges
};

inline const Lattice simple_cubic{{1, 1, 1}, {{0, 0, 0}}};
inline const Lattice body_centred{{2 / std::sqrt(3), 2 / std::sqrt(3), 2 / std::sqrt(3)},
                                  {{0, 0, 0}, {0.5, 0.5, 0.5}}};
inline const Lattice face_centred{{std::sqrt(2), std::sqrt(2), std::sqrt(2)},
                                  {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}};
inline const Lattice hexagonal{{1, std::sqrt(3), std::sqrt(8.0 / 3)},
                               {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 5.0 / 6, 0.5}, {0, 1.0 / 3, 0.5}}};

struct LatticeState {
  double radius = 0.5;
  double normal_force = 0;
  double normal_stiffness = 1;
  double tangential_stiffness = 0;
  int repeats = 3; ///< >= 2: then no grain meets its own image
};

inline packing::Assembly lattice(const Lattice& kind, const LatticeState& state) {
  packing::Assembly a;
  const Vec3 edges = 2 * state.radius * kind.edges;
  for (int k = 0; k < 3; ++k)
    a.cell(k, k) = state.repeats * edges[k];
  for (int p = 0; p < state.repeats; ++p)
    for (int q = 0; q < state.repeats; ++q)
      for (int r = 0; r < state.repeats; ++r)
        for (const Vec3& s : kind.sites) {
          a.position.push_back({(p + s.x) * edges.x, (q + s.y) * edges.y, (r + s.z) * edges.z});
          a.radius.push_back(state.radius);
        }
  connect(a, 1 + 1e-6);
  for (packing::Contact& c : a.contacts) {
    c.normal_force = state.normal_force;
    c.normal_stiffness = state.normal_stiffness;
    c.tangential_stiffness = state.tangential_stiffness;
  }
  return a;
}

struct RandomState {
  std::uint64_t seed = 1;
  int repeats = 3;             ///< face-centred cells along each edge before the disorder
  double kept = 1;             ///< share of the contacts that are kept
  double tangential_ratio = 1; ///< largest k_t/k_n
};

/// A disordered network in a skewed cell: unequal radii, unequal stiffnesses, grains and clusters of every
/// degree of freedom once few contacts are kept. Its forces are arbitrary, not in equilibrium.
inline packing::Assembly random_network(const RandomState& state) {
  Uniform uniform(state.seed);
  packing::Assembly a = lattice(face_centred, {.repeats = state.repeats});
  const Mat3 skew{{{1.1, 0.1, -0.05}, {0, 0.95, 0.2}, {0.03, 0, 1}}};
  a.cell = skew * a.cell;
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    a.position[g] = skew * a.position[g] + uniform.vector(0.12);
    a.radius[g] = uniform(0.35, 0.6);
  }
  a.contacts.clear();
  connect(a, 1.25);
  std::vector<packing::Contact> kept;
  for (packing::Contact& c : a.contacts) {
    c.normal_stiffness = uniform(0.5, 2);
    c.tangential_stiffness = state.tangential_ratio * uniform(0.2, 1) * c.normal_stiffness;
    c.normal_force = uniform(0, 1e-3);
    const Vec3 push = uniform.vector(1e-4);
    c.tangential_force = push - dot(push, normal(c)) * normal(c);
    if (uniform(0, 1) < state.kept)
      kept.push_back(c);
  }
  a.contacts = kept;
  return a;
}

} // namespace granum::samples
