// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "cli/estimate/answer_options.hpp"
#include "cli/options/packing_rows.hpp"

/// Columns of a table for the options of an answer.
namespace granum::cli {

/// Relative density and its limits, density of the grains, saturation; and by name grain, sand and kind of
/// grains.
class AnswerColumns {
 public:
  /// Binds the numbers of `answer`, which must stay in its place.
  /// \throws   as NumberColumns::bind
  AnswerColumns(const io::CsvTable& table, NumberColumns& columns, AnswerOptions& answer);

  /// Sets in `answer` what a row gives by name; its numbers come with NumberColumns::take.
  /// \throws   InvalidArgument for an unknown name
  void take_names(std::size_t row, AnswerOptions& answer) const;

 private:
  const io::CsvTable& table_;
  std::optional<std::size_t> grain_, sand_, grain_shape_;
};

/// An option of the material, and its value as text; "" if it has none.
struct MaterialValue {
  const char* option;
  std::string value;
};
/// What is one and the same for all states of a sand, after apply_presets.
[[nodiscard]] std::array<MaterialValue, 11> material_values(const PackingOptions& packing,
                                                            const AnswerOptions& answer);

} // namespace granum::cli
