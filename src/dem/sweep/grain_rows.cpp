// SPDX-License-Identifier: GPL-3.0-or-later
#include "grain_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <granum/dem/engine.hpp>

namespace granum::dem {

std::vector<OwnSize> own_sizes(const Specimen& state, double density) {
  const double all = density * grain_volume(state);
  double weights = 0;
  for (const double size : state.size)
    weights += std::pow(size, mass_exponent);
  std::vector<OwnSize> own;
  own.reserve(state.size.size());
  for (const double size : state.size) {
    const double mass = all * (std::pow(size, mass_exponent) / weights);
    own.push_back({.size = size, .radius = size * state.radius, .mass = mass, .per_mass = 1 / mass});
  }
  return own;
}

std::vector<OwnSize> sizes_for_descent(const Specimen& state) {
  double sum = 0;
  for (const double size : state.size)
    sum += size;
  const double mean = sum / static_cast<double>(state.size.size());
  std::vector<OwnSize> own;
  own.reserve(state.size.size());
  for (const double size : state.size) {
    const double mass = std::max(1.0, (size / mean) * (size / mean));
    own.push_back({.size = size, .radius = size * state.radius, .mass = mass, .per_mass = 1 / mass});
  }
  return own;
}

namespace {

/// The lowest 10 bits, each followed by two zeros.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000ff;
  bits = (bits | bits << 8) & 0x0300f00f;
  bits = (bits | bits << 4) & 0x030c30c3;
  return (bits | bits << 2) & 0x09249249;
}

/// Position on the Z curve through 1024^3 boxes of the cell; infinity and NaN, from absurd speeds, are in the
/// first box.
std::uint32_t place_on_curve(const Vec3& fraction) {
  const auto box = [](double s) {
    const double place = 1024 * (s - std::floor(s));
    return place > 0 ? static_cast<std::uint32_t>(std::min(place, 1023.0)) : 0;
  };
  return spread(box(fraction.x)) | spread(box(fraction.y)) << 1 | spread(box(fraction.z)) << 2;
}

} // namespace

std::vector<std::uint32_t> near_order(const Specimen& state) {
  const Mat3 to_fraction = inverse_of(state.cell);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
  for (std::uint32_t g = 0; g < state.grain_count(); ++g)
    places.emplace_back(place_on_curve(to_fraction * state.position[g]), g);
  std::sort(places.begin(), places.end());
  std::vector<std::uint32_t> order(places.size());
  for (std::uint32_t place = 0; place < places.size(); ++place)
    order[places[place].second] = place;
  return order;
}

std::vector<std::uint32_t> inverse_order(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> inverse(order.size());
  for (std::uint32_t g = 0; g < order.size(); ++g)
    inverse[order[g]] = g;
  return inverse;
}

bool is_order(const std::vector<std::uint32_t>& order, std::size_t count) {
  std::vector<bool> taken(count);
  for (const std::uint32_t place : order) {
    if (place >= count || taken[place])
      return false;
    taken[place] = true;
  }
  return order.size() == count;
}

Specimen reordered(const Specimen& state, const std::vector<std::uint32_t>& order) {
  Specimen out = state;
  for (std::size_t g = 0; g < order.size(); ++g) {
    out.position[order[g]] = state.position[g];
    out.velocity[order[g]] = state.velocity[g];
    out.angular_velocity[order[g]] = state.angular_velocity[g];
    if (!state.size.empty())
      out.size[order[g]] = state.size[g];
  }
  for (ContactHistory& contact : out.history) {
    contact.i = order[contact.i];
    contact.j = order[contact.j];
    if (contact.i > contact.j) {
      std::swap(contact.i, contact.j);
      contact.tangential_force = -contact.tangential_force;
    }
  }
  std::sort(out.history.begin(), out.history.end(), [](const ContactHistory& a, const ContactHistory& b) {
    return std::tie(a.i, a.j) < std::tie(b.i, b.j);
  });
  if (out.walls) {
    for (WallHistory& contact : out.walls->history)
      contact.grain = order[contact.grain];
    std::sort(out.walls->history.begin(), out.walls->history.end(),
              [](const WallHistory& a, const WallHistory& b) {
                return std::tie(a.grain, a.wall) < std::tie(b.grain, b.wall);
              });
  }
  return out;
}

} // namespace granum::dem
