// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/analyse/frame_answer.hpp"
#include "studies/analyse/frame_series.hpp"

/// How the moduli of many frames grow with stress.
/// Checked by tests/studies/test_frame_answer.cpp
namespace granum::studies {

/// How the moduli of one rung grow over the frames of a series.
struct RungSeries {
  std::string name;
  std::string title;
  SeriesFit fit;                       ///< G over the mean stress
  std::optional<hardin::Fit> separate; ///< G_vh over sigma_v and sigma_h, where their ratio varies
  std::string separate_remark = {};    ///< why it is not there
};

/// States that belong together: of one packing, or of packings that were made alike.
struct StateSeries {
  std::string name;
  std::vector<std::size_t> frames; ///< places in the list of frames
  std::vector<RungSeries> rungs;
};

/// Which states are one series, with exponents of their own.
enum class SeriesBy {
  name, ///< those of files whose names differ in numbers alone; all, where that makes no series of two states
  all
};

/// The series of some frames in the order of their first frames, with G ~ p^s of each rung.
/// \return   none for fewer than two frames
[[nodiscard]] std::vector<StateSeries> series_of(const std::vector<FrameAnswer>& frames, SeriesBy by);

} // namespace granum::studies
