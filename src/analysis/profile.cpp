// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/profile.hpp>

#include <granum/core/error.hpp>

namespace granum::analysis {

namespace {

/// Rung 3 of a slice; none where its contacts or its stress allow none.
std::optional<effective::RungAnswer> relaxed_answer(const Slice& slice, const Measurement& whole) {
  if (!whole.state || !(slice.solid_fraction > 0))
    return std::nullopt;
  effective::State state = *whole.state;
  const Mat3& stress = slice.part.stress;
  state.void_ratio = slice.part.void_ratio;
  state.coordination_number = slice.part.micro.coordination_number;
  state.mechanical_coordination_number = slice.part.micro.mechanical_coordination_number;
  state.fabric_anisotropy = slice.part.micro.fabric_anisotropy;
  state.stress_v = stress(2, 2);
  state.stress_h = (stress(0, 0) + stress(1, 1)) / 2;
  try {
    return effective::answer(effective::rung(effective::RungName::relaxed), state);
  } catch (const InvalidArgument&) { // as without contacts or stress
    return std::nullopt;
  }
}

} // namespace

std::vector<Slice> profile(const packing::Assembly& assembly, const Measurement& whole, const Window& window,
                           int axis, std::size_t slices) {
  require_valid(assembly);
  if (axis < 0 || axis > 2)
    throw InvalidArgument("axis of a profile is 0, 1 or 2");
  if (slices == 0)
    throw InvalidArgument("a profile has one slice or more");
  const std::optional<packing::Bodies> bodies =
      assembly.body.empty() ? std::nullopt : std::optional(packing::bodies(assembly));
  const packing::Assembly& moving = bodies ? bodies->assembly : assembly;
  const double low = window.low[axis], width = (window.high[axis] - low) / static_cast<double>(slices);
  std::vector<Slice> out;
  for (std::size_t k = 0; k < slices; ++k) {
    stop_point();
    Window at = window;
    at.low[axis] = low + static_cast<double>(k) * width;
    at.high[axis] = k + 1 < slices ? low + static_cast<double>(k + 1) * width : window.high[axis];
    const packing::Interior interior(moving.cell, at.low, at.high);
    Slice slice{.low = at.low[axis],
                .high = at.high[axis],
                .part = part_measures(moving, whole.counts.mechanical, interior)};
    slice.solid_fraction = slice.part.void_ratio > 0 ? 1 / (1 + slice.part.void_ratio) : 0;
    slice.relaxed = relaxed_answer(slice, whole);
    out.push_back(slice);
  }
  return out;
}

} // namespace granum::analysis
