// SPDX-License-Identifier: GPL-3.0-or-later
#include "grain_rows.hpp"

#include <algorithm>
#include <cmath>

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

} // namespace granum::dem
