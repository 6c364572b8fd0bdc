// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_rows.hpp"

#include <granum/core/number.hpp>

namespace granum::cli {

AnswerRows::AnswerRows(const io::CsvTable& table, const PackingOptions& packing, const AnswerOptions& answer)
    : table_(table), packings_(table, packing), answer_(answer) {
  NumberColumns& columns = packings_.columns();
  for (Number* number :
       {&answer_.relative_density, &answer_.least_void_ratio, &answer_.largest_void_ratio,
        &answer_.grain_density, &answer_.saturation, &answer_.earth_pressure_at_rest, &answer_.strain})
    columns.bind(*number);
  preparation_ = columns.text("preparation", answer.preparation != effective::Preparation{});
  grain_ = columns.text("grain", answer.mineral != nullptr);
  sand_ = columns.text("sand", answer.sand != nullptr);
  grain_shape_ = columns.text("grain_shape", answer.grain_shape.has_value());
}

AnswerRow AnswerRows::row(std::size_t row) {
  const PackingOptions& packing = packings_.packing(row);
  const auto& fields = table_.fields(row);
  const auto text = [&](const std::optional<std::size_t>& column) {
    return column ? std::string(trimmed(fields[*column])) : std::string();
  };
  AnswerRow both{packing, answer_};
  if (const std::string said = text(preparation_); !said.empty())
    both.answer.preparation = effective::preparation_of(said);
  if (const std::string said = text(grain_); !said.empty())
    both.answer.mineral = &contact::mineral(said);
  if (const std::string said = text(sand_); !said.empty())
    both.answer.sand = &sands::known_sand(said);
  if (const std::string said = text(grain_shape_); !said.empty())
    both.answer.grain_shape = estimate::grain_shape_of(said);
  apply_presets(both.packing, both.answer);
  return both;
}

} // namespace granum::cli
