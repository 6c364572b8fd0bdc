// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyse.hpp"
#include <granum/plot/chart.hpp>

/// How the states of many frames change with stress.
namespace granum::cli {

/// Which states are one series, with exponents of their own.
enum class SeriesBy {
  name, ///< those of files whose names differ in numbers alone; all, where that makes no series of two states
  all
};

/// The series of some frames in the order of their first frames, with G ~ p^s of each rung.
/// \return   none for fewer than two frames
[[nodiscard]] std::vector<StateSeries> series_of(const std::vector<FrameAnswer>& frames, SeriesBy by);

/// The mean stress of the state that the closed forms are asked about [Pa]; nothing without forces.
[[nodiscard]] std::optional<double> mean_stress(const FrameAnswer& frame);

/// How the moduli grow with stress, a table for each series.
[[nodiscard]] std::string series_text(const AnalyseAnswer& answer);
[[nodiscard]] nlohmann::ordered_json series_json(const AnalyseAnswer& answer);

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
