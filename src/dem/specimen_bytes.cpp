// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/specimen_bytes.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <granum/dem/walls.hpp>

namespace granum::dem {

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
