// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/io/csv/table.hpp>

#include "cli/options/answer_rows.hpp"
#include "depth.hpp"

namespace granum::cli {

namespace {

/// The ground below a depth, where the layers above cause this effective stress.
GroundCase below(GroundCase ground, double top, double effective_stress_v) {
  ground.ground.surcharge = effective_stress_v;
  if (ground.ground.water_table)
    *ground.ground.water_table -= top; // above the top it is water on the layer
  return ground;
}

/// The rows with the single water table of the ground, given in any of them.
std::vector<AnswerRow> rows_of(const io::CsvTable& table, AnswerRows& reader) {
  std::vector<AnswerRow> rows;
  const Number* given = nullptr;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    try {
      rows.push_back(reader.row(k));
    } catch (const InvalidArgument& error) {
      throw FileError(table.name(), table.line(k), error.what());
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Number& here = rows[k].ground.water_table;
    if (given != nullptr && here.given() && here.value != given->value)
      throw FileError(
          table.name(), table.line(k),
          "has another water table than a row above: the ground has a single one, measured from its top");
    if (given == nullptr && here.given())
      given = &here;
  }
  if (given != nullptr) {
    const Number one = *given;
    for (AnswerRow& row : rows)
      row.ground.water_table = one;
  }
  return rows;
}

Layer layer_of(const SweepOptions& o, const AnswerRow& row) {
  Layer layer{.top = row.ground.top.value, .options = o, .ground = {}};
  layer.options.inputs = row.inputs;
  layer.options.ground = row.ground;
  layer.ground = resolve_ground(row.inputs, row.ground);
  return layer;
}

} // namespace

std::vector<double> depths_of(const SweepOptions& o) {
  const std::string& text = o.ground.depth;
  const auto ends = ends_of_range(text);
  if (!ends)
    throw InvalidArgument(fmt::format("--depth = '{}' must be two depths, such as 0m..30m", text));
  const double first = parse_quantity("--depth", ends->front(), Dimension::length);
  const double last = parse_quantity("--depth", ends->back(), Dimension::length);
  require_non_negative("--depth", first, "m");
  if (!(last > first))
    throw InvalidArgument(fmt::format("--depth = '{}' must be the smaller depth, then the larger", text));
  return spread(first, last, o.points, false);
}

std::vector<Layer> layers_of(const SweepOptions& o) {
  if (o.ground.layers.empty())
    return {{.top = 0, .options = o, .ground = resolve_ground(o.inputs, o.ground)}};
  const io::CsvTable table = io::read_csv(o.ground.layers);
  AnswerRows reader(table, o.inputs, o.ground, RowsOf::layers);
  const std::vector<AnswerRow> rows = rows_of(table, reader);
  std::vector<Layer> layers;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    try {
      Layer layer = layer_of(o, rows[k]);
      if (layers.empty() ? layer.top != 0 : !(layer.top > layers.back().top))
        throw InvalidArgument(layers.empty() ? "the first layer begins at top 0 m"
                                             : "the tops of layers must increase from line to line");
      if (!layers.empty()) {
        const Layer& above = layers.back();
        const stress::GroundStress end = stress::stress_at(above.ground.ground, layer.top - above.top);
        layer.ground = below(std::move(layer.ground), layer.top, end.effective.v);
      }
      layers.push_back(std::move(layer));
    } catch (const InvalidArgument& error) {
      throw FileError(o.ground.layers, table.line(k), error.what());
    }
  }
  estimate::Notes remarks;
  name_remarks(remarks, reader.remarks());
  for (Layer& layer : layers)
    layer.ground.assumptions.insert(layer.ground.assumptions.end(), remarks.begin(), remarks.end());
  return layers;
}

const Layer& layer_at(const std::vector<Layer>& layers, double depth) {
  const auto next = std::find_if(layers.begin() + 1, layers.end(),
                                 [depth](const Layer& layer) { return layer.top > depth; });
  return *(next - 1);
}

InputValues values_at(const std::vector<Layer>& layers, double depth) {
  const Layer& layer = layer_at(layers, depth);
  return values_in_ground(layer.options.inputs, layer.ground, depth - layer.top);
}

} // namespace granum::cli
