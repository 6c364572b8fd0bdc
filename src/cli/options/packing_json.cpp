// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_json.hpp"

#include <fmt/core.h>
#include <granum/core/text.hpp>

namespace granum::cli {

using estimate::Input;
using nlohmann::ordered_json;

namespace {

/// Whether the size of the grains is known, not only how they differ.
bool is_sized(const estimate::InputValues& values) {
  return values.given(Input::d50) || values.given(Input::radius) || values.sizes->mean_radius();
}

/// What an answer for a sand takes; the moduli of the grains are for the contacts that are inferred.
ordered_json sand_json(const estimate::InputValues& values, const effective::State& s) {
  ordered_json json = {{"grain_shape", "sand"}};
  if (values.known_sand != nullptr)
    json["sand"] = values.known_sand->key;
  json["void_ratio"] = s.void_ratio;
  for (const Input input : {Input::relative_density, Input::least_void_ratio, Input::largest_void_ratio,
                            Input::uniformity, Input::d50, Input::shear_strain})
    if (values.given(input))
      json[estimate::row_of(input).key] = values.number(input);
  if (values.known_sand != nullptr && values.known_sand->uniformity && !values.given(Input::uniformity))
    json[estimate::row_of(Input::uniformity).key] = *values.known_sand->uniformity;
  if (values.sizes)
    json["sizes"] = values.sizes->text();
  if (values.sizes && is_sized(values))
    json["gradation"] = json_of(sizes::gradation(*values.sizes, radius_of(values)));
  json.update({{"grain_shear_modulus", s.law.grain().shear_modulus},
               {"grain_poisson_ratio", s.law.grain().poisson_ratio},
               {"grain_density", values.number(Input::grain_density)},
               {"saturation", values.number(Input::saturation)}});
  return json;
}

} // namespace

ordered_json packing_json(const estimate::InputValues& values, const effective::State& s) {
  if (estimate::known_shape(values) == estimate::GrainShape::sand)
    return sand_json(values, s);
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
