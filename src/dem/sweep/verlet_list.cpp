// SPDX-License-Identifier: GPL-3.0-or-later
#include "verlet_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <granum/packing/assembly.hpp>

namespace granum::dem {

namespace {

/// Index of the shift to the same grain after both grains of a pair have moved by whole cell vectors; none if
/// it is no longer in a neighbouring cell.
std::optional<std::uint32_t> shifted(std::uint32_t image, const Vec3& of_i, const Vec3& of_j) {
  const auto number = static_cast<int>(image);
  const Vec3 k = Vec3{number / 9 - 1.0, number / 3 % 3 - 1.0, number % 3 - 1.0} + of_j - of_i;
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(k[axis]) <= 1))
      return std::nullopt;
  return static_cast<std::uint32_t>(
      image_index(static_cast<int>(k.x), static_cast<int>(k.y), static_cast<int>(k.z)));
}

/// The pairs of a list within the cutoff, in their order.
template <class Reach>
void take_within(const Reach& reach, const std::vector<Pair>& from, std::vector<Pair>& to) {
  to.resize(from.size());
  std::size_t count = 0;
  for (const Pair& pair : from) {
    to[count] = pair;
    count += static_cast<std::size_t>(reach(pair));
  }
  to.resize(count);
}

} // namespace

Reference::Reference(const Specimen& state)
    : cell(state.cell), cell_inverse(inverse_of(state.cell)), position(state.position) {}

double size_of_strain(const Mat3& gradient) {
  double size = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      size += std::abs(gradient(i, j) - (i == j ? 1 : 0));
  return size;
}

VerletList::VerletList(const Specimen& state, double skin, double wide_skin)
    : contact_distance_(2 * state.radius * largest_size(state)), skin_(skin * state.radius),
      wide_skin_(wide_skin * state.radius) {}

void VerletList::build(Specimen& state) {
  if (radius_.empty() && !state.size.empty())
    for (std::size_t g = 0; g < state.grain_count(); ++g)
      radius_.push_back(state.radius_of(g));
  if (!state.walls && !wrap_all(state))
    wide_reference_ = {};
  const auto centre = [&](std::size_t g) { return state.position[g]; };
  const bool kept = !wide_reference_.position.empty() &&
                    nearing(wide_reference_.drift(state.cell, centre), wide_skin_) < wide_skin_ - skin_;
  if (!kept && searches_ > 0 && fits_wide(state)) {
    wide_pairs_ = search(state, wide_skin_);
    wide_reference_ = Reference(state);
  } else if (!kept) {
    wide_reference_ = {};
  }
  if (wide_reference_.position.empty())
    pairs_ = search(state, skin_);
  else
    take_near_pairs(state);
  reference_ = Reference(state);
}

std::vector<Pair> VerletList::search(const Specimen& state, double skin) {
  ++searches_;
  if (radius_.empty())
    return neighbour_pairs(state.cell, state.position, contact_distance_ + skin, images(state));
  return neighbour_pairs(state.cell, state.position, radius_, skin, images(state));
}

bool VerletList::fits_wide(const Specimen& state) const {
  const Vec3 widths = packing::cell_widths(state.cell);
  const double cutoff = contact_distance_ + wide_skin_;
  return wide_skin_ > skin_ && (state.walls || 2 * cutoff <= std::min({widths.x, widths.y, widths.z}));
}

/// Updates the wider list after grains have been wrapped. False if this is not possible.
bool VerletList::wrap_all(Specimen& state) {
  std::vector<Vec3> moved;
  wrap_each(state.cell, state.position, [&](std::size_t g, const Vec3& whole) {
    if (wide_reference_.position.empty())
      return;
    wide_reference_.position[g] -= wide_reference_.cell * whole;
    moved.resize(state.position.size());
    moved[g] = whole;
  });
  if (moved.empty())
    return true;
  for (Pair& pair : wide_pairs_) {
    if (moved[pair.i] == moved[pair.j])
      continue;
    const std::optional<std::uint32_t> image = shifted(pair.image, moved[pair.i], moved[pair.j]);
    if (!image)
      return false;
    pair.image = *image;
  }
  return true;
}

void VerletList::take_near_pairs(const Specimen& state) {
  const std::array<Vec3, image_count> shifts = shift_vectors(state.cell);
  if (radius_.empty())
    take_within(EqualReach(shifts, state.position, contact_distance_ + skin_), wide_pairs_, pairs_);
  else
    take_within(UnequalReach(shifts, state.position, radius_, skin_), wide_pairs_, pairs_);
}

} // namespace granum::dem
