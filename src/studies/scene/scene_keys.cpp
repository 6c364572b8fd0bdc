// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/scene/scene_keys.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <type_traits>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/sizes/distribution.hpp>

namespace granum::studies {

namespace {

using stress::ShearPath;
using triaxial::Density;
using Commands = std::vector<SceneCommand>;

const Commands all_commands{all_scene_commands.begin(), all_scene_commands.end()};
const Commands all_but_trade{SceneCommand::verify, SceneCommand::plan, SceneCommand::reproduce,
                             SceneCommand::export_lammps};
const Commands reproduce_alone{SceneCommand::reproduce};

/// Suffix of the name of a quantity in JSON: "_Pa".
std::string unit_suffix(Dimension dimension) {
  switch (dimension) {
  case Dimension::dimensionless:
    return "";
  case Dimension::density:
    return "_kg_per_m3";
  default:
    return "_" + std::string(si_symbol(dimension));
  }
}

// ---- conditions of a key on other keys

std::string always(const Scene& /*scene*/) { return {}; }

template <class List, class Value>
std::string missing_in(const List& list, Value wanted, const std::string& what) {
  return std::find(list.begin(), list.end(), wanted) != list.end() ? std::string{} : what;
}

std::function<std::string(const Scene&)> needs_contact(contact::Shape shape) {
  return [shape](const Scene& scene) {
    return missing_in(scene.study.contacts, shape, std::string(name(shape)) + " in study.contacts");
  };
}

std::string needs_loose(const Scene& scene) {
  return missing_in(scene.study.densities, Density::loose, "loose in study.densities");
}

std::string needs_walls(const Scene& scene) {
  return scene.specimen.walls ? "" : "specimen.boundary = walls";
}

std::string needs_path(const Scene& scene) {
  return scene.shear.paths.empty() ? "a path in shear.paths" : "";
}

// ---- makers of keys

/// Common part of all kinds of keys; `member` gives the value within a scene, which may be const.
struct Head {
  std::string name;
  std::string meaning;
  Commands commands = all_commands;
  std::function<std::string(const Scene&)> missing = always;
};

SceneKey key_of(const Head& head, Dimension dimension = Dimension::dimensionless,
                const std::string& suffix = {}) {
  SceneKey key;
  key.name = head.name;
  key.meaning = head.meaning;
  key.dimension = dimension;
  key.json_name = key.name_in_section() + (suffix.empty() ? unit_suffix(dimension) : suffix);
  key.commands = head.commands;
  key.missing = head.missing;
  return key;
}

template <class Member>
SceneKey quantity(const Head& head, Member member, Dimension dimension, const KeyRange& range,
                  const std::string& suffix = {}) {
  SceneKey key = key_of(head, dimension, suffix);
  key.range = range;
  key.set = [member, dimension, name = key.name](Scene& scene, const std::string& text) {
    member(scene) = parse_quantity(name, text, dimension);
  };
  key.get = [member](const Scene& scene) { return KeyValue(static_cast<double>(member(scene))); };
  key.resolved = key.get;
  return key;
}

constexpr const char* mindlin = "mindlin";

SceneKey tangential_ratio_key(const Head& head, const KeyRange& range) {
  SceneKey key = key_of(head);
  key.range = range;
  key.set = [name = key.name](Scene& scene, const std::string& text) {
    scene.contact.tangential_ratio =
        text == mindlin ? std::nullopt : std::optional(parse_quantity(name, text, Dimension::dimensionless));
  };
  key.get = [](const Scene& scene) {
    const std::optional<double>& ratio = scene.contact.tangential_ratio;
    return ratio ? KeyValue(*ratio) : KeyValue(std::string(mindlin));
  };
  key.resolved = [](const Scene& scene) { return KeyValue(tangential_ratio(scene)); };
  return key;
}

template <class Member>
SceneKey whole_number(const Head& head, Member member, const KeyRange& range) {
  SceneKey key = key_of(head);
  key.range = range;
  key.set = [member, range, name = key.name](Scene& scene, const std::string& text) {
    const double value = parse_quantity(name, text, Dimension::dimensionless);
    if (!(value >= 0 && value <= 9e15) || value != std::floor(value))
      throw InvalidArgument(name + " = " + text + " is not a whole number in " +
                            studies::text(range, Dimension::dimensionless));
    auto& target = member(scene);
    target = static_cast<std::remove_reference_t<decltype(target)>>(value);
  };
  key.get = [member](const Scene& scene) { return KeyValue(static_cast<std::uint64_t>(member(scene))); };
  key.resolved = key.get;
  return key;
}

/// The items of "dense,loose", or of the same list in brackets; none of "[]".
std::vector<std::string> items_of(const std::string& text) {
  std::string list(trimmed(text));
  if (list.starts_with('[') && list.ends_with(']'))
    list = trimmed(std::string_view(list).substr(1, list.size() - 2));
  std::vector<std::string> items;
  std::istringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');)
    items.emplace_back(trimmed(item));
  return items;
}

template <class Member>
SceneKey pressures(const Head& head, Member member, const KeyRange& range) {
  SceneKey key = key_of(head, Dimension::pressure);
  key.range = range;
  key.set = [member, name = key.name](Scene& scene, const std::string& text) {
    std::vector<double> values;
    for (const std::string& item : items_of(text))
      values.push_back(parse_quantity(name, item, Dimension::pressure));
    member(scene) = values;
  };
  key.get = [member](const Scene& scene) { return KeyValue(member(scene)); };
  key.resolved = key.get;
  return key;
}

/// A choice among named values.
template <class Value>
Value named(const std::string& key, const std::string& text, const std::vector<Value>& known) {
  std::vector<std::string> all;
  for (const Value value : known) {
    if (name(value) == text)
      return value;
    all.emplace_back(name(value));
  }
  throw InvalidArgument(unknown_word(key + ":", text, all));
}

template <class Value, class Member>
SceneKey names(const Head& head, Member member, std::vector<Value> known) {
  SceneKey key = key_of(head);
  key.set = [member, known, name = key.name](Scene& scene, const std::string& text) {
    std::vector<Value> values;
    for (const std::string& item : items_of(text))
      values.push_back(named(name, item, known));
    member(scene) = values;
  };
  key.get = [member](const Scene& scene) {
    std::vector<std::string> texts;
    for (const Value value : member(scene))
      texts.emplace_back(name(value));
    return KeyValue(texts);
  };
  key.resolved = key.get;
  return key;
}

SceneKey boundary_key(const Head& head) {
  SceneKey key = key_of(head);
  key.set = [name = key.name](Scene& scene, const std::string& text) {
    if (text != "periodic" && text != "walls")
      throw InvalidArgument(unknown_word(name + ":", text, std::vector<std::string>{"periodic", "walls"}));
    scene.specimen.walls = text == "walls";
  };
  key.get = [](const Scene& scene) {
    return KeyValue(std::string(scene.specimen.walls ? "walls" : "periodic"));
  };
  key.resolved = key.get;
  return key;
}

SceneKey sizes_key(const Head& head) {
  SceneKey key = key_of(head);
  key.set = [name = key.name](Scene& scene, const std::string& text) {
    const sizes::Distribution parsed = sizes::parse_distribution(text);
    if (parsed.mean_radius())
      throw InvalidArgument(
          name + ": a sieve curve has diameters of its own, and a scene has grain.radius; name the "
                 "uniformity coefficient, for instance uniformity:2.5");
    scene.grain.sizes = parsed;
  };
  key.get = [](const Scene& scene) { return KeyValue(scene.grain.sizes.text()); };
  key.resolved = key.get;
  return key;
}

/// The member of a scene, const or not.
#define GRANUM_MEMBER(member) ([](auto& scene) -> auto& { return scene.member; })

std::vector<SceneKey> grain_keys() {
  using enum Dimension;
  return {
      quantity({"grain.radius", "radius of all grains; mean by number if grain.sizes makes them unequal"},
               GRANUM_MEMBER(grain.radius), length,
               {.low = 1e-9,
                .high = 1e3,
                .reason = "its fifth power, as in moments of inertia, must fit into a double"}),
      sizes_key({"grain.sizes",
                 "distribution of the radii by number: equal, bidisperse:RATIO, uniform:SMALLEST:LARGEST, "
                 "lognormal:SIGMA, power-law:EXPONENT:RATIO or uniformity:C_U; RATIO: largest over smallest, "
                 "SIGMA: standard deviation of ln radius, C_U: d60/d10 by mass"}),
      quantity({"grain.shear_modulus", "G_g, shear modulus of the grain material"},
               GRANUM_MEMBER(grain.shear_modulus), pressure,
               {.low = 1,
                .high = 1e15,
                .reason = "all solids lie within, and products of stiffnesses must fit into a double"}),
      quantity({"grain.poisson_ratio", "nu, Poisson's ratio of the grain material"},
               GRANUM_MEMBER(grain.poisson_ratio), dimensionless,
               {.low = -1, .high = 0.5, .low_open = true, .reason = "the range of elastic solids"}),
      quantity({"grain.friction_angle", "friction angle of the contact between two grains"},
               GRANUM_MEMBER(grain.friction_angle), angle,
               {.low = 0,
                .high = std::numbers::pi / 2,
                .high_open = true,
                .reason = "its tangent must be finite"}),
      quantity({"grain.density",
                "density of the grain material; sets the time scale of the simulation, not its result"},
               GRANUM_MEMBER(grain.density), density,
               {.low = 1e-6,
                .high = 1e18,
                .reason = "masses and time steps, also scaled ones, must fit into a double"})};
}

/// A number of a contact law, as the table of laws has it.
SceneKey law_key(const contact::LawRow& row, const contact::LawParameter& parameter) {
  const std::string unit = parameter.unit.empty() ? "" : " in " + parameter.unit;
  const std::string origin = parameter.origin.empty() ? "" : "; " + parameter.origin;
  SceneKey key =
      key_of({"contact." + parameter.key,
              std::string(name(row.shape)) + ": " + parameter.symbol + unit + ", " + parameter.help + origin,
              all_commands, needs_contact(row.shape)},
             parameter.dimension, parameter.unit.empty() ? "" : "_SI");
  key.range = {.low = parameter.low, .high = parameter.high, .reason = parameter.reason};
  key.set = [&parameter, name = key.name](Scene& scene, const std::string& text) {
    scene.contact.numbers[parameter.key] = parse_quantity(name, text, parameter.dimension);
  };
  key.get = [&parameter](const Scene& scene) { return KeyValue(value_of(parameter, scene.contact.numbers)); };
  key.resolved = key.get;
  return key;
}

std::vector<SceneKey> contact_keys() {
  std::vector<SceneKey> keys{tangential_ratio_key(
      {"contact.tangential_ratio",
       "k_t/k_n, tangential over normal contact stiffness; mindlin: 2(1-nu)/(2-nu)"},
      {.low = 0,
       .high = 100,
       .reason = "elastic contacts have at most 4/3, and a larger ratio needs a smaller time step"})};
  for (const contact::LawRow& row : contact::laws())
    for (const contact::LawParameter& parameter : row.parameters)
      keys.push_back(law_key(row, parameter));
  return keys;
}

std::vector<SceneKey> study_keys() {
  std::vector<contact::Shape> shapes;
  for (const contact::LawRow& row : contact::laws())
    shapes.push_back(row.shape);
  const KeyRange stresses{
      .low = 1e-6, .high = 1e13, .reason = "forces and their squares must fit into a double"};
  return {
      names({"study.contacts", "any of " + contact::shape_names()}, GRANUM_MEMBER(study.contacts), shapes),
      names({"study.densities",
             "dense: compressed without friction up to the first pressure; loose: with friction"},
            GRANUM_MEMBER(study.densities), std::vector{Density::dense, Density::loose}),
      whole_number({"study.grains", "grains of each specimen"}, GRANUM_MEMBER(study.grains),
                   {.low = 40,
                    .high = 1e7,
                    .reason = "the cell must be wider than four diameters, and its "
                              "grains must fit into memory"}),
      whole_number({"study.seeds", "specimens of each contact and density"}, GRANUM_MEMBER(study.seeds),
                   {.low = 1, .high = 1000, .reason = "all specimens must fit into memory"}),
      whole_number({"study.first_seed", "seeds are first_seed, first_seed + 1, ..."},
                   GRANUM_MEMBER(study.first_seed),
                   {.low = 0, .high = 9e15, .reason = "whole numbers that a double can represent"}),
      whole_number({"study.threads",
                    "specimens computed at the same time; 0: one for each core; results do not depend on it"},
                   GRANUM_MEMBER(study.threads),
                   {.low = 0, .high = 1024, .reason = "more threads bring no gain"}),
      pressures({"study.pressures", "pressures of the isotropic compression: at least 3, increasing"},
                GRANUM_MEMBER(study.pressures), stresses),
      pressures({"study.probe_pressures",
                 "pressures at which G is also measured by small cyclic shear; [] for none", all_but_trade},
                GRANUM_MEMBER(study.probe_pressures), stresses)};
}

std::vector<SceneKey> specimen_keys() {
  using enum Dimension;
  return {boundary_key(
              {"specimen.boundary", "periodic: a periodic cell; walls: six rigid walls", reproduce_alone}),
          quantity({"specimen.wall_friction", "friction coefficient between grains and walls",
                    reproduce_alone, needs_walls},
                   GRANUM_MEMBER(specimen.wall_friction), dimensionless,
                   {.low = 0, .high = 1e6, .reason = "above it no contact slides"}),
          quantity({"specimen.expansion_void_ratio",
                    "void ratio of the fixed cell in which the grains are enlarged at the start"},
                   GRANUM_MEMBER(specimen.expansion_void_ratio), dimensionless,
                   {.low = 0.4,
                    .high = 1,
                    .low_open = true,
                    .high_open = true,
                    .reason = "equal spheres jam at void ratios in this range"}),
          quantity({"specimen.unjamming_strain",
                    "loose: linear strain that opens the jammed packing before friction is switched on",
                    all_commands, needs_loose},
                   GRANUM_MEMBER(specimen.unjamming_strain), dimensionless,
                   {.low = 0,
                    .high = 0.1,
                    .low_open = true,
                    .high_open = true,
                    .reason = "must open contacts without "
                              "dispersing the packing"}),
          quantity(
              {"specimen.agitation",
               "loose: random displacement of each grain after unjamming_strain, as a fraction of its radius",
               all_commands, needs_loose},
              GRANUM_MEMBER(specimen.agitation), dimensionless,
              {.low = 0, .high = 0.5, .reason = "neighbours must stay neighbours"})};
}

std::vector<SceneKey> shear_keys() {
  using enum Dimension;
  const auto steps = [](const char* name, const char* meaning) {
    return Head{name, meaning, reproduce_alone, needs_path};
  };
  return {
      names({"shear.paths", "any of TXC, RTXC, RTXE, TXE", reproduce_alone}, GRANUM_MEMBER(shear.paths),
            std::vector<ShearPath>{stress::all_shear_paths.begin(), stress::all_shear_paths.end()}),
      quantity(steps("shear.inertial_number",
                     "axial strain rate (or twice the horizontal one) times d sqrt(density/p'), d: mean "
                     "diameter"),
               GRANUM_MEMBER(shear.inertial_number), dimensionless,
               {.low = 1e-9,
                .high = 0.1,
                .high_open = true,
                .reason = "lower does not finish; higher is not "
                          "quasi-static"}),
      quantity(
          steps("shear.eta_step",
                "at each multiple of this q/p' a state is frozen (no contact slides) and its network solved"),
          GRANUM_MEMBER(shear.eta_step), dimensionless,
          {.low = 1e-5, .high = 10, .reason = "limits the number of states"}),
      quantity(steps("shear.strain_step", "the same at each multiple of this axial strain"),
               GRANUM_MEMBER(shear.strain_step), dimensionless,
               {.low = 1e-8, .high = 1, .reason = "limits the number of states"}),
      quantity(steps("shear.largest_strain", "axial strain at which a path ends"),
               GRANUM_MEMBER(shear.largest_strain), dimensionless,
               {.low = 1e-8, .high = 1, .high_open = true, .reason = "the height must stay positive"}),
      quantity(steps("shear.probe_eta_step", "cyclic shear at multiples of this q/p'; 0: none"),
               GRANUM_MEMBER(shear.probe_eta_step), dimensionless,
               {.low = 0, .high = 3, .reason = "q/p' of compression stays below 3"}),
      quantity(
          steps("shear.loop_strain",
                "amplitude of cyclic shear with friction (Fig. 8): TXC of the first contact, dense; 0: none"),
          GRANUM_MEMBER(shear.loop_strain), dimensionless,
          {.low = 0, .high = 0.01, .reason = "small strains"})};
}

#undef GRANUM_MEMBER

std::vector<SceneKey> all_keys() {
  std::vector<SceneKey> keys;
  for (std::vector<SceneKey> section :
       {grain_keys(), contact_keys(), study_keys(), specimen_keys(), shear_keys()})
    std::move(section.begin(), section.end(), std::back_inserter(keys));
  return keys;
}

/// An end of a range, in words where the number would be hard to read.
std::string end_text(double value, Dimension dimension) {
  return dimension == Dimension::angle && value == std::numbers::pi / 2 ? "pi/2" : short_text(value);
}

void require_in_range(const SceneKey& key, double value) {
  const KeyRange& range = key.range;
  if ((range.low_open ? value > range.low : value >= range.low) &&
      (range.high_open ? value < range.high : value <= range.high))
    return;
  throw InvalidArgument(key.name, value, std::string(si_symbol(key.dimension)),
                        text(range, key.dimension) + ": " + std::string(range.reason));
}

} // namespace

std::string_view name(SceneCommand command) {
  switch (command) {
  case SceneCommand::verify:
    return "verify";
  case SceneCommand::plan:
    return "plan";
  case SceneCommand::trade:
    return "trade";
  case SceneCommand::reproduce:
    return "reproduce";
  case SceneCommand::export_lammps:
    return "export lammps";
  }
  throw InvalidArgument("command does not use a scene");
}

std::string text(const KeyRange& range, Dimension dimension) {
  return (range.low_open ? "(" : "[") + end_text(range.low, dimension) + ", " +
         end_text(range.high, dimension) + (range.high_open ? ")" : "]");
}

bool SceneKey::taken_by(SceneCommand command) const {
  return std::find(commands.begin(), commands.end(), command) != commands.end();
}

std::string SceneKey::description() const {
  if (range.low == range.high)
    return meaning;
  const std::string_view unit = si_symbol(dimension);
  return meaning + "; in " + text(range, dimension) + (unit.empty() ? "" : " ") + std::string(unit);
}

std::span<const SceneKey> scene_keys() {
  static const std::vector<SceneKey> keys = all_keys();
  return keys;
}

const SceneKey& scene_key(const std::string& name) {
  std::vector<std::string> all;
  for (const SceneKey& key : scene_keys()) {
    if (key.name == name)
      return key;
    all.push_back(key.name);
  }
  throw InvalidArgument(unknown_word("key", name, all));
}

void require_in_range(const SceneKey& key, const Scene& scene) {
  const KeyValue value = key.get(scene);
  if (const auto* number = std::get_if<double>(&value))
    require_in_range(key, *number);
  if (const auto* number = std::get_if<std::uint64_t>(&value))
    require_in_range(key, static_cast<double>(*number));
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    for (const double number : *list)
      require_in_range(key, number);
}

} // namespace granum::studies
