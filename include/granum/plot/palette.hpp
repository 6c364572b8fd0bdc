// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// The one table of colours: each has one meaning, in every picture, report, and on the page for
/// browsers, which reads the rows of this file as they are (web/build.mjs).
/// Checked by tests/plot/test_looks.cpp
namespace granum::plot {

/// What a colour means. Density has none: loose packings are hollow or dashed. Nor have references, such
/// as an isotropic circle: they are grey.
enum class Colour : std::size_t {
  sphere,         ///< contact shapes, where they are compared
  cone,           ///< a shape
  flat,           ///< a shape
  power_law,      ///< a shape
  rough,          ///< a shape
  closed_form,    ///< granum's answer: rung 3, fitted laws and densities, with their ranges
  uniform_strain, ///< rungs 0 to 2: the most that a packing can have
  measured,       ///< what was measured or simulated: network, probe, laboratory, counted contacts
  txc,            ///< stress paths: vertical stress grows
  rtxc,           ///< horizontal stress falls
  rtxe,           ///< vertical stress falls
  txe,            ///< horizontal stress grows
  force,          ///< contacts that carry more than the mean force
  vertical = txc, ///< stress or modulus, where it is set against the horizontal one
  horizontal = txe
};

/// A colour on white paper and on dark, as "#rrggbb".
struct PaletteRow {
  const char* name;
  const char* light;
  const char* dark;
};

/// In the order of Colour. Colours that meet in one picture are distinct to people with colour blindness,
/// after Okabe and Ito, or have other marks too; all contrast with their paper as text does, by 4.5 or more.
inline constexpr PaletteRow palette[] = {
    {"sphere", "#0072b2", "#56b4e9"},         //
    {"cone", "#c04a00", "#f08a4b"},           //
    {"flat", "#00785a", "#3fc79a"},           //
    {"power_law", "#6b3fa0", "#bb9af0"},      //
    {"rough", "#7d4f3a", "#d0a58c"},          //
    {"closed_form", "#a2457e", "#e09cc4"},    //
    {"uniform_strain", "#806000", "#e0bb44"}, //
    {"measured", "#474f5a", "#c5ccd4"},       //
    {"txc", "#006b7d", "#4cc3d9"},            //
    {"rtxc", "#4d5bc4", "#9aa8ff"},           //
    {"rtxe", "#9b2d4f", "#f590ad"},           //
    {"txe", "#5f6b00", "#bccb3a"},            //
    {"force", "#b3261e", "#ff8f85"},          //
};

/// What has no colour of its own.
inline constexpr PaletteRow reference_grey{"grey", "#6b6f75", "#a9b1ba"};

} // namespace granum::plot
