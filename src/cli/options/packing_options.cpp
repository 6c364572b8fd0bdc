// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_options.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/format.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/effective/relaxation.hpp>

#include "cli/frame/contradictions.hpp"
#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
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

/// A number whose value in the table has no origin has to be given, and so have its companions.
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

/// What people call the shapes: {"hertz", "sphere"}, {"rough", "cone or power-law"}.
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

contact::NormalLaw resolve_law(const PackingOptions& o) {
  require_belongs_to_contact(o);
  require_numbers_of_contact(o);
  contact::LawNumbers numbers;
  for (const auto& [row, parameter, number] : o.law_numbers)
    numbers[parameter->key] = number.value;
  return contact::law_of(o.contact, {o.grain_shear_modulus.value, o.grain_poisson_ratio.value},
                         resolve_radius(o) * resolve_contact_means(o).pair_radius, numbers);
}

namespace {

/// A share of the volume, 0 < value < 1; numbers in per cent are the usual slip.
double require_open_share(const Number& number) {
  const double value = number.value;
  if (!(value > 0 && value < 1))
    number.refuse_share("(0, 1)", 1);
  return value;
}

double resolve_void_ratio(const PackingOptions& o) {
  const int times_given = o.void_ratio.given() + o.porosity.given() + o.solid_fraction.given();
  if (times_given == 0)
    throw InvalidArgument("the density is missing: give one of --void-ratio, --porosity, --solid-fraction");
  if (times_given > 1)
    throw InvalidArgument(said_twice::density);
  if (o.porosity.given()) {
    const double porosity = require_open_share(o.porosity);
    return porosity / (1 - porosity);
  }
  if (o.solid_fraction.given()) {
    const double solid_fraction = require_open_share(o.solid_fraction);
    return (1 - solid_fraction) / solid_fraction;
  }
  return o.void_ratio.value;
}

} // namespace

void add_law_options(CLI::App& command, PackingOptions& o, const std::string& name) {
  std::vector<std::string> known;
  for (const contact::LawRow& row : contact::laws())
    known.emplace_back(contact::name(row.shape));
  add_number(command, "--grain-shear-modulus", o.grain_shear_modulus, "G_g of the grain's material");
  add_number(command, "--grain-poisson-ratio", o.grain_poisson_ratio, "nu_g of the grain's material");
  o.contact_option = command
                         .add_option_function<std::string>(
                             name, [&o](const std::string& text) { o.contact = *contact::find_shape(text); },
                             "Shape of the grains near their contacts")
                         ->transform(one_of(known, synonyms()))
                         ->default_str(std::string(contact::name(o.contact)));
  in_group(command, grains_group, {"--grain-shear-modulus", "--grain-poisson-ratio"});
  for (auto& [row, parameter, number] : o.law_numbers)
    (parameter->origin.empty() ? add_number_without_default : add_number)(command, parameter->option(),
                                                                          number, help_of(*row, *parameter))
        ->group(law_group);
  command.get_option(name.substr(0, name.find(',')))->group(law_group);
}

bool Number::given() const { return in_table || preset || (option != nullptr && option->count() > 0); }

const Number& PackingOptions::law_number(std::string_view key) const {
  return std::find_if(law_numbers.begin(), law_numbers.end(),
                      [key](const LawNumber& of) { return of.parameter->key == key; })
      ->number;
}

void Number::refuse_share(const std::string& range, double most) const {
  const auto has_sign = [](const std::string& text) { return text.find('%') != std::string::npos; };
  const bool typed =
      option != nullptr && std::any_of(option->results().begin(), option->results().end(), has_sign);
  const bool hint = value > most && value <= 100 * most && !per_cent && !typed;
  throw InvalidArgument(name, value, "",
                        hint ? fmt::format("{}; write {}% for per cent", range, short_text(value)) : range);
}

bool PackingOptions::contact_given() const { return contact_in_table || contact_option->count() > 0; }

CLI::Option* add_number(CLI::App& command, const std::string& name, Number& number, const std::string& help) {
  CLI::Option* option = add_quantity(command, name, number.value, number.dimension, help);
  number.name = name;
  number.option = option;
  return option;
}

CLI::Option* add_number_without_default(CLI::App& command, const std::string& name, Number& number,
                                        const std::string& help) {
  return add_number(command, name, number, help)->default_str("");
}

std::vector<Number*> numbers(PackingOptions& o) {
  std::vector<Number*> all;
  for (LawNumber& of : o.law_numbers)
    all.push_back(&of.number);
  all.insert(all.end(), {&o.grain_shear_modulus, &o.grain_poisson_ratio, &o.radius, &o.d50,
                         &o.tangential_ratio, &o.void_ratio, &o.porosity, &o.solid_fraction,
                         &o.coordination_number, &o.mechanical_coordination_number, &o.rattler_fraction,
                         &o.fabric, &o.pressure, &o.stress_v, &o.stress_h});
  return all;
}

void add_packing_options(CLI::App& command, PackingOptions& o) {
  add_number_without_default(command, "--void-ratio", o.void_ratio, "Volume of voids over that of grains");
  add_number_without_default(command, "--porosity", o.porosity,
                             "Share of voids in the volume, instead of --void-ratio");
  add_number_without_default(command, "--solid-fraction", o.solid_fraction,
                             "Share of grains in the volume, instead of --void-ratio");
  add_number_without_default(command, "--pressure", o.pressure, "Isotropic stress");
  add_number_without_default(command, "--stress-v", o.stress_v, "Vertical stress, with --stress-h");
  add_number_without_default(command, "--stress-h", o.stress_h, "Horizontal stress, with --stress-v");
  in_group(command, state_group,
           {"--void-ratio", "--porosity", "--solid-fraction", "--pressure", "--stress-v", "--stress-h"});
  add_number_without_default(command, "--coordination-number", o.coordination_number,
                             "C_n = 2 N_c/N, contacts per grain over all grains; by default those that "
                             "packings of this void ratio and stress have");
  add_number_without_default(command, "--mechanical-coordination-number", o.mechanical_coordination_number,
                             "z*, contacts per grain without rattlers");
  add_number_without_default(command, "--rattler-fraction", o.rattler_fraction,
                             "Share of grains that carry no force, instead of z* = C_n/(1 - share)");
  add_number(command, "--fabric", o.fabric, "a, anisotropy of the contact normals; > 0: more are vertical");
  in_group(command, contacts_group,
           {"--coordination-number", "--mechanical-coordination-number", "--rattler-fraction", "--fabric"});
  add_law_options(command, o);
  add_number_without_default(command, "--tangential-ratio", o.tangential_ratio,
                             "k_t/k_n of a contact; by default 2(1-nu_g)/(2-nu_g), no slip");
  in_group(command, law_group, {"--tangential-ratio"});
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
      throw InvalidArgument(said_twice::stress);
    if (o.pressure.value < 0)
      throw InvalidArgument("--pressure", o.pressure.value, "Pa", "[0, inf): compression is positive");
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
                                            : contact::mindlin_stiffness_ratio(o.grain_poisson_ratio.value),
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
  note_default(o.grain_poisson_ratio, grains);
  if (!o.d50.given() && !(o.sizes && o.sizes->mean_radius()))
    note_default(o.radius, o.sizes ? grains + ", their mean by number" : grains);
  if (!o.tangential_ratio.given())
    notes.push_back(fmt::format("assumed --tangential-ratio {}, the no-slip contact of Mindlin",
                                o.grain_poisson_ratio.in_table ? "2(1-nu_g)/(2-nu_g)"
                                                               : short_text(state.tangential_ratio)));
  note_default(o.fabric, ", contacts in all directions alike");
  constexpr double compared = 1.75; // the largest C_u of validation/sizes
  if (const double uniformity = o.sizes ? sizes::gradation(*o.sizes, 1).uniformity() : 1;
      uniformity > compared)
    notes.push_back(fmt::format("C_u is {}: which sizes touch was compared with packings up to {} alone",
                                short_text(uniformity), compared));
  if (o.sizes && !o.rattler_fraction.given() && !o.mechanical_coordination_number.given())
    notes.emplace_back(
        "contacts of unequal grains: which sizes touch is that of a packing without rattlers; rattlers are "
        "small, so that grains that touch are larger; --rattler-fraction sets their share");
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
