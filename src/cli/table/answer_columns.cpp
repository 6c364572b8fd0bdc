// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_columns.hpp"

#include <granum/core/number.hpp>

namespace granum::cli {

AnswerColumns::AnswerColumns(const io::CsvTable& table, NumberColumns& columns, AnswerOptions& answer)
    : table_(table) {
  for (Number* number : {&answer.relative_density, &answer.least_void_ratio, &answer.largest_void_ratio,
                         &answer.grain_density, &answer.saturation})
    columns.bind(*number);
  grain_ = columns.text("grain", answer.mineral != nullptr);
  sand_ = columns.text("sand", answer.sand != nullptr);
  grain_shape_ = columns.text("grain_shape", answer.grain_shape.has_value());
}

void AnswerColumns::take_names(std::size_t row, AnswerOptions& answer) const {
  const auto& fields = table_.fields(row);
  const auto text = [&](const std::optional<std::size_t>& column) {
    return column ? std::string(trimmed(fields[*column])) : std::string();
  };
  if (const std::string name = text(grain_); !name.empty())
    answer.mineral = &contact::mineral(name);
  if (const std::string name = text(sand_); !name.empty())
    answer.sand = &sands::known_sand(name);
  if (const std::string name = text(grain_shape_); !name.empty())
    answer.grain_shape = estimate::grain_shape_of(name);
}

std::array<MaterialValue, 11> material_values(const PackingOptions& packing, const AnswerOptions& o) {
  const auto number = [](const Number& one) { return one.given() ? short_text(one.value) : ""; };
  const bool limits = o.least_void_ratio.given() && o.largest_void_ratio.given();
  return {{{"--sand", o.sand != nullptr ? std::string(o.sand->key) : ""},
           {"--grain-shape", o.grain_shape ? std::string(name(*o.grain_shape)) : ""},
           {"--grain", o.mineral != nullptr ? std::string(o.mineral->key) : ""}, // may follow from these
           {"--grain-density", number(o.grain_density)},
           {"--saturation", number(o.saturation)},
           {"--least-void-ratio", number(o.least_void_ratio)},
           {"--largest-void-ratio", number(o.largest_void_ratio)},
           {"--relative-density", limits ? "" : number(o.relative_density)}, // else one more density
           {"--radius", number(packing.radius)},
           {"--d50", number(packing.d50)},
           {"--uniformity", packing.uniformity ? short_text(*packing.uniformity) : ""}}};
}

} // namespace granum::cli
