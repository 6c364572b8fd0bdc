// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_rows.hpp"

#include <granum/core/error.hpp>

namespace granum::cli {

using estimate::Input;

RowInGround in_ground(const AnswerRow& row) {
  RowInGround at{.ground = resolve_ground(row.inputs, row.ground)};
  at.depth = require_non_negative("depth", row.ground.row_depth.value, "m");
  at.stress = stress::stress_at(at.ground.ground, at.depth);
  at.inputs = values_in_ground(row.inputs, at.ground, at.depth);
  return at;
}

AnswerRows::AnswerRows(const io::CsvTable& table, const InputValues& inputs, const GroundOptions& ground,
                       RowsOf rows)
    : inputs_(inputs), ground_(ground), columns_(table, inputs_) {
  const bool layers = rows == RowsOf::layers, measured = rows == RowsOf::measurements;
  columns_.bind_packing();
  columns_.bind_material();
  inputs_.ground = layers || (!columns_.gives_stress() && columns_.bind(ground_.row_depth));
  if (!measured)
    columns_.bind(Input::shear_strain);
  if (inputs_.ground)
    bind_ground(layers);
  else
    columns_.bind(Input::k0);
  has_speed_ = rows == RowsOf::states && columns_.bind(shear_wave_speed_);
  if (layers && !columns_.bind(ground_.top))
    throw FileError(table.name(), table.heading_line(),
                    "lacks a column top_m, the depth of the top of a layer");
  for (const Number* number : {&ground_.unit_weight, &ground_.saturated_unit_weight, &ground_.water_table,
                               &ground_.earth_pressure_at_rest, &ground_.surcharge})
    if (!inputs_.ground && number->given())
      throw InvalidArgument(number->name + (measured ? " goes" : " goes with --depth, or") +
                            " with a table that has a column depth_m and no stress");
  if (!measured)
    columns_.bind(Input::preparation);
}

void AnswerRows::bind_ground(bool layers) {
  if (const std::optional<double> k0 = inputs_.if_given(Input::k0)) { // of commands that also read stresses
    ground_.earth_pressure_at_rest.value = *k0;
    ground_.earth_pressure_at_rest.typed = true;
    inputs_.leave_out(Input::k0);
  }
  for (Number* const number : {&ground_.unit_weight, &ground_.saturated_unit_weight,
                               &ground_.earth_pressure_at_rest, &ground_.water_table})
    columns_.bind(*number);
  if (!layers)
    columns_.bind(ground_.surcharge);
}

AnswerRow AnswerRows::row(std::size_t row) const {
  const InputValues values = columns_.row(row); // sets the numbers of the ground too
  AnswerRow out{.inputs = values, .ground = ground_};
  if (shear_wave_speed_.given())
    out.shear_wave_speed = require_positive("V_s", shear_wave_speed_.value, "m/s");
  out.inputs = completed(values);
  return out;
}

} // namespace granum::cli
