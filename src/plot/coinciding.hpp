// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/plot/chart.hpp>

namespace granum::plot {

/// How far apart two points of a picture are at most to be seen as one [pixels]: less than a line is wide.
inline constexpr double one_point = 1.5;

/// The chart with curves that lie on each other drawn once: a named line without error bars whose points
/// are those of an earlier one, each within one_point, loses its points, and the earlier one has all names:
/// "A, B: one curve".
/// Places, and so styles, stay as they are. Markers and surfaces stay: they stand for data.
/// Checked by tests/plot/test_chart.cpp
[[nodiscard]] Chart with_coinciding_once(Chart chart);

} // namespace granum::plot
