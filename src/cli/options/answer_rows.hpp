// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ground.hpp"
#include "input_columns.hpp"

/// Questions from the rows of a table.
namespace granum::cli {

/// The question of a row, as for granum estimate.
struct AnswerRow {
  InputValues inputs;
  GroundOptions ground;
  std::optional<double> shear_wave_speed = {}; ///< measured, in addition to the question [m/s]
};

/// A row that is a depth, in the ground of the row.
struct RowInGround {
  GroundCase ground;
  double depth = 0; ///< [m]
  stress::GroundStress stress = {};
  InputValues inputs = {}; ///< with the effective stress and the saturation of the depth
};
/// \throws   InvalidArgument for a depth above the surface, and as resolve_ground
[[nodiscard]] RowInGround in_ground(const AnswerRow& row);

/// The kind of the rows.
enum class RowsOf {
  states,       ///< stresses; or depths in the ground, if there is a column of depths and none of stresses
  measurements, ///< states at which something was measured: without a strain, and V_s is not read
  layers        ///< of the ground, each from its top down
};

/// What the rows of a table know of their packings, and the measured V_s.
class AnswerRows {
 public:
  /// \throws   as InputColumns; InvalidArgument for options of the ground with rows that contain their stress
  AnswerRows(const io::CsvTable& table, const InputValues& inputs, const GroundOptions& ground,
             RowsOf rows = RowsOf::states);
  AnswerRows(const AnswerRows&) = delete; // the columns refer to its members
  AnswerRows& operator=(const AnswerRows&) = delete;

  /// Whether each row is a depth, or a layer, of the ground.
  [[nodiscard]] bool in_ground() const { return inputs_.ground; }
  /// Whether there is a column of measured V_s.
  [[nodiscard]] bool has_speed() const { return has_speed_; }

  /// A row, with what its inputs imply.
  /// \throws   InvalidArgument
  [[nodiscard]] AnswerRow row(std::size_t row) const;
  /// As those of InputColumns.
  [[nodiscard]] std::vector<std::string> remarks() const { return columns_.remarks(); }
  [[nodiscard]] InputColumns& columns() { return columns_; }

 private:
  void bind_ground(bool layers);

  InputValues inputs_;
  GroundOptions ground_;
  InputColumns columns_;
  Number shear_wave_speed_{0, Dimension::speed, column_names::shear_wave_speed, "--shear-wave-speed"};
  bool has_speed_ = false;
};

} // namespace granum::cli
