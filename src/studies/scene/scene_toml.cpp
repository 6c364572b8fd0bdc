// SPDX-License-Identifier: GPL-3.0-or-later
#include <type_traits>

#include "studies/scene/scene_keys.hpp"
#include <granum/core/text.hpp>

namespace granum::studies {

namespace {

std::string quoted(const std::string& text) { return '"' + text + '"'; }

/// "0.5mm" if that gives the same bits, otherwise "0.0005m".
std::string quantity_text(double value, Dimension dimension, bool short_units) {
  if (dimension == Dimension::dimensionless)
    return exact_text(value);
  const std::string exact = exact_text(value) + std::string(si_symbol(dimension));
  if (!short_units)
    return quoted(exact);
  std::string text = pretty(value, dimension);
  text.erase(text.find(' '), 1);
  return quoted(parse_quantity("a scene", text, dimension) == value ? text : exact);
}

template <class Value, class Text>
std::string list_text(const std::vector<Value>& values, const Text& text_of) {
  std::string out;
  for (const Value& value : values)
    out += (out.empty() ? "" : ", ") + text_of(value);
  return "[" + out + "]";
}

struct Section {
  const char* name;
  const char* meaning;
};

constexpr Section sections[] = {
    {"grain", "spheres, quartz-like grains, Table 1 of Chung et al. (2014)"},
    {"contact", "between two grains; each shape uses only its own numbers"},
    {"study", "which specimens, and where they are measured"},
    {"specimen", "boundaries and preparation"},
    {"shear", "stress paths after isotropic compression"},
};

constexpr const char* introduction =
    R"(# SPDX-License-Identifier: GPL-3.0-or-later
# Every key of a scene, each at its default: the study that `granum verify` runs when it is given no scene.
#
#   granum plan   --scene examples/scene.toml        what would run, with predicted time and memory
#   granum verify --scene examples/scene.toml        the study itself
#
# Copy what you want to change; a key that is left out keeps its default, an unknown one is refused with its
# line. Quantities with a dimension are texts with a unit. `--set grain.radius=0.4mm` overrides a key of the
# file. A key that a command does not take may be given at its default; another value would be ignored and is
# refused.
)";

/// Comment above a key of the example: its meaning, its range, and the commands that use it, unless all do.
std::string comment_of(const SceneKey& key) {
  const std::string comment = key.description();
  if (key.commands.size() == all_scene_commands.size())
    return comment;
  std::string takers;
  for (const SceneCommand command : key.commands)
    takers += (takers.empty() ? "" : ", ") + std::string(name(command));
  return comment + "; " + takers + " only";
}

} // namespace

std::string toml_text(const KeyValue& value, Dimension dimension, bool short_units) {
  const auto quantity = [&](double number) { return quantity_text(number, dimension, short_units); };
  return std::visit(
      [&](const auto& v) -> std::string {
        using Value = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<Value, double>)
          return quantity(v);
        else if constexpr (std::is_same_v<Value, std::uint64_t>)
          return std::to_string(v);
        else if constexpr (std::is_same_v<Value, std::string>)
          return quoted(v);
        else if constexpr (std::is_same_v<Value, std::vector<double>>)
          return list_text(v, quantity);
        else
          return list_text(v, quoted);
      },
      value);
}

std::string toml_of(const Scene& scene) {
  std::string text;
  for (const Section& section : sections) {
    text += (text.empty() ? "[" : "\n[") + std::string(section.name) + "]\n";
    for (const SceneKey& key : scene_keys())
      if (key.section() == section.name)
        text += key.name_in_section() + " = " + toml_text(key.get(scene), key.dimension) + "\n";
  }
  return text;
}

std::string commented_default_toml() {
  std::string text = introduction;
  for (const Section& section : sections) {
    text += "\n[" + std::string(section.name) + "] # " + section.meaning + "\n";
    for (const SceneKey& key : scene_keys())
      if (key.section() == section.name)
        text += "# " + comment_of(key) + "\n" + key.name_in_section() + " = " +
                toml_text(key.get(Scene{}), key.dimension, true) + "\n";
  }
  return text;
}

} // namespace granum::studies
