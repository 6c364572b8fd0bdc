// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "cli/options/answer_rows.hpp"
#include "infer.hpp"

namespace granum::cli {

namespace {

/// A measured quantity of a table, and its error if that has a column.
struct MeasuredColumn {
  inverse::Quantity quantity;
  io::CsvTable::Place value;
  std::optional<io::CsvTable::Place> error;
};

std::optional<MeasuredColumn> measured_column(const io::CsvTable& table, const MeasuredOption& option) {
  for (const std::string& name : words_of(option.columns)) {
    if (!table.has(name))
      continue;
    MeasuredColumn column{option.quantity, table.column(name, option.dimension()), std::nullopt};
    if (table.has(name + "_error"))
      column.error = table.column(name + "_error", option.dimension());
    return column;
  }
  return std::nullopt;
}

std::vector<MeasuredColumn> measured_columns(const io::CsvTable& table, InputColumns& columns) {
  std::vector<MeasuredColumn> found;
  for (const MeasuredOption& option : measured_options())
    if (const std::optional<MeasuredColumn> column = measured_column(table, option)) {
      columns.mark_as_read(column->value.index);
      if (column->error)
        columns.mark_as_read(column->error->index);
      found.push_back(*column);
    }
  if (found.empty())
    throw FileError(table.name(), 0,
                    "has no column of a measured quantity: G_MPa, K_MPa, V_s_m/s, V_p_m/s, ...");
  return found;
}

/// The number in a field, SI; empty if the field is empty.
std::optional<double> number_in(const io::CsvTable& table, std::size_t row,
                                const io::CsvTable::Place& column) {
  const std::string& field = table.fields(row)[column.index];
  if (trimmed(field).empty())
    return std::nullopt;
  const auto value = parse_number(field);
  if (!value)
    throw InvalidArgument(
        fmt::format("expected a number in column '{}', found '{}'", table.headings()[column.index], field));
  return *value * column.factor;
}

/// A column of contacts is the result of another program, not an input of this one.
estimate::Notes table_remarks(const InputColumns& columns, const InputValues& row) {
  estimate::Notes remarks;
  for (const Input input :
       {Input::coordination_number, Input::mechanical_coordination_number, Input::rattler_fraction})
    if (remarks.empty() && row[input].source == estimate::Source::table)
      add_sentence(remarks, "C_n, z* and rattlers in the table are not used, because they are inferred");
  name_remarks(remarks, columns.remarks());
  return remarks;
}

/// The inputs that are one and the same for all states of a sand; each state has its own saturation.
constexpr Input of_material[] = {Input::sand,
                                 Input::grain_shape,
                                 Input::grain,
                                 Input::grain_density,
                                 Input::least_void_ratio,
                                 Input::largest_void_ratio,
                                 Input::relative_density,
                                 Input::radius,
                                 Input::d50,
                                 Input::uniformity};

/// The value of such an input as text, after all that is implied; empty if it has none.
std::string material_text(const InputValues& values, Input input) {
  switch (input) {
  case Input::sand:
    return values.known_sand != nullptr ? values.known_sand->key : "";
  case Input::grain_shape:
    return values.grain_shape ? std::string(name(*values.grain_shape)) : "";
  case Input::grain:
    return contact::text_of(values.minerals);
  case Input::relative_density: // with its limits it is one more density
    if (values.given(Input::least_void_ratio) && values.given(Input::largest_void_ratio))
      return "";
    break;
  default:
    break;
  }
  const std::optional<double> number = values.if_given(input);
  return number ? short_text(*number) : "";
}

/// The inputs of a row; at a depth with its stress, which is noted with the ground.
InputValues values_of(const AnswerRow& row, bool of_depths, bool first, InferCase& question) {
  if (!of_depths)
    return row.inputs;
  RowInGround at = in_ground(row);
  if (first)
    std::ranges::copy(at.ground.assumptions, std::back_inserter(question.assumptions));
  question.ground.merge(at.ground.validity);
  return std::move(at.inputs);
}

/// \throws   InvalidArgument naming the column, or the option, in which a row is of another material
void require_same_material(const InputValues& expected, const InputValues& found,
                           const InputColumns& columns) {
  for (const Input input : of_material) {
    const std::string here = material_text(found, input), first = material_text(expected, input);
    if (here == first)
      continue;
    const std::string option = estimate::row_of(input).option();
    const std::optional<std::string> heading = columns.heading(option);
    const auto shown = [](const std::string& value) { return value.empty() ? "none" : value; };
    throw InvalidArgument(fmt::format(
        "{}: {} here, {} in the first row; it is one for all measurements: give {}, or a table for each",
        heading ? "column '" + *heading + "'" : option, shown(here), shown(first), option));
  }
}

} // namespace

InputValues read_table(const InferOptions& o, InferCase& question) {
  for (const std::string& text : o.measured)
    if (!text.empty())
      throw InvalidArgument("measurements are given both by --table and by options: use one of the two");
  const io::CsvTable table = io::read_csv(o.table);
  question.manner = table.manner();
  AnswerRows rows(table, o.inputs, o.ground, RowsOf::measurements);
  InputColumns& inputs = rows.columns();
  const std::vector<MeasuredColumn> columns = measured_columns(table, inputs);
  std::optional<InputValues> first;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    try {
      const AnswerRow given = rows.row(k);
      InputValues row = values_of(given, rows.in_ground(), !first, question);
      if (first)
        require_same_material(*first, row, inputs);
      else
        std::ranges::copy(table_remarks(inputs, row), std::back_inserter(question.assumptions));
      if (row[Input::rattler_fraction].source == estimate::Source::table)
        row.leave_out(Input::rattler_fraction); // contacts are inferred
      first = first ? first : std::optional(row);
      for (const MeasuredColumn& column : columns) {
        const auto value = number_in(table, k, column.value);
        if (!value)
          continue;
        const auto error = column.error ? number_in(table, k, *column.error) : std::nullopt;
        note_assumed_error(o, question, error.has_value());
        const Dimension unit = dimension_of(inverse::row_of(column.quantity));
        question.measurements.push_back(
            {column.quantity,
             {*value, error.value_or(share_of(o.measurement_error, unit) * *value)},
             state_of(row, stresses_of(row)),
             row.within(Input::saturation)});
        if (rows.in_ground())
          question.depths.push_back(given.ground.row_depth.value);
      }
    } catch (const InvalidArgument& error) {
      throw FileError(o.table, table.line(k), error.what());
    }
  }
  if (question.measurements.empty())
    throw FileError(o.table, 0, "contains no measured value: the columns of measured quantities are empty");
  const double pores = first->within(Input::saturation);
  if (std::ranges::any_of(question.measurements,
                          [pores](const inverse::Observation& m) { return m.saturation != pores; }))
    add_sentence(
        question.assumptions,
        fmt::format("forecasts have the pores of the first measurement, S_r = {}", percent_text(pores)));
  return *first;
}

} // namespace granum::cli
