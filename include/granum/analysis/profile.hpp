// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/analysis/measurement.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/packing/assembly.hpp>

/// How a packing changes along an axis.
namespace granum::analysis {

/// A slice across an axis.
struct Slice {
  double low = 0, high = 0;   ///< along the axis [m]
  double solid_fraction = 0;  ///< of whole and cut grains [1]
  InteriorMeasures part = {}; ///< the numbers of a slice without grains, or without contacts, are 0
  /// Rung 3 of the slice's e, C_n, z*, a and stress, with the law and the sizes of the whole packing.
  std::optional<effective::RungAnswer> relaxed = {};
};

/// Slices of equal width across an axis, which fill a window of the packing. The stress of a slice takes each
/// contact with the share of its branch inside, which is coarse-graining with a box as its kernel: stress
/// and solid volume of all slices add up to those of the window. [Goldhirsch2010]
/// Assumes   a window whose other axes take in the whole packing shows no edges to the stress; slices
///           narrower than two diameters show single layers of grains.
/// \param    whole    what was measured of the packing, for rung 3: without a state there is none
/// \param    axis     0, 1 or 2
/// \param    slices   >= 1
/// \throws   InvalidArgument for another axis, for no slice, for a window that is wider than the cell, and
///           for an assembly that require_valid rejects
/// Accuracy  sums over the slices agree with the whole to 1e-12.  Checked by tests/analysis/test_profile.cpp
[[nodiscard]] std::vector<Slice> profile(const packing::Assembly& assembly, const Measurement& whole,
                                         const Window& window, int axis, std::size_t slices);

} // namespace granum::analysis
