// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_options.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/core.h>
#include <fmt/format.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/elastic/isotropic.hpp>

#include "cli/frame/contradictions.hpp"
#include "likely_mistakes.hpp"
#include "size_options.hpp"

namespace granum::cli {

namespace {

using effective::State;
using nlohmann::ordered_json;

void require_belongs_to_contact(const PackingOptions& o) {
  for (const auto& [row, parameter, number] : o.law_numbers)
    if (number.given() && o.contact != row->shape)
      throw InvalidArgument(belongs_to_other_contact(number.name, name(row->shape), name(o.contact)));
}

/// A number without a published default has to be given, together with its companions.
void require_numbers_of_contact(const PackingOptions& o) {
  std::vector<std::string> needed;
  bool missing = false;
  for (const auto& [row, parameter, number] : o.law_numbers)
    if (row->shape == o.contact && parameter->origin.empty()) {
      needed.push_back(number.name);
      missing = missing || !number.given();
    }
  if (missing)
    throw InvalidArgument(fmt::format("--contact {} needs {}", name(o.contact), fmt::join(needed, " and ")));
}

/// "Cone: A_1, tangent of the flank angle".
std::string help_of(const contact::LawRow& row, const contact::LawParameter& parameter) {
  std::string shape(name(row.shape));
  shape.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(shape.front())));
  const std::string unit = parameter.unit.empty() ? "" : fmt::format("; in SI, {}", parameter.unit);
  return fmt::format("{}: {}, {}{}", shape, parameter.symbol, parameter.help, unit);
}

/// Other names of the shapes: {"hertz", "sphere"}, {"rough", "cone or power-law"}.
OtherWords synonyms() {
  OtherWords out;
  for (const contact::LawRow& row : contact::laws())
    for (const std::string& word : row.synonyms) {
      const auto known =
          std::find_if(out.begin(), out.end(), [&](const auto& of) { return of.first == word; });
      if (known != out.end())
        known->second += " or " + std::string(name(row.shape));
      else
        out.emplace_back(word, std::string(name(row.shape)));
    }
  return out;
}

} // namespace

std::vector<LawNumber> law_numbers() {
  std::vector<LawNumber> out;
  for (const contact::LawRow& row : contact::laws())
    for (const contact::LawParameter& parameter : row.parameters)
      out.push_back({&row, &parameter, Number{parameter.value, parameter.dimension}});
  return out;
}

contact::GrainMaterial grain_of(const PackingOptions& o) {
  const Number &bulk = o.grain_bulk_modulus, &ratio = o.grain_poisson_ratio;
  if (!bulk.given())
    return {o.grain_shear_modulus.value, ratio.value};
  if (ratio.given() && !ratio.preset)
    throw InvalidArgument(estimate::with_options(estimate::conflict::grain));
  require_positive(bulk.name, bulk.value, "Pa");
  require_positive(o.grain_shear_modulus.name, o.grain_shear_modulus.value, "Pa");
  return {o.grain_shear_modulus.value,
          elastic::Isotropic::from_bulk_and_shear(bulk.value, o.grain_shear_modulus.value).poisson_ratio()};
}

contact::NormalLaw resolve_law(const PackingOptions& o) {
  require_belongs_to_contact(o);
  require_numbers_of_contact(o);
  contact::LawNumbers numbers;
  for (const auto& [row, parameter, number] : o.law_numbers)
    numbers[parameter->key] = number.value;
  return contact::law_of(o.contact, grain_of(o), resolve_radius(o) * resolve_contact_means(o).pair_radius,
                         numbers);
}

namespace {

/// A share of the volume whose void ratio is possible.
double require_open_share(const Number& number) {
  const double least = estimate::row_of(Input::void_ratio).limits.low;
  return require_closed(number.name, require_within(number), least, 1 - least);
}

double resolve_void_ratio(const PackingOptions& o) {
  const int times_given = o.void_ratio.given() + o.porosity.given() + o.solid_fraction.given();
  if (times_given == 0)
    throw InvalidArgument("the density is missing: give one of --void-ratio, --porosity, --solid-fraction");
  if (times_given > 1)
    throw InvalidArgument(estimate::with_options(estimate::conflict::density));
  if (o.porosity.given()) {
    const double porosity = require_open_share(o.porosity);
    return porosity / (1 - porosity);
  }
  if (o.solid_fraction.given()) {
    const double solid_fraction = require_open_share(o.solid_fraction);
    return (1 - solid_fraction) / solid_fraction;
  }
  return require_within(o.void_ratio);
}

} // namespace

namespace {

constexpr Number PackingOptions::*all_packing_numbers[] = {&PackingOptions::grain_shear_modulus,
                                                           &PackingOptions::grain_poisson_ratio,
                                                           &PackingOptions::grain_bulk_modulus,
                                                           &PackingOptions::radius,
                                                           &PackingOptions::d50,
                                                           &PackingOptions::tangential_ratio,
                                                           &PackingOptions::void_ratio,
                                                           &PackingOptions::porosity,
                                                           &PackingOptions::solid_fraction,
                                                           &PackingOptions::coordination_number,
                                                           &PackingOptions::mechanical_coordination_number,
                                                           &PackingOptions::rattler_fraction,
                                                           &PackingOptions::fabric,
                                                           &PackingOptions::pressure,
                                                           &PackingOptions::stress_v,
                                                           &PackingOptions::stress_h};

/// All numbers of a group in help.
void add_group(Command& command, PackingOptions& o, std::string_view group) {
  for (Number PackingOptions::*const number : all_packing_numbers)
    if ((o.*number).input->group == group)
      command.add(input_option(o.*number));
}

} // namespace

void add_packing_number(Command& command, PackingOptions& o, std::string_view name) {
  for (Number PackingOptions::*const number : all_packing_numbers)
    if ((o.*number).name == name)
      command.add(input_option(o.*number));
}

void add_law_options(Command& command, PackingOptions& o, const std::string& name) {
  std::vector<std::string> known;
  for (const contact::LawRow& row : contact::laws())
    known.emplace_back(contact::name(row.shape));
  add_group(command, o, grains_group);
  Value shape = choice(
      known,
      [&o](const std::string& text) {
        o.contact = *contact::find_shape(text);
        o.contact_typed = true;
      },
      synonyms());
  shape.by_default = contact::name(o.contact);
  command.add(law_group, {{.name = name,
                           .value = std::move(shape),
                           .meaning = "Shape of the grains near their contacts",
                           .synonyms = {{"shape law model contactlaw contactmodel"}}}});
  for (auto& [row, parameter, of_law] : o.law_numbers)
    command.add(law_group, {{.name = parameter->option(),
                             .value = (parameter->origin.empty() ? number_without_default : number)(of_law),
                             .meaning = help_of(*row, *parameter),
                             .belongs = {{"--contact", contact::name(row->shape), "sphere"}}}});
}

const Number& PackingOptions::law_number(std::string_view key) const {
  return std::find_if(law_numbers.begin(), law_numbers.end(),
                      [key](const LawNumber& of) { return of.parameter->key == key; })
      ->number;
}

std::span<Number PackingOptions::*const> packing_numbers() { return all_packing_numbers; }

std::vector<Number*> numbers(PackingOptions& o) {
  std::vector<Number*> all;
  for (LawNumber& of : o.law_numbers)
    all.push_back(&of.number);
  for (Number PackingOptions::*const number : all_packing_numbers)
    all.push_back(&(o.*number));
  return all;
}

void add_packing_options(Command& command, PackingOptions& o) {
  add_group(command, o, state_group);
  add_group(command, o, contacts_group);
  add_law_options(command, o);
  add_group(command, o, law_group);
  add_group(command, o, sizes_group);
  add_size_options(command, o);
}

void require_density_or_stress(const PackingOptions& o) {
  const bool density = o.void_ratio.given() || o.porosity.given() || o.solid_fraction.given();
  const bool stress = o.pressure.given() || o.stress_v.given() || o.stress_h.given();
  if (!density && !stress)
    throw InvalidArgument(
        "density and stress are missing: give --void-ratio, --porosity or --solid-fraction, "
        "and --pressure, or --stress-v and --stress-h");
}

stress::AxialStress resolve_stresses(const PackingOptions& o) {
  if (o.pressure.given()) {
    if (o.stress_v.given() || o.stress_h.given())
      throw InvalidArgument(estimate::with_options(estimate::conflict::stress));
    require_within(o.pressure);
    return {o.pressure.value, o.pressure.value};
  }
  if (!o.stress_v.given() && !o.stress_h.given())
    throw InvalidArgument("the stress is missing: give --pressure, or --stress-v and --stress-h");
  if (!o.stress_v.given() || !o.stress_h.given())
    throw InvalidArgument(fmt::format("{} is missing: --stress-v and --stress-h go together, or give "
                                      "--pressure for both",
                                      (o.stress_v.given() ? o.stress_h : o.stress_v).name));
  return {o.stress_v.value, o.stress_h.value};
}

namespace {

std::optional<double> if_given(const Number& number) {
  return number.given() ? std::optional(number.value) : std::nullopt;
}

} // namespace

State resolve_state(const PackingOptions& o, const stress::AxialStress& stress) {
  const State state{.law = resolve_law(o),
                    .tangential_ratio = o.tangential_ratio.given()
                                            ? contact::given_stiffness_ratio(o.tangential_ratio.value)
                                            : contact::mindlin_stiffness_ratio(grain_of(o).poisson_ratio),
                    .radius = resolve_radius(o),
                    .void_ratio = resolve_void_ratio(o),
                    .coordination_number = if_given(o.coordination_number),
                    .mechanical_coordination_number = if_given(o.mechanical_coordination_number),
                    .fabric_anisotropy = o.fabric.value,
                    .stress_v = stress.v,
                    .stress_h = stress.h,
                    .contacts = resolve_contact_means(o)};
  effective::require_valid(state);
  return state;
}

std::vector<std::string> assumed_grains(const PackingOptions& o, const State& state) {
  std::vector<std::string> notes;
  const auto note_default = [&notes](const Number& number, const std::string& remark) {
    if (!number.given())
      notes.push_back(
          fmt::format("assumed {} {}{}", number.name, pretty(number.value, number.dimension), remark));
  };
  if (!o.contact_given())
    notes.emplace_back("assumed --contact sphere");
  for (const auto& [row, parameter, number] : o.law_numbers)
    if (row->shape == o.contact)
      note_default(number, ", " + parameter->origin);
  const std::string grains = ", as the grains of Chung et al. 2014, Table 1";
  note_default(o.grain_shear_modulus, grains);
  if (!o.grain_bulk_modulus.given())
    note_default(o.grain_poisson_ratio, grains);
  if (!o.d50.given() && !(o.sizes && o.sizes->mean_radius()))
    note_default(o.radius, o.sizes ? grains + ", their mean by number" : grains);
  if (!o.tangential_ratio.given())
    notes.push_back(fmt::format("assumed --tangential-ratio {}, the no-slip contact of Mindlin",
                                (o.grain_poisson_ratio.in_table || o.grain_bulk_modulus.in_table)
                                    ? "2(1-nu_g)/(2-nu_g)"
                                    : short_text(state.tangential_ratio)));
  note_default(o.fabric, ", isotropic contact directions");
  constexpr double compared = 1.75; // the largest C_u of validation/sizes
  if (const double uniformity = o.sizes ? sizes::gradation(*o.sizes, 1).uniformity() : 1;
      uniformity > compared)
    notes.push_back(fmt::format("C_u is {}: the sizes in contact were validated with packings only up to {}",
                                short_text(uniformity), compared));
  if (o.sizes && !o.rattler_fraction.given() && !o.mechanical_coordination_number.given())
    notes.emplace_back("contacts of unequal grains: the sizes in contact are those of a packing without "
                       "rattlers; rattlers are small, so grains in contact are larger than average; "
                       "--rattler-fraction sets the share of rattlers");
  return notes;
}

ordered_json packing_json(const PackingOptions& o, const State& s) {
  ordered_json json = {{"contact", name(o.contact)}};
  for (const auto& [row, parameter, number] : o.law_numbers)
    if (row->shape == o.contact)
      json[parameter->name] = number.value;
  json.update({{"grain_shear_modulus", s.law.grain().shear_modulus},
               {"grain_poisson_ratio", s.law.grain().poisson_ratio},
               {"radius", s.radius},
               {"tangential_ratio", s.tangential_ratio},
               {"void_ratio", s.void_ratio},
               {"fabric", s.fabric_anisotropy}});
  if (s.coordination_number)
    json["coordination_number"] = *s.coordination_number;
  if (s.mechanical_coordination_number)
    json["mechanical_coordination_number"] = *s.mechanical_coordination_number;
  json.update(sizes_json(o, s.contacts));
  return json;
}

} // namespace granum::cli
