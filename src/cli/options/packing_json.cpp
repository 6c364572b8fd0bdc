// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_json.hpp"

#include <fmt/core.h>
#include <granum/core/text.hpp>

namespace granum::cli {

using estimate::Input;
using nlohmann::ordered_json;

ordered_json packing_json(const estimate::InputValues& values, const effective::State& s) {
  ordered_json json = {{"contact", name(values.contact)}};
  for (const estimate::InputRow& row : estimate::inputs())
    if (row.law != nullptr && row.law->shape == values.contact)
      json[row.key] = values.number(row.input);
  json.update({{"grain_shear_modulus", s.law.grain().shear_modulus},
               {"grain_poisson_ratio", s.law.grain().poisson_ratio},
               {"radius", s.radius},
               {"tangential_ratio", s.tangential_ratio},
               {"void_ratio", s.void_ratio},
               {"fabric", s.fabric_anisotropy}});
  if (values.minerals.size() > 1)
    json["grain"] = contact::text_of(values.minerals);
  if (s.rolling > 0)
    json["rolling"] = s.rolling;
  if (s.coordination_number)
    json["coordination_number"] = *s.coordination_number;
  if (s.mechanical_coordination_number)
    json["mechanical_coordination_number"] = *s.mechanical_coordination_number;
  for (const Input limit : {Input::least_void_ratio, Input::largest_void_ratio})
    if (values.given(limit))
      json[estimate::row_of(limit).key] = values.number(limit);
  if (values.sizes)
    json.update({{"sizes", values.sizes->text()},
                 {"gradation", json_of(sizes::gradation(*values.sizes, radius_of(values)))},
                 {"contact_means", json_of(s.contacts)}});
  return json;
}

ordered_json json_of(const sizes::Gradation& g) {
  return {{"d10", g.d10}, {"d50", g.d50}, {"d60", g.d60}, {"uniformity", g.uniformity()}};
}

ordered_json json_of(const sizes::ContactMeans& c) {
  return {{"branch", c.branch},
          {"branch_square", c.branch_square},
          {"pair_radius", c.pair_radius},
          {"grain_volume", c.grain_volume}};
}

std::string means_text(const sizes::ContactMeans& c) {
  return fmt::format("branch <l> = {:.4f} x 2R, <l^2> = {:.4f} x (2R)^2, pair radius 2R* = {:.4f} x R, "
                     "grain volume <V> = {:.4f} x 4/3 pi R^3",
                     c.branch, c.branch_square, c.pair_radius, c.grain_volume);
}

std::string gradation_text(const sizes::Gradation& g) {
  return fmt::format("d10 {}, d50 {}, d60 {}", pretty(g.d10, Dimension::length),
                     pretty(g.d50, Dimension::length), pretty(g.d60, Dimension::length));
}

} // namespace granum::cli
