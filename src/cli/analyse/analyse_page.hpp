// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analyse.hpp"
#include <granum/plot/chart.hpp>

namespace granum::cli {

/// Directions of contacts of a frame with a fabric, as a rose diagram with E(gamma; a).
[[nodiscard]] plot::Chart rose_chart(const FrameAnswer& frame);
/// Distribution of the normal forces of a frame with forces.
[[nodiscard]] plot::Chart force_chart(const FrameAnswer& frame);
/// G of each rung with its stated error, compared with that of the network.
[[nodiscard]] plot::Chart rung_chart(const FrameAnswer& frame);

/// Report of the last frame as a page: its stiffness and the accuracy of the closed forms, then the
/// directions of its contacts, forces and chains, and `table` in a folded section.
[[nodiscard]] std::string analyse_page(const AnalyseAnswer& answer, const std::string& table);

struct SeriesPicture {
  plot::Chart chart;
  std::string caption;
};

/// G and K over p with both axes logarithmic, then z*, C_n and e over p; one series of points for each series
/// of the answer. Empty unless the mean stress varies by a tenth.
[[nodiscard]] std::vector<SeriesPicture> series_pictures(const AnalyseAnswer& answer);

} // namespace granum::cli
