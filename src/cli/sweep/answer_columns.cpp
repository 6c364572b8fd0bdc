// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_columns.hpp"

#include "cli/frame/frame.hpp"

namespace granum::cli {

namespace {

using effective::PackingAnswer;
using effective::Range;

struct AnswerColumn {
  const char* symbol;
  const char* unit;
  double factor; ///< of the unit, SI
  bool usual;    ///< shown unless all are asked for
  std::optional<Range> (*of)(const PackingAnswer& answer);
};

constexpr AnswerColumn answer_columns[] = {
    {"G", "MPa", 1e6, true, [](const PackingAnswer& a) { return std::optional(a.shear_modulus); }},
    {"V_s", "m/s", 1, true, [](const PackingAnswer& a) { return a.shear_wave_speed; }},
    {"V_p", "m/s", 1, true, [](const PackingAnswer& a) { return a.compression_wave_speed; }},
    {"z_star", "", 1, true,
     [](const PackingAnswer& a) { return std::optional(a.mechanical_coordination_number); }},
    {"K", "MPa", 1e6, false, [](const PackingAnswer& a) { return std::optional(a.bulk_modulus); }},
    {"E", "MPa", 1e6, false, [](const PackingAnswer& a) { return std::optional(a.young_modulus); }},
    {"nu", "", 1, false, [](const PackingAnswer& a) { return std::optional(a.poisson_ratio); }},
    {"G_hh", "MPa", 1e6, false, [](const PackingAnswer& a) { return std::optional(a.G_hh); }},
    {"E_h", "MPa", 1e6, false,
     [](const PackingAnswer& a) { return std::optional(a.horizontal_young_modulus); }},
    {"V_s_h", "m/s", 1, false, [](const PackingAnswer& a) { return a.horizontal_shear_wave_speed; }},
    {"V_p_h", "m/s", 1, false, [](const PackingAnswer& a) { return a.horizontal_compression_wave_speed; }},
    {"density", "kg/m3", 1, false, [](const PackingAnswer& a) { return a.bulk_density; }},
    {"C_n", "", 1, false, [](const PackingAnswer& a) { return std::optional(a.coordination_number); }},
    {"rattlers", "", 1, false, [](const PackingAnswer& a) { return std::optional(a.rattler_fraction); }},
};

} // namespace

std::vector<std::string> answer_headings(bool all) {
  std::vector<std::string> headings;
  for (const AnswerColumn& column : answer_columns)
    if (column.usual || all)
      for (const char* part : {"_answer", "_low", "_high"})
        headings.push_back(std::string(column.symbol) + part + (*column.unit == '\0' ? "" : "_") +
                           column.unit);
  return headings;
}

void append_answer_cells(std::vector<io::CsvCell>& row, const std::optional<PackingAnswer>& answer,
                         bool all) {
  for (const AnswerColumn& column : answer_columns) {
    if (!column.usual && !all)
      continue;
    const std::optional<Range> range = answer ? column.of(*answer) : std::nullopt;
    for (double Range::*part : {&Range::value, &Range::low, &Range::high})
      row.emplace_back(range ? (*range).*part / column.factor : nothing);
  }
}

} // namespace granum::cli
