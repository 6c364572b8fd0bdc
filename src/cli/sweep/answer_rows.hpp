// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/estimate/answer_options.hpp"
#include "cli/options/packing_rows.hpp"
#include "sweep.hpp"

/// Questions that stand in the rows of a table.
namespace granum::cli {

/// What granum estimate would be asked for a row.
struct AnswerRow {
  PackingOptions packing;
  AnswerOptions answer;
  GroundOptions ground;
  std::optional<double> shear_wave_speed = {}; ///< measured, beside the question [m/s]
};

/// What the rows are.
enum class RowsOf {
  states, ///< stresses; or depths in the ground, where a column tells these and none a stress
  layers  ///< of ground, from their tops down
};

/// The packings of a table, and what else of the answer's options it holds: preparation, grain, sand,
/// relative density and its limits, density of the grains, saturation; and V_s that was measured there.
class AnswerRows {
 public:
  /// \throws   as PackingRows; InvalidArgument for options of the ground beside rows that have their stress
  AnswerRows(const io::CsvTable& table, const SweepOptions& options, RowsOf rows = RowsOf::states);
  /// Whether each row is a depth, or a layer, of the ground.
  [[nodiscard]] bool in_ground() const { return answer_.ground; }
  /// Whether there is a column of measured V_s.
  [[nodiscard]] bool has_speed() const { return has_speed_; }

  /// A row, with the numbers that grain, sand and relative density decide.
  /// \throws   InvalidArgument
  [[nodiscard]] AnswerRow row(std::size_t row);
  /// Headings of the columns that say nothing to this program.
  [[nodiscard]] std::vector<std::string> unread() const { return packings_.columns().unread(); }

 private:
  const io::CsvTable& table_;
  PackingRows packings_;
  AnswerOptions answer_;
  GroundOptions ground_;
  Number shear_wave_speed_{0, Dimension::speed, "V_s Vs vs", "--shear-wave-speed"};
  bool has_speed_ = false;
  std::optional<std::size_t> preparation_, grain_, sand_, grain_shape_;
};

/// "columns that are no inputs: borehole, date".
[[nodiscard]] std::string unread_text(const std::vector<std::string>& headings);

} // namespace granum::cli
