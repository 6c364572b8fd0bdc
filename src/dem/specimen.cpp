// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/specimen.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <variant>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>
#include <granum/dem/neighbours.hpp>

#include "dem/sweep/verlet_list.hpp"
#include "dem/sweep/wall_contacts.hpp"

namespace granum::dem {

namespace {

/// Whether the contact is at the Coulomb limit, up to rounding.
bool at_limit(const Vec3& tangential_force, double limit) {
  return norm(tangential_force) >= (1 - 1e-9) * limit;
}

double size_of(const Specimen& state, std::size_t grain) {
  return state.size.empty() ? 1 : state.size[grain];
}

/// Of two grains at an overlap.
contact::NormalResponse pair_response(const contact::NormalKernel& kernel, const Specimen& state,
                                      std::size_t i, std::size_t j, double overlap) {
  return std::visit(
      [&](const auto& law) { return contact::of_sizes(law, size_of(state, i), size_of(state, j))(overlap); },
      kernel);
}

std::vector<packing::Contact> wall_contacts(const Specimen& state, const Material& material) {
  const std::array<WallPlane, wall_count> planes = wall_planes(state.cell);
  const contact::NormalKernel kernel = material.law.kernel();
  const bool rough = state.walls->friction_coefficient > 0;
  std::vector<packing::Contact> contacts;
  auto memory = state.walls->history.begin();
  for (std::uint32_t g = 0; g < state.grain_count(); ++g)
    for (std::uint32_t w = 0; w < wall_count; ++w) {
      const double distance = wall_distance(planes[w], state.position[g]);
      packing::Contact c{.i = g, .j = w, .overlap = state.radius_of(g) - distance, .tangential_force = {}};
      if (!(c.overlap > 0))
        continue;
      const contact::NormalResponse response = std::visit(
          [&](const auto& law) {
            return wall_response(contact::of_sizes(law, size_of(state, g), size_of(state, g)), c.overlap);
          },
          kernel);
      c.branch = -distance * planes[w].normal;
      c.normal_force = response.force;
      c.normal_stiffness = response.stiffness;
      c.tangential_stiffness = rough ? material.tangential_ratio * response.stiffness : 0;
      while (memory != state.walls->history.end() && std::tie(memory->grain, memory->wall) < std::tie(g, w))
        ++memory;
      if (memory != state.walls->history.end() && memory->grain == g && memory->wall == w) {
        c.tangential_force = -memory->tangential_force;
        c.sliding = rough && material.tangential() &&
                    at_limit(c.tangential_force, state.walls->friction_coefficient * c.normal_force);
      }
      contacts.push_back(c);
    }
  return contacts;
}

} // namespace

void require_simulable(const contact::NormalLaw& law) {
  if (const contact::PowerLaw* power = law.power_law(); power != nullptr && power->alpha() < 1)
    throw InvalidArgument("alpha", power->alpha(), "",
                          "[1, inf] in simulations: below 1 grains touch with cusps, whose overlaps under "
                          "small forces are not small; closed forms and networks of given forces allow it");
}

void require_valid(const Material& material) {
  require_simulable(material.law);
  require_non_negative("tangential_ratio", material.tangential_ratio);
  require_positive("density", material.density, "kg/m^3");
  if (!(material.friction_coefficient >= 0))
    throw InvalidArgument("friction_coefficient", material.friction_coefficient, "", "[0, inf]");
}

void require_valid(const Walls& walls) {
  if (!(walls.friction_coefficient >= 0))
    throw InvalidArgument("friction_coefficient of the walls", walls.friction_coefficient, "", "[0, inf]");
}

void require_valid_sizes(const Specimen& state) {
  if (state.size.empty())
    return;
  if (state.size.size() != state.grain_count())
    throw InvalidArgument("size: " + std::to_string(state.size.size()) + " sizes of " +
                          std::to_string(state.grain_count()) + " grains");
  for (const double size : state.size)
    require_positive("size of a grain", size);
}

double largest_size(const Specimen& state) {
  return state.size.empty() ? 1 : *std::max_element(state.size.begin(), state.size.end());
}

double smallest_size(const Specimen& state) {
  return state.size.empty() ? 1 : *std::min_element(state.size.begin(), state.size.end());
}

double grain_volume(const Specimen& state) {
  const double grain = 4.0 / 3.0 * std::numbers::pi * std::pow(state.radius, 3);
  double cubes = static_cast<double>(state.grain_count());
  if (!state.size.empty()) {
    cubes = 0;
    for (const double size : state.size)
      cubes += size * size * size;
  }
  return grain * cubes;
}

double void_ratio(const Specimen& state) { return determinant(state.cell) / grain_volume(state) - 1; }

packing::Assembly contact_network(const Specimen& state, const Material& material) {
  packing::Assembly assembly;
  assembly.cell = state.cell;
  assembly.position = state.position;
  for (std::size_t g = 0; g < state.grain_count(); ++g)
    assembly.radius.push_back(state.radius_of(g));
  if (!state.walls)
    wrap(assembly.cell, assembly.position);
  const std::array<Vec3, image_count> shifts = shift_vectors(assembly.cell);
  const contact::NormalKernel kernel = material.law.kernel();
  auto memory = state.history.begin();
  const std::vector<Pair> pairs =
      state.size.empty()
          ? neighbour_pairs(assembly.cell, assembly.position, 2 * state.radius, images(state))
          : neighbour_pairs(assembly.cell, assembly.position, assembly.radius, 0, images(state));
  for (const Pair& pair : pairs) {
    packing::Contact c;
    c.i = pair.i;
    c.j = pair.j;
    c.branch = assembly.position[pair.j] + shifts[pair.image] - assembly.position[pair.i];
    c.overlap = assembly.radius[c.i] + assembly.radius[c.j] - norm(c.branch);
    const contact::NormalResponse response = pair_response(kernel, state, c.i, c.j, c.overlap);
    c.normal_force = response.force;
    c.normal_stiffness = response.stiffness;
    c.tangential_stiffness = material.tangential_ratio * response.stiffness;
    while (memory != state.history.end() && std::tie(memory->i, memory->j) < std::tie(c.i, c.j))
      ++memory;
    if (memory != state.history.end() && memory->i == c.i && memory->j == c.j) {
      c.tangential_force = memory->tangential_force;
      c.sliding = material.tangential() &&
                  at_limit(c.tangential_force, material.friction_coefficient * c.normal_force);
    }
    assembly.contacts.push_back(c);
  }
  if (state.walls)
    assembly.wall_contacts = wall_contacts(state, material);
  return assembly;
}

} // namespace granum::dem
