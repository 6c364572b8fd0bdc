// SPDX-License-Identifier: GPL-3.0-or-later
// What both ways of drawing a chart share.
#pragma once

#include <cstddef>

#include <granum/plot/chart.hpp>

namespace granum::plot {

/// \throws   InvalidArgument if a chart contradicts itself, as svg says
void require_valid(const Chart& chart);

/// Of series without a colour of their own.
inline constexpr const char* grey = "#7a7a7a";
/// "#rrggbb" of the style of that index.
[[nodiscard]] const char* series_colour(std::size_t index);

} // namespace granum::plot
