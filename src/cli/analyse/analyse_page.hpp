// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analyse.hpp"
#include <granum/plot/chart.hpp>

namespace granum::cli {

/// Directions of contacts of a frame with a fabric, as a rose beside E(gamma; a).
[[nodiscard]] plot::Chart rose_chart(const FrameAnswer& frame);
/// Distribution of the normal forces of a frame that has some.
[[nodiscard]] plot::Chart force_chart(const FrameAnswer& frame);
/// G of each rung with its stated error, beside that of the network.
[[nodiscard]] plot::Chart rung_chart(const FrameAnswer& frame);

/// Report of the last frame for people: how stiff it is and how near the closed forms come, then the
/// directions of its contacts, forces and chains, and all of `table` folded away.
[[nodiscard]] std::string analyse_page(const AnalyseAnswer& answer, const std::string& table);

struct SeriesPicture {
  plot::Chart chart;
  std::string caption;
};

/// G and K over p with both axes logarithmic, then z*, C_n and e over p; one series of points for each of the
/// answer's. None unless the mean stress varies by a tenth.
[[nodiscard]] std::vector<SeriesPicture> series_pictures(const AnalyseAnswer& answer);

} // namespace granum::cli
