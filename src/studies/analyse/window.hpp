// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <utility>

#include <granum/analysis/measure.hpp>
#include <granum/io/imported_packing.hpp>

/// A part of a packing to measure, as given by a user.
/// Checked by tests/studies/test_window.cpp
namespace granum::studies {

struct WindowChoice {
  std::array<std::optional<double>, 3> low = {},
                                       high = {}; ///< in the axes of the files; the whole if left out [m]
  std::optional<std::pair<double, double>> depth = {}; ///< below the top, instead of z [m]
};

/// The window in the packing. The whole along a periodic axis is one edge of the cell, along others the
/// extent of the grains; the top is the top of the highest grain with a contact.
/// \throws   InvalidArgument if it is not within the packing along an axis that is not periodic, or has no
/// volume
[[nodiscard]] analysis::Window window_in(const io::ImportedPacking& packing, const WindowChoice& choice);

/// The interior of a packing between walls or under a free surface: along axes that are not periodic, two and
/// a half mean grain diameters away from where the grains end, or two where that leaves less than five; the
/// whole along the others.
/// \return   empty if all axes are periodic, or if less than three diameters or a hundred contacts
///           would be left
/// Checked by tests/studies/test_window.cpp
[[nodiscard]] std::optional<WindowChoice> interior_window(const io::ImportedPacking& packing);

} // namespace granum::studies
