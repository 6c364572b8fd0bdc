// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/estimate/answer_options.hpp"
#include "cli/options/column_names.hpp"
#include "cli/options/packing_rows.hpp"
#include "cli/table/answer_columns.hpp"
#include "sweep.hpp"

/// Questions from the rows of a table.
namespace granum::cli {

/// The question of a row, as for granum estimate.
struct AnswerRow {
  PackingOptions packing;
  AnswerOptions answer;
  GroundOptions ground;
  std::optional<double> shear_wave_speed = {}; ///< measured, in addition to the question [m/s]
};

/// The kind of the rows.
enum class RowsOf {
  states, ///< stresses; or depths in the ground, if there is a column of depths and none of stresses
  layers  ///< of the ground, each from its top down
};

/// The packings of a table with the other options of an answer: preparation, grain, sand, relative density
/// and its limits, density of the grains, saturation; and the measured V_s.
class AnswerRows {
 public:
  /// \throws   as PackingRows; InvalidArgument for options of the ground with rows that contain their stress
  AnswerRows(const io::CsvTable& table, const SweepOptions& options, RowsOf rows = RowsOf::states);
  /// Whether each row is a depth, or a layer, of the ground.
  [[nodiscard]] bool in_ground() const { return answer_.ground; }
  /// Whether there is a column of measured V_s.
  [[nodiscard]] bool has_speed() const { return has_speed_; }

  /// A row, with the numbers that follow from grain, sand and relative density.
  /// \throws   InvalidArgument
  [[nodiscard]] AnswerRow row(std::size_t row);
  /// Headings of unused columns.
  [[nodiscard]] std::vector<std::string> unread() const { return packings_.columns().unread(); }

 private:
  const io::CsvTable& table_;
  PackingRows packings_;
  AnswerOptions answer_;
  GroundOptions ground_;
  AnswerColumns material_;
  Number shear_wave_speed_{0, Dimension::speed, column_names::shear_wave_speed, "--shear-wave-speed"};
  bool has_speed_ = false;
  std::optional<std::size_t> preparation_;
};

/// "unused columns: borehole, date".
[[nodiscard]] std::string unread_text(const std::vector<std::string>& headings);

} // namespace granum::cli
