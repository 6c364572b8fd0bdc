// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/core/units.hpp>
#include <toml++/toml.h>

namespace granum::cli {

namespace {

using verify::Scene;

struct Key {
  std::string name;
  std::string meaning;
  std::function<void(Scene&, const std::string& name, const std::string& text)> set;
  std::function<std::string(const Scene&)> get; ///< what `set` takes, to the bit; TOML
};

std::string quoted(const std::string& text) { return '"' + text + '"'; }

/// A value with its SI unit.
std::string quantity_text(double value, Dimension dimension) {
  return dimension == Dimension::dimensionless
             ? exact_text(value)
             : quoted(exact_text(value) + std::string(si_symbol(dimension)));
}

/// A list of TOML, each item by its own text.
template <class Value, class Text>
std::string list_text(const std::vector<Value>& values, const Text& text) {
  std::string out;
  for (const Value& value : values)
    out += (out.empty() ? "" : ", ") + text(value);
  return "[" + out + "]";
}

Key quantity(const char* name, double Scene::*member, Dimension dimension, const char* meaning) {
  return {name, meaning,
          [member, dimension](Scene& scene, const std::string& key, const std::string& text) {
            scene.*member = parse_quantity(key, text, dimension);
          },
          [member, dimension](const Scene& scene) { return quantity_text(scene.*member, dimension); }};
}

template <class Integer>
Key whole_number(const char* name, Integer Scene::*member, const char* meaning) {
  return {name, meaning,
          [member](Scene& scene, const std::string& key, const std::string& text) {
            const double value = parse_quantity(key, text, Dimension::dimensionless);
            if (!(value >= 0 && value <= 9e15) || value != std::floor(value))
              throw InvalidArgument(key + " = " + text + " is not a whole number");
            scene.*member = static_cast<Integer>(value);
          },
          [member](const Scene& scene) { return std::to_string(scene.*member); }};
}

std::vector<std::string> items_of(const std::string& text) {
  std::vector<std::string> items;
  std::istringstream stream(text);
  for (std::string item; std::getline(stream, item, ',');)
    items.emplace_back(trimmed(item));
  return items;
}

Key pressures(const char* name, std::vector<double> Scene::*member, const char* meaning) {
  return {name, meaning,
          [member](Scene& scene, const std::string& key, const std::string& text) {
            std::vector<double> values;
            for (const std::string& item : items_of(text))
              values.push_back(parse_quantity(key, item, Dimension::pressure));
            scene.*member = values;
          },
          [member](const Scene& scene) {
            return list_text(scene.*member,
                             [](double value) { return quantity_text(value, Dimension::pressure); });
          }};
}

std::string_view name_of(verify::Shape shape) { return verify::name(shape); }
std::string_view name_of(triaxial::Density density) { return verify::name(density); }
std::string_view name_of(stress::ShearPath path) { return stress::name(path); }

template <class Value>
Key names(const char* name, std::vector<Value> Scene::*member, std::vector<Value> known,
          const char* meaning) {
  return {name, meaning,
          [member, known](Scene& scene, const std::string& key, const std::string& text) {
            std::vector<Value> values;
            for (const std::string& item : items_of(text)) {
              const auto found = std::find_if(known.begin(), known.end(),
                                              [&](Value value) { return name_of(value) == item; });
              if (found == known.end()) {
                std::string all;
                for (const Value value : known)
                  all += (all.empty() ? "" : ", ") + std::string(name_of(value));
                throw InvalidArgument(key + ": '" + item + "' is unknown; known are " + all);
              }
              values.push_back(*found);
            }
            scene.*member = values;
          },
          [member](const Scene& scene) {
            return list_text(scene.*member, [](Value value) { return quoted(std::string(name_of(value))); });
          }};
}

const std::vector<Key>& keys() {
  using enum Dimension;
  using enum verify::Shape;
  using triaxial::Density;
  static const std::vector<Key> table{
      quantity("grain.radius", &Scene::radius, length, "radius of the grains"),
      quantity("grain.shear_modulus", &Scene::grain_shear_modulus, pressure, "G_g"),
      quantity("grain.poisson_ratio", &Scene::grain_poisson_ratio, dimensionless, "nu_g, in (-1, 0.5]"),
      quantity("grain.friction_angle", &Scene::friction_angle, angle, "between grains"),
      quantity("grain.density", &Scene::density, density, "sets the time scale only"),
      quantity("contact.tangential_ratio", &Scene::tangential_ratio, dimensionless,
               "k_t/k_n; negative: 2(1-nu)/(2-nu)"),
      quantity("contact.cone_slope", &Scene::cone_slope, dimensionless, "A_1 of the cone"),
      quantity("contact.punch_radius", &Scene::punch_radius, length, "of the flat contact"),
      quantity("contact.alpha", &Scene::alpha, dimensionless, "of the power-law contact, >= 1"),
      quantity("contact.profile_constant", &Scene::profile_constant, dimensionless,
               "A_alpha of the power-law contact, in m^(1-alpha)"),
      names("study.contacts", &Scene::contacts, {cone, sphere, flat, power_law},
            "cone, sphere, flat, power-law"),
      names("study.densities", &Scene::densities, {Density::dense, Density::loose}, "dense, loose"),
      whole_number("study.grains", &Scene::grains, "grains of a specimen"),
      whole_number("study.seeds", &Scene::seeds, "specimens of each kind"),
      whole_number("study.first_seed", &Scene::first_seed, "seed of the first of them"),
      whole_number("study.threads", &Scene::threads, "specimens side by side; results do not depend on it"),
      pressures("study.pressures", &Scene::pressures, "rising list"),
      pressures("study.probe_pressures", &Scene::probe_pressures, "some of the pressures; may be empty"),
      {"specimen.boundary", "periodic, or walls: six rigid ones (reproduce only)",
       [](Scene& scene, const std::string& key, const std::string& text) {
         if (text != "periodic" && text != "walls")
           throw InvalidArgument(key + ": '" + text + "' is unknown; known are periodic, walls");
         scene.walls = text == "walls";
       },
       [](const Scene& scene) { return quoted(scene.walls ? "walls" : "periodic"); }},
      quantity("specimen.wall_friction", &Scene::wall_friction, dimensionless,
               "coefficient between grains and walls"),
      quantity("specimen.expansion_void_ratio", &Scene::expansion_void_ratio, dimensionless,
               "of the cell in which the grains grow"),
      quantity("specimen.unjamming_strain", &Scene::unjamming_strain, dimensionless,
               "by which loose specimens are opened before friction is switched on"),
      quantity("specimen.agitation", &Scene::agitation, dimensionless,
               "random move of each grain then, as a share of its radius"),
      names("shear.paths", &Scene::paths, {stress::all_shear_paths.begin(), stress::all_shear_paths.end()},
            "TXC, RTXC, RTXE, TXE (this and the next: reproduce only)"),
      quantity("shear.inertial_number", &Scene::inertial_number, dimensionless,
               "driven strain rate times d sqrt(density/p')"),
      quantity("shear.eta_step", &Scene::eta_step, dimensionless, "freeze at its multiples ..."),
      quantity("shear.strain_step", &Scene::strain_step, dimensionless, "... and of this axial strain"),
      quantity("shear.largest_strain", &Scene::largest_strain, dimensionless, "axial, where paths end"),
      quantity("shear.probe_eta_step", &Scene::probe_eta_step, dimensionless,
               "cyclic shear at its multiples; 0: nowhere"),
      quantity("shear.loop_strain", &Scene::loop_strain, dimensionless,
               "of cycles of shear with friction (Fig. 8); 0: none"),
  };
  return table;
}

std::string known_keys() {
  std::string all;
  for (const Key& key : keys())
    all += (all.empty() ? "" : ", ") + key.name;
  return all;
}

/// A TOML value as the text that --set would take.
std::string text_of(const toml::node& node, const std::string& path) {
  const auto line = node.source().begin.line;
  if (const auto* text = node.as_string())
    return text->get();
  if (const auto* integer = node.as_integer())
    return std::to_string(integer->get());
  if (const auto* number = node.as_floating_point())
    return exact_text(number->get());
  if (const auto* list = node.as_array()) {
    std::string joined;
    for (const toml::node& item : *list) {
      if (item.is_array() || item.is_table())
        throw FileError(path, line, "a list may hold texts and numbers only");
      joined += (joined.empty() ? "" : ",") + text_of(item, path);
    }
    return joined;
  }
  throw FileError(path, line, "expected a text such as \"0.5mm\", a number, or a list of them");
}

void apply_table(Scene& scene, const toml::table& table, const std::string& prefix, const std::string& path) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* section = node.as_table()) {
      apply_table(scene, *section, name + ".", path);
      continue;
    }
    try {
      set_key(scene, name, text_of(node, path));
    } catch (const InvalidArgument& error) {
      throw FileError(path, node.source().begin.line, error.what());
    }
  }
}

template <class Value>
std::vector<std::string> names_of(const std::vector<Value>& values) {
  std::vector<std::string> out;
  for (const Value value : values)
    out.emplace_back(name_of(value));
  return out;
}

} // namespace

void set_key(Scene& scene, const std::string& name, const std::string& value) {
  const auto key = std::find_if(keys().begin(), keys().end(), [&](const Key& k) { return k.name == name; });
  if (key == keys().end())
    throw InvalidArgument("key '" + name + "' is unknown; known are " + known_keys());
  key->set(scene, name, value);
}

Scene read_scene(const std::string& path, const Scene& defaults) {
  toml::table table;
  try {
    table = toml::parse_file(path);
  } catch (const toml::parse_error& error) {
    throw FileError(path, error.source().begin.line, std::string(error.description()));
  }
  Scene scene = defaults;
  apply_table(scene, table, "", path);
  return scene;
}

void apply_setting(Scene& scene, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos)
    throw InvalidArgument("--set " + setting + ": expected key=value");
  set_key(scene, std::string(trimmed(setting.substr(0, equals))),
          std::string(trimmed(setting.substr(equals + 1))));
}

nlohmann::ordered_json json_of(const Scene& scene) {
  return {{"grain",
           {{"radius_m", scene.radius},
            {"shear_modulus_Pa", scene.grain_shear_modulus},
            {"poisson_ratio", scene.grain_poisson_ratio},
            {"friction_angle_rad", scene.friction_angle},
            {"density_kg_per_m3", scene.density}}},
          {"contact",
           {{"tangential_ratio",
             verify::recipe(scene, scene.contacts.front(), scene.first_seed).material.tangential_ratio},
            {"cone_slope", scene.cone_slope},
            {"punch_radius_m", scene.punch_radius},
            {"alpha", scene.alpha},
            {"profile_constant_SI", scene.profile_constant}}},
          {"study",
           {{"contacts", names_of(scene.contacts)},
            {"densities", names_of(scene.densities)},
            {"grains", scene.grains},
            {"seeds", scene.seeds},
            {"first_seed", scene.first_seed},
            {"threads", scene.threads},
            {"pressures_Pa", scene.pressures},
            {"probe_pressures_Pa", scene.probe_pressures}}},
          {"specimen",
           {{"boundary", scene.walls ? "walls" : "periodic"},
            {"wall_friction", scene.wall_friction},
            {"expansion_void_ratio", scene.expansion_void_ratio},
            {"unjamming_strain", scene.unjamming_strain},
            {"agitation", scene.agitation}}},
          {"shear",
           {{"paths", names_of(scene.paths)},
            {"inertial_number", scene.inertial_number},
            {"eta_step", scene.eta_step},
            {"strain_step", scene.strain_step},
            {"largest_strain", scene.largest_strain},
            {"probe_eta_step", scene.probe_eta_step},
            {"loop_strain", scene.loop_strain}}}};
}

std::string toml_of(const Scene& scene) {
  std::string text, section;
  for (const Key& key : keys()) {
    const std::size_t dot = key.name.find('.');
    if (key.name.substr(0, dot) != section) {
      section = key.name.substr(0, dot);
      text += (text.empty() ? "[" : "\n[") + section + "]\n";
    }
    text += key.name.substr(dot + 1) + " = " + key.get(scene) + "\n";
  }
  return text;
}

std::string key_help() {
  std::string text = "Keys of scenes and of --set:\n";
  for (const Key& key : keys())
    text += fmt::format("  {:<30} {}\n", key.name, key.meaning);
  return text;
}

} // namespace granum::cli
