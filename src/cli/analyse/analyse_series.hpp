// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyse.hpp"
#include <granum/plot/chart.hpp>

/// How the states of many frames change with stress.
namespace granum::cli {

/// "G grows as p^0.36 +- 0.01 (dense), ..."; empty where no exponent was found.
[[nodiscard]] std::string series_sentence(const AnalyseAnswer& answer);

struct SeriesPicture {
  plot::Chart chart;
  std::string caption;
};

/// G and K over p with both axes logarithmic, then z*, C_n and e over p; one series of points for each of the
/// answer's. None unless the mean stress varies by a tenth.
[[nodiscard]] std::vector<SeriesPicture> series_pictures(const AnalyseAnswer& answer);

} // namespace granum::cli
