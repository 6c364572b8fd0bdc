// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "frame.hpp"

namespace granum::cli {

namespace {

using effective::State;

/// A number of the command line: its value in SI, by default until it is given.
struct Number {
  double value = 0;
  Dimension dimension = Dimension::dimensionless;
  std::string name = {};
  const CLI::Option* option = nullptr;

  [[nodiscard]] bool given() const { return option->count() > 0; }
};

/// Defaults: grains of Table 1 of [Chung2014] and the C_n of its dense spheres (Table 2); cone and punch are
/// those that agree with its Table 5. Numbers without a default are 0 and never used unless given.
struct Options {
  std::string contact = "sphere";
  const CLI::Option* contact_option = nullptr;
  Number slope{0.4};
  Number punch_radius{5.7e-6, Dimension::length};
  Number alpha;
  Number profile_constant;
  Number grain_shear_modulus{30e9, Dimension::pressure};
  Number grain_poisson_ratio{0.15};
  Number radius{0.5e-3, Dimension::length};
  Number tangential_ratio;
  Number void_ratio;
  Number porosity;
  Number solid_fraction;
  Number coordination_number{5.73};
  Number fabric;
  Number pressure{0, Dimension::pressure};
  Number stress_v{0, Dimension::pressure};
  Number stress_h{0, Dimension::pressure};
  OutputOptions output;
};

/// C_n of the weakly coordinated spheres of [Chung2014], Table 2, at e = 0.572.
constexpr double loose_coordination_number = 3.5;

void require_belongs_to_contact(const Options& o) {
  const std::pair<const Number*, std::string_view> owners[] = {{&o.slope, "cone"},
                                                               {&o.punch_radius, "flat"},
                                                               {&o.alpha, "power-law"},
                                                               {&o.profile_constant, "power-law"}};
  for (const auto& [number, contact] : owners)
    if (number->given() && o.contact != contact)
      throw InvalidArgument(
          fmt::format("{} goes with --contact {}, not with --contact {}", number->name, contact, o.contact));
}

/// A contact law, and its parameters for the report.
struct Contact {
  contact::PowerLaw law;
  nlohmann::ordered_json inputs;
};

Contact make_contact(const Options& o) {
  require_belongs_to_contact(o);
  const contact::GrainMaterial grain{.shear_modulus = o.grain_shear_modulus.value,
                                     .poisson_ratio = o.grain_poisson_ratio.value};
  if (o.contact == "cone")
    return {contact::PowerLaw::cone(grain, o.slope.value), {{"slope", o.slope.value}}};
  if (o.contact == "flat")
    return {contact::PowerLaw::flat(grain, o.punch_radius.value), {{"punch_radius", o.punch_radius.value}}};
  if (o.contact == "sphere")
    return {contact::PowerLaw::sphere(grain, o.radius.value), nlohmann::ordered_json::object()};
  if (!o.alpha.given() || !o.profile_constant.given())
    throw InvalidArgument("--contact power-law needs --alpha and --profile-constant");
  return {contact::PowerLaw::general(grain, o.alpha.value, o.profile_constant.value),
          {{"alpha", o.alpha.value}, {"profile_constant", o.profile_constant.value}}};
}

/// A share of the volume, 0 < value < 1; numbers in per cent are the usual slip.
double require_share(const Number& number) {
  const double value = number.value;
  if (!(value > 0 && value < 1))
    throw InvalidArgument(number.name, value, "",
                          value > 1 && value < 100 ? fmt::format("(0, 1); write {}% for per cent", value)
                                                   : "(0, 1)");
  return value;
}

double resolve_void_ratio(const Options& o) {
  const int times_given = o.void_ratio.given() + o.porosity.given() + o.solid_fraction.given();
  if (times_given != 1)
    throw InvalidArgument(fmt::format("the density is {}: give one of --void-ratio, --porosity, "
                                      "--solid-fraction",
                                      times_given == 0 ? "missing" : "given more than once"));
  if (o.porosity.given()) {
    const double porosity = require_share(o.porosity);
    return porosity / (1 - porosity);
  }
  if (o.solid_fraction.given()) {
    const double solid_fraction = require_share(o.solid_fraction);
    return (1 - solid_fraction) / solid_fraction;
  }
  return o.void_ratio.value;
}

struct Stresses {
  double v;
  double h;
};

Stresses resolve_stresses(const Options& o) {
  if (o.pressure.given()) {
    if (o.stress_v.given() || o.stress_h.given())
      throw InvalidArgument("--pressure sets both stresses: leave out --stress-v and --stress-h");
    require_non_negative("--pressure", o.pressure.value, "Pa");
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

std::vector<std::string> assumptions(const Options& o, const State& state) {
  std::vector<std::string> notes;
  const auto note_default = [&notes](const Number& number, const std::string& remark) {
    if (!number.given())
      notes.push_back(
          fmt::format("assumed {} {}{}", number.name, pretty(number.value, number.dimension), remark));
  };
  if (o.contact_option->count() == 0)
    notes.emplace_back("assumed --contact sphere");
  if (o.contact == "cone")
    note_default(o.slope, ", fitted to Table 5 of Chung et al. 2014");
  if (o.contact == "flat")
    note_default(o.punch_radius, ", fitted to Table 5 of Chung et al. 2014");
  const std::string grains = ", as the grains of Chung et al. 2014, Table 1";
  note_default(o.grain_shear_modulus, grains);
  note_default(o.grain_poisson_ratio, grains);
  note_default(o.radius, grains);
  if (!o.tangential_ratio.given())
    notes.push_back(fmt::format("assumed --tangential-ratio {}, the no-slip contact of Mindlin",
                                short_text(state.tangential_ratio)));
  note_default(o.fabric, ", contacts in all directions alike");
  if (!o.coordination_number.given()) {
    // A modulus goes as C_n k_n(f) with f ~ 1/C_n.
    const double loose =
        std::pow(loose_coordination_number / state.coordination_number, 1 - state.law.stiffness_exponent());
    notes.push_back(fmt::format("assumed --coordination-number {}, a dense packing (spheres of Chung et al. "
                                "2014, Table 2, void ratio 0.558)",
                                short_text(state.coordination_number)));
    notes.push_back(
        fmt::format("prepared loosely, the same void ratio can go with a coordination number of {} "
                    "and at most {} of these moduli",
                    loose_coordination_number, short_text(loose, 2)));
  }
  if (state.stress_v == 0 && state.stress_h == 0)
    notes.emplace_back("m, n and s at zero stress are their limit on the isotropic path");
  return notes;
}

EstimateCase resolve(const Options& o) {
  const Contact contact = make_contact(o);
  const Stresses stress = resolve_stresses(o);
  const State state{.law = contact.law,
                    .tangential_ratio = o.tangential_ratio.given()
                                            ? contact::given_stiffness_ratio(o.tangential_ratio.value)
                                            : contact::mindlin_stiffness_ratio(o.grain_poisson_ratio.value),
                    .radius = o.radius.value,
                    .void_ratio = resolve_void_ratio(o),
                    .coordination_number = o.coordination_number.value,
                    .fabric_anisotropy = o.fabric.value,
                    .stress_v = stress.v,
                    .stress_h = stress.h};
  effective::require_valid(state);
  EstimateCase question{
      .state = state, .contact = {{"contact", o.contact}}, .assumptions = assumptions(o, state)};
  question.contact.update(contact.inputs);
  return question;
}

/// The state at which exponents are taken: they depend on the stress ratio alone, which at zero stress is
/// that of the isotropic path.
State loaded(State state) {
  if (state.stress_v == 0 && state.stress_h == 0)
    state.stress_v = state.stress_h = 1;
  return state;
}

/// Of a stiffness that is not positive definite, Young's moduli are the limit or do not exist.
void check_stiffness(const elastic::TransverselyIsotropic& c, const char* hypothesis, Validity& validity) {
  for (const double value : {c.C11, c.C33, c.C12, c.C13, c.C44})
    if (!std::isfinite(value))
      throw InvalidArgument("the moduli exceed what a double can hold; check the units of the inputs");
  if (!young_modulus(c, Loading::vertical))
    validity.add(fmt::format("Young's moduli under {} do not exist: the stiffness is not positive definite",
                             hypothesis));
}

void keep_each_once(Validity& validity) {
  std::vector<std::string> once;
  for (const std::string& note : validity.notes)
    if (std::find(once.begin(), once.end(), note) == once.end())
      once.push_back(note);
  validity.notes = once;
}

EstimateAnswer solve(const State& state) {
  const effective::Estimate strain = effective::uniform_strain(state);
  const effective::Estimate stress = effective::uniform_stress(state);
  constexpr effective::Modulus G_hv = effective::Modulus::G_vh; // equal, by the symmetry of the stiffness
  EstimateAnswer answer{
      .uniform_strain = {strain.stiffness, effective::uniform_strain_exponents(loaded(state), G_hv)},
      .uniform_stress = {stress.stiffness, std::nullopt},
      .validity = strain.validity};
  if (state.tangential_ratio > 0)
    answer.uniform_stress.exponents = effective::uniform_stress_exponents(loaded(state), G_hv);
  answer.validity.merge(stress.validity);
  check_stiffness(strain.stiffness, "uniform strain", answer.validity);
  check_stiffness(stress.stiffness, "uniform stress", answer.validity);
  keep_each_once(answer.validity);
  return answer;
}

ExitCode run(const Options& options) {
  const EstimateCase question = resolve(options);
  const EstimateAnswer answer = solve(question.state);
  return deliver(options.output, estimate_table(question, answer), estimate_json(question, answer),
                 answer.validity);
}

CLI::Option* add_number(CLI::App& command, const std::string& name, Number& number, const std::string& help) {
  CLI::Option* option = add_quantity(command, name, number.value, number.dimension, help);
  number.name = name;
  number.option = option;
  return option;
}

/// A number that has no default to show.
void add_number_without_default(CLI::App& command, const std::string& name, Number& number,
                                const std::string& help) {
  add_number(command, name, number, help)->default_str("");
}

void add_contact_options(CLI::App& command, Options& o) {
  o.contact_option = command.add_option("--contact", o.contact, "Shape of the grains near their contacts")
                         ->check(CLI::IsMember({"cone", "sphere", "flat", "power-law"}))
                         ->capture_default_str();
  add_number(command, "--slope", o.slope, "Cone: A_1, tangent of the flank angle");
  add_number(command, "--punch-radius", o.punch_radius, "Flat: radius of the contact");
  add_number_without_default(command, "--alpha", o.alpha, "Power-law: alpha >= 1 of the profile A r^alpha");
  add_number_without_default(command, "--profile-constant", o.profile_constant,
                             "Power-law: A in SI, m^(1-alpha), without unit");
}

void add_packing_options(CLI::App& command, Options& o) {
  add_number(command, "--grain-shear-modulus", o.grain_shear_modulus, "G_g of the grain's material");
  add_number(command, "--grain-poisson-ratio", o.grain_poisson_ratio, "nu_g of the grain's material");
  add_number(command, "--radius", o.radius, "Radius of the grains");
  add_number_without_default(command, "--tangential-ratio", o.tangential_ratio,
                             "k_t/k_n of a contact; by default 2(1-nu_g)/(2-nu_g), no slip");
  add_number_without_default(command, "--void-ratio", o.void_ratio, "Volume of voids over that of grains");
  add_number_without_default(command, "--porosity", o.porosity,
                             "Share of voids in the volume, instead of --void-ratio");
  add_number_without_default(command, "--solid-fraction", o.solid_fraction,
                             "Share of grains in the volume, instead of --void-ratio");
  add_number(command, "--coordination-number", o.coordination_number,
             "C_n = 2 N_c/N, contacts per grain over all grains");
  add_number(command, "--fabric", o.fabric, "a, anisotropy of the contact normals; > 0: more are vertical");
  add_number_without_default(command, "--pressure", o.pressure, "Isotropic stress");
  add_number_without_default(command, "--stress-v", o.stress_v, "Vertical stress, with --stress-h");
  add_number_without_default(command, "--stress-h", o.stress_h, "Horizontal stress, with --stress-v");
}

} // namespace

std::optional<double> young_modulus(const elastic::TransverselyIsotropic& stiffness, Loading loading) {
  if (stiffness.positive_definite())
    return loading == Loading::vertical ? stiffness.E_v() : stiffness.E_h();
  const bool without_shear_stiffness = stiffness.C44 == 0 && stiffness.C66() == 0;
  return without_shear_stiffness ? std::optional(0.0) : std::nullopt;
}

Command add_estimate(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "estimate", "Closed-form stiffness of a packing at one state, and how it grows with stress");
  add_contact_options(*command, *options);
  add_packing_options(*command, *options);
  add_output_options(*command, options->output);
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
