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

namespace {

/// Optional parts of a specimen.
constexpr std::uint64_t has_walls = 1, has_sizes = 2;

/// Range of grain sizes in valid bytes.
constexpr double smallest_known = 1e-6, largest_known = 1e6;

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool all_finite(const std::vector<Vec3>& vectors) {
  return std::all_of(vectors.begin(), vectors.end(), is_finite);
}

/// Whether every centre is in the cell, or near enough to be moved back without loss of digits.
bool near_cell(const Specimen& state) {
  const Mat3 to_fraction = inverse_of(state.cell);
  constexpr double far = 1e3;
  return std::all_of(state.position.begin(), state.position.end(), [&](const Vec3& x) {
    const Vec3 s = to_fraction * x;
    return std::abs(s.x) < far && std::abs(s.y) < far && std::abs(s.z) < far;
  });
}

/// Whether all indices of grains, contacts and cells are valid, also for manipulated bytes.
bool is_sound(const Specimen& state) {
  const std::size_t count = state.grain_count();
  const double volume = determinant(state.cell);
  if (!state.size.empty() &&
      (state.size.size() != count || !std::all_of(state.size.begin(), state.size.end(), [](double size) {
         return size >= smallest_known && size <= largest_known;
       })))
    return false;
  // Grains that fill between 4e-4 and 4 of their cell: this bounds the number of pairs.
  double solid = static_cast<double>(count) * std::pow(state.radius, 3);
  if (!state.size.empty())
    solid = grain_volume(state) / (4.0 / 3.0 * std::numbers::pi);
  if (!(state.radius > 0 && volume > 0 && std::isfinite(volume) && solid > 1e-4 * volume && solid < volume))
    return false;
  const auto fits = [&](const std::vector<Vec3>& of_grains) {
    return (of_grains.empty() || of_grains.size() == count) && all_finite(of_grains);
  };
  const auto of_state = [&](const ContactHistory& contact) {
    return contact.i < contact.j && contact.j < count && is_finite(contact.tangential_force);
  };
  const auto at_wall = [&](const WallHistory& contact) {
    return contact.grain < count && contact.wall < wall_count && is_finite(contact.tangential_force);
  };
  return near_cell(state) && fits(state.velocity) && fits(state.angular_velocity) &&
         std::all_of(state.history.begin(), state.history.end(), of_state) &&
         (!state.walls || std::all_of(state.walls->history.begin(), state.walls->history.end(), at_wall));
}

} // namespace

void save_specimen(ByteWriter& to, const Specimen& state) {
  to.put(state.cell);
  to.put(state.radius);
  to.put_all(state.position);
  to.put_all(state.velocity);
  to.put_all(state.angular_velocity);
  to.put_all(state.history);
  to.put((state.walls ? has_walls : 0) | (state.size.empty() ? 0 : has_sizes));
  if (state.walls) {
    to.put(state.walls->friction_coefficient);
    to.put_all(state.walls->history);
  }
  if (!state.size.empty())
    to.put_all(state.size);
}

Specimen load_specimen(ByteReader& from) {
  Specimen state;
  state.cell = from.get<Mat3>();
  state.radius = from.get<double>();
  state.position = from.get_all<Vec3>();
  state.velocity = from.get_all<Vec3>();
  state.angular_velocity = from.get_all<Vec3>();
  state.history = from.get_all<ContactHistory>();
  const auto parts = from.get<std::uint64_t>();
  if ((parts & ~(has_walls | has_sizes)) != 0)
    from.fail("contains parts of a specimen that this version does not support");
  if ((parts & has_walls) != 0) {
    state.walls.emplace();
    state.walls->friction_coefficient = from.get<double>();
    state.walls->history = from.get_all<WallHistory>();
  }
  if ((parts & has_sizes) != 0)
    state.size = from.get_all<double>();
  if (!is_sound(state))
    from.fail("contains an impossible state of its grains");
  return state;
}

} // namespace granum::dem
