// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "cli/options/packing_rows.hpp"
#include "cli/table/answer_columns.hpp"
#include "infer.hpp"

namespace granum::cli {

namespace {

/// The packing without its contacts, which are to be inferred.
PackingOptions without_contacts(PackingOptions o) {
  o.rattler_fraction.in_table = false;
  return o;
}

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

std::vector<MeasuredColumn> measured_columns(const io::CsvTable& table, NumberColumns& columns) {
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
std::vector<std::string> table_remarks(const NumberColumns& columns, const PackingOptions& row) {
  std::vector<std::string> remarks;
  if (row.coordination_number.in_table || row.mechanical_coordination_number.in_table ||
      row.rattler_fraction.in_table)
    remarks.emplace_back("C_n, z* and rattlers in the table are not used, because they are inferred");
  if (const std::vector<std::string> unread = columns.unread(); !unread.empty())
    remarks.push_back(fmt::format("unused columns: {}", fmt::join(unread, ", ")));
  return remarks;
}

/// Depths of a table without a stress would need the weight of the ground.
void require_stress(const io::CsvTable& table, PackingRows& rows) {
  Number depth{0, Dimension::length, "z", "--depth"};
  if (rows.tells_stress() || !rows.columns().bind(depth))
    return;
  throw FileError(table.name(), table.heading_line(),
                  fmt::format("the stress at '{}' is missing: add columns sigma_v_kPa and K_0, or p_kPa",
                              rows.columns().heading("--depth").value_or("")));
}

using Material = decltype(material_values(PackingOptions(), AnswerOptions()));

/// \throws   InvalidArgument naming the column, or the option, in which a row is of another material
void require_same_material(const Material& expected, const Material& found, const NumberColumns& columns) {
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k].value != expected[k].value) {
      const std::optional<std::string> heading = columns.heading(found[k].option);
      const auto shown = [](const std::string& value) { return value.empty() ? "none" : value; };
      throw InvalidArgument(fmt::format(
          "{}: {} here, {} in the first row; it is one for all measurements: give {}, or a table for each",
          heading ? "column '" + *heading + "'" : found[k].option, shown(found[k].value),
          shown(expected[k].value), found[k].option));
    }
}

/// The rows of a table, and what they say of all measurements.
class MeasuredRows {
 public:
  MeasuredRows(const io::CsvTable& table, const InferOptions& options)
      : packings_(table, options.packing), grains_(options.grains),
        names_(table, packings_.columns(), grains_) {
    packings_.columns().bind(grains_.earth_pressure_at_rest);
    require_stress(table, packings_);
  }

  [[nodiscard]] NumberColumns& columns() { return packings_.columns(); }

  /// The packing of a row, with what follows from its material, density and K_0.
  PackingOptions row(std::size_t row) {
    PackingOptions packing = packings_.packing(row);
    AnswerOptions grains = grains_;
    names_.take_names(row, grains);
    apply_presets(packing, grains);
    const Material material = material_values(packing, grains);
    if (of_all_)
      require_same_material(material_, material, columns());
    else {
      of_all_ = grains;
      material_ = material;
    }
    return packing;
  }

  /// The material, of the first row.
  [[nodiscard]] const AnswerOptions& of_all() const { return of_all_.value(); }

 private:
  PackingRows packings_;
  AnswerOptions grains_;
  AnswerColumns names_;
  std::optional<AnswerOptions> of_all_;
  Material material_ = {}; ///< of the first row
};

} // namespace

PackingOptions read_table(InferOptions& o, InferCase& question) {
  for (const std::string& text : o.measured)
    if (!text.empty())
      throw InvalidArgument("measurements are given both by --table and by options: use one of the two");
  const io::CsvTable table = io::read_csv(o.table);
  question.manner = table.manner();
  MeasuredRows rows(table, o);
  const std::vector<MeasuredColumn> columns = measured_columns(table, rows.columns());
  std::optional<PackingOptions> first;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    try {
      const PackingOptions row = rows.row(k);
      if (!first)
        question.assumptions = table_remarks(rows.columns(), row);
      const PackingOptions packing = without_contacts(row);
      first = first ? first : std::optional(packing);
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
             resolve_state(packing, resolve_stresses(packing))});
      }
    } catch (const InvalidArgument& error) {
      throw FileError(o.table, table.line(k), error.what());
    }
  }
  if (question.measurements.empty())
    throw FileError(o.table, 0, "contains no measured value: the columns of measured quantities are empty");
  o.grains = rows.of_all();
  return *first;
}

} // namespace granum::cli
