// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/arrays.hpp>

#include <algorithm>
#include <array>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "contact_rows.hpp"
#include "dump_file.hpp"
#include "io/packing_builder.hpp"

namespace granum::io {

namespace {

constexpr std::array<std::string_view, 29> quantities{
    "id",  "radius", "diameter", "body", "shape", "x",  "y",     "z",     "xs",  "ys",
    "zs",  "id1",    "id2",      "dx",   "dy",    "dz", "delta", "force", "fnx", "fny",
    "fnz", "ftx",    "fty",      "ftz",  "fx",    "fy", "fz",    "kn",    "kt"};

} // namespace

ColumnMap parse_column_map(std::string_view text) {
  ColumnMap map;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos)
      throw InvalidArgument("column map: expected quantity=column, found '" + std::string(item) + "'");
    const std::string_view quantity = trimmed(item.substr(0, equals));
    const std::string_view column = trimmed(item.substr(equals + 1));
    if (std::find(quantities.begin(), quantities.end(), quantity) == quantities.end())
      throw InvalidArgument("column map: '" + std::string(quantity) + "' is no quantity of a dump");
    if (column.empty())
      throw InvalidArgument("column map: no column is given for '" + std::string(quantity) + "'");
    if (!map.emplace(quantity, column).second)
      throw InvalidArgument("column map: '" + std::string(quantity) + "' is given twice");
  }
  return map;
}

namespace {

/// Names in messages, in place of the files of grains and contacts.
constexpr const char *grains_name = "grains", *contacts_name = "contacts";

DumpUnits units_in_memory(const std::string& style) {
  if (style == "lj")
    return {};
  if (const std::optional<DumpUnits> units = dump_units(style))
    return *units;
  throw InvalidArgument("units '" + style + "' are not supported; expected " + known_dump_units);
}

void require_one_each(const char* name, std::size_t length, std::size_t expected) {
  if (length != expected)
    throw InvalidArgument(std::string(name) + " has " + std::to_string(length) + " elements, id has " +
                          std::to_string(expected));
}

std::vector<GrainRow> rows_of_grains(const LammpsArrays& arrays, double length) {
  std::vector<GrainRow> rows(arrays.id.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k] = {.id = arrays.id[k],
               .position = length * arrays.position[k],
               .radius = length * arrays.radius[k],
               .line = k + 1};
    if (!arrays.type.empty())
      rows[k].type = arrays.type[k];
  }
  return rows;
}

LocalFrame frame_in_memory(const LammpsLocals& given) {
  const std::size_t row_length = given.columns.size();
  if (row_length == 0 || given.values.size() % row_length != 0)
    throw InvalidArgument("contacts: " + std::to_string(given.values.size()) + " values in rows of " +
                          std::to_string(row_length));
  LocalFrame frame;
  frame.columns = given.columns;
  frame.layout =
      contact_layout(given.columns, given.map, TextSource::of_text(contacts_name, std::string_view()));
  frame.unnamed = {.columns = given.columns,
                   .computes = column_groups(given.columns, "c_"),
                   .numbers = {given.values.begin(), given.values.end()},
                   .lines = {}};
  for (std::size_t row = 0; row < given.values.size() / row_length; ++row)
    frame.unnamed.lines.push_back(row + 1);
  return frame;
}

ImportedPacking join_arrays(const LammpsArrays& arrays) {
  const DumpUnits units = units_in_memory(arrays.units);
  PackingBuilder builder(grains_name, contacts_name);
  builder.set_cell(units.length * arrays.cell, arrays.periodic, 0);
  builder.set_grains(rows_of_grains(arrays, units.length));
  std::optional<LocalFrame> contacts;
  if (arrays.contacts) {
    contacts = frame_in_memory(*arrays.contacts);
    join(builder, *contacts, units);
  }
  if (!units.stated)
    builder.note(Finding::units_unknown, "units lj: assumed to be SI");
  note_unknown_contacts(builder, contacts ? &*contacts : nullptr, "among the data of LAMMPS");
  return builder.finish(arrays.step, std::nullopt);
}

} // namespace

ImportedPacking lammps_packing(const LammpsArrays& arrays) {
  require_one_each("position", arrays.position.size(), arrays.id.size());
  require_one_each("radius", arrays.radius.size(), arrays.id.size());
  if (!arrays.type.empty())
    require_one_each("type", arrays.type.size(), arrays.id.size());
  try {
    return join_arrays(arrays);
  } catch (const FileError& error) {
    throw in_arrays(error);
  }
}

} // namespace granum::io
