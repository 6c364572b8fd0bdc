// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_rows.hpp"

#include <iterator>

#include <fmt/format.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

namespace granum::cli {

AnswerRows::AnswerRows(const io::CsvTable& table, const SweepOptions& options, RowsOf rows)
    : table_(table), packings_(table, options.packing), answer_(options.answer), ground_(options.ground),
      material_(table, packings_.columns(), answer_) {
  NumberColumns& columns = packings_.columns();
  const bool layers = rows == RowsOf::layers;
  answer_.ground = layers || (!packings_.tells_stress() && columns.bind(ground_.row_depth));
  std::vector<Number*> all{&answer_.strain};
  Number* const of_ground[] = {&ground_.unit_weight, &ground_.saturated_unit_weight,
                               &ground_.earth_pressure_at_rest};
  if (answer_.ground)
    all.insert(all.end(), std::begin(of_ground), std::end(of_ground));
  else
    all.push_back(&answer_.earth_pressure_at_rest);
  if (answer_.ground)
    all.push_back(&ground_.water_table);
  if (answer_.ground && !layers)
    all.push_back(&ground_.surcharge);
  for (Number* number : all)
    columns.bind(*number);
  has_speed_ = !layers && columns.bind(shear_wave_speed_);
  if (layers && !columns.bind(ground_.top))
    throw FileError(table.name(), table.heading_line(),
                    "lacks a column top_m, the depth of the top of a layer");
  for (const Number* number : {&ground_.unit_weight, &ground_.saturated_unit_weight, &ground_.water_table,
                               &ground_.earth_pressure_at_rest, &ground_.surcharge})
    if (!answer_.ground && number->given())
      throw InvalidArgument(number->name +
                            " goes with --depth, or with a table that has a column depth_m and no stress");
  preparation_ = columns.text("preparation", answer_.preparation != effective::Preparation{});
}

AnswerRow AnswerRows::row(std::size_t row) {
  const PackingOptions& packing = packings_.packing(row);
  AnswerRow both{packing, answer_, ground_};
  if (shear_wave_speed_.given())
    both.shear_wave_speed = require_positive("V_s", shear_wave_speed_.value, "m/s");
  if (const std::string name(preparation_ ? trimmed(table_.fields(row)[*preparation_]) : ""); !name.empty())
    both.answer.preparation = effective::preparation_of(name);
  material_.take_names(row, both.answer);
  apply_presets(both.packing, both.answer);
  return both;
}

std::string unread_text(const std::vector<std::string>& headings) {
  return fmt::format("unused columns: {}", fmt::join(headings, ", "));
}

} // namespace granum::cli
