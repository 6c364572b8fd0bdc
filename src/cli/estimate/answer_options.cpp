// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_options.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "cli/frame/contradictions.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/size_options.hpp"

namespace granum::cli {

namespace {

void set_unless_given(Number& number, double value) {
  if (number.given())
    return;
  number.value = value;
  number.preset = true;
}

template <class Items>
std::vector<std::string> keys_of(const Items& items) {
  std::vector<std::string> keys;
  for (const auto& item : items)
    keys.emplace_back(item.key);
  return keys;
}

/// e_min and e_max, or those of usual sands.
std::pair<double, double> void_ratio_limits(const AnswerOptions& o) {
  return o.usual_limits ? std::pair(sands::usual_least_void_ratio, sands::usual_largest_void_ratio)
                        : std::pair(o.least_void_ratio.value, o.largest_void_ratio.value);
}

double void_ratio_by_relative_density(const AnswerOptions& o) {
  const auto [least, largest] = void_ratio_limits(o);
  return sands::void_ratio_of_relative_density(require_within(o.relative_density), least, largest);
}

void apply_relative_density(PackingOptions& packing, AnswerOptions& o) {
  if (!o.relative_density.given())
    return;
  if (packing.void_ratio.given() || packing.porosity.given() || packing.solid_fraction.given())
    throw InvalidArgument(estimate::with_options(estimate::conflict::density));
  if (o.least_void_ratio.given() != o.largest_void_ratio.given())
    throw InvalidArgument("--least-void-ratio and --largest-void-ratio go together: give both, or neither");
  o.usual_limits = !o.least_void_ratio.given();
  if (o.usual_limits && told_shape(packing, o) != estimate::GrainShape::sand)
    throw InvalidArgument("--relative-density of spheres needs --least-void-ratio and --largest-void-ratio");
  set_unless_given(packing.void_ratio, void_ratio_by_relative_density(o));
}

/// sigma_h from sigma_v and K_0.
void apply_earth_pressure(PackingOptions& packing, const AnswerOptions& o) {
  const Number& k0 = o.earth_pressure_at_rest;
  if (!k0.given())
    return;
  require_within(k0);
  if (packing.stress_h.given() && !packing.stress_h.preset) {
    constexpr double rounding = 0.01; // a row of a table may have both, as far as they agree
    if (k0.in_table && std::abs(k0.value * packing.stress_v.value - packing.stress_h.value) <=
                           rounding * packing.stress_h.value)
      return;
    throw InvalidArgument("--k0 sets --stress-h from --stress-v: give one of the two");
  }
  if (!packing.stress_v.given())
    throw InvalidArgument("--k0 needs --stress-v");
  packing.stress_h.value = k0.value * packing.stress_v.value;
  packing.stress_h.preset = true;
}

// ---- uncertain inputs

double assumed_fabric(const PackingOptions& packing) {
  const stress::AxialStress stress = resolve_stresses(packing);
  return estimate::assumed_fabric_deviation(stress.v, stress.h);
}

/// The assumed deviation of a number that is not given, or that is set by the name of a mineral.
double assumed_deviation(const PackingOptions& packing, const AnswerOptions& o, const Number& number) {
  const estimate::AssumedDeviations& assumed = estimate::assumed_deviations;
  if (&number == &packing.void_ratio && o.usual_limits)
    return sands::usual_void_ratio_deviation;
  if (&number == &packing.grain_shear_modulus && o.mineral != nullptr && number.preset)
    return o.mineral->modulus_spread * number.value;
  if (number.given())
    return 0;
  return &number == &packing.grain_shear_modulus   ? assumed.grain_shear_modulus * number.value
         : &number == &packing.grain_poisson_ratio ? assumed.grain_poisson_ratio
         : &number == &packing.fabric              ? assumed_fabric(packing)
         : &number == &o.grain_density             ? assumed.grain_density
                                                   : 0;
}

/// Whether the question depends on this number: it is given, or its default is used.
bool in_use(const PackingOptions& o, const AnswerOptions& answer, const Number& n) {
  const Number* const defaults[] = {&o.grain_shear_modulus, &o.grain_poisson_ratio, &o.radius, &o.fabric,
                                    &answer.grain_density};
  const bool radius_known = o.d50.given() || (o.sizes && o.sizes->mean_radius());
  const bool by_default = std::find(std::begin(defaults), std::end(defaults), &n) != std::end(defaults) &&
                          !(&n == &o.radius && radius_known) &&
                          !(&n == &o.grain_poisson_ratio && o.grain_bulk_modulus.given());
  const bool of_contact = std::any_of(o.law_numbers.begin(), o.law_numbers.end(), [&](const LawNumber& of) {
    return &of.number == &n && of.row->shape == o.contact;
  });
  if (&n == &answer.earth_pressure_at_rest)
    return n.given() && o.stress_h.preset; // else it changes nothing
  return n.given() || by_default || of_contact;
}

double deviation_of(const std::string& name, const std::string& text, const Number& n) {
  if (!std::string_view(trimmed(text)).ends_with('%'))
    return require_non_negative(name, parse_quantity(name, text, n.dimension),
                                std::string(si_symbol(n.dimension)));
  const double share = require_non_negative(name, parse_quantity(name, text, Dimension::dimensionless));
  if (n.value == 0)
    throw InvalidArgument(
        fmt::format("{}={}: a percentage of {} = 0 is 0; give an absolute deviation", name, text, n.name));
  return share * std::abs(n.value);
}

/// A parsed setting of --uncertainty.
struct Setting {
  std::string key, deviation;
};

std::vector<Setting> settings_of(const std::vector<std::string>& texts,
                                 const std::vector<std::string>& known) {
  std::vector<Setting> settings;
  for (const std::string& text : texts) {
    const std::size_t split = text.find('=');
    if (split == std::string::npos)
      throw InvalidArgument("--uncertainty " + text + ": write key=sd, as in void-ratio=0.02");
    const std::string key(trimmed(std::string_view(text).substr(0, split)));
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw InvalidArgument(fmt::format("--uncertainty {}: not an input of this packing; its inputs are {}",
                                        key, fmt::join(known, ", ")));
    for (const Setting& other : settings)
      if (other.key == key)
        throw InvalidArgument("--uncertainty " + key + " is given twice");
    settings.push_back({key, text.substr(split + 1)});
  }
  return settings;
}

} // namespace

std::optional<estimate::GrainShape> told_shape(const PackingOptions& packing, const AnswerOptions& o) {
  using estimate::GrainShape;
  if (o.grain_shape)
    return o.grain_shape;
  if (o.sand != nullptr)
    return GrainShape::sand;
  const std::string_view mineral = o.mineral != nullptr ? o.mineral->key : "";
  if (mineral == "glass" || mineral == "steel")
    return GrainShape::sphere;
  std::vector<const Number*> all{&o.relative_density, &o.least_void_ratio, &o.largest_void_ratio, &o.strain};
  for (Number PackingOptions::*const number : packing_numbers())
    all.push_back(&(packing.*number));
  for (const GrainShape shape : {GrainShape::sand, GrainShape::sphere}) {
    const bool implied = std::any_of(all.begin(), all.end(), [shape](const Number* number) {
      return number->given() && number->input->implies == shape;
    });
    if (implied || (shape == GrainShape::sand ? packing.graded : packing.contact_given()))
      return shape;
  }
  return o.ground ? std::optional(GrainShape::sand) : std::nullopt;
}

sands::Sand sand_of(const PackingOptions& packing, const AnswerOptions& o) {
  sands::Sand sand;
  if (packing.sizes) {
    const sizes::Gradation grading = sizes::gradation(*packing.sizes, resolve_radius(packing));
    sand.uniformity = packing.uniformity.value_or(grading.uniformity());
    if (packing.sizes->mean_radius() || packing.d50.given() || packing.radius.given())
      sand.d50 = grading.d50;
  } else if (packing.d50.given() || packing.radius.given())
    sand.d50 = 2 * resolve_radius(packing);
  if (o.sand != nullptr) {
    if (!packing.sizes)
      sand.uniformity = o.sand->uniformity;
    sand.tests = o.sand->tests;
  }
  const auto typed = [](const Number& number) { return number.typed || number.in_table; };
  if (packing.sizes || typed(o.least_void_ratio) || typed(o.largest_void_ratio))
    sand.tests.reset(); // of another batch
  const auto given = [](const Number& number) {
    return number.given() ? std::optional(number.value) : std::nullopt;
  };
  sand.least_void_ratio = given(o.least_void_ratio);
  sand.largest_void_ratio = given(o.largest_void_ratio);
  sand.relative_density = given(o.relative_density);
  sand.quartz = o.mineral == nullptr || std::string_view(o.mineral->key) == "quartz" ||
                std::string_view(o.mineral->key) == "feldspar";
  return sand;
}

std::string key_of(const Number& number) { return number.name.substr(2); }

std::vector<Number*> movable(PackingOptions& packing, AnswerOptions& options) {
  std::vector<Number*> all = numbers(packing);
  all.push_back(&options.grain_density);
  all.push_back(&options.relative_density);
  all.push_back(&options.earth_pressure_at_rest);
  return all;
}

void add_answer_options(Command& command, AnswerOptions& o) {
  command.add(
      grains_group,
      {{.name = "--preparation",
        .value = read_by(
            [&o](const std::string& text) {
              o.preparation = effective::preparation_of(in_small_letters(text));
            },
            std::vector<std::string>{"dense", "loose", "friction:NUMBER"}),
        .group = contacts_group,
        .meaning =
            "How the packing was made, which determines its contacts: dense, loose (friction 0.3 to 0.5), "
            "friction:0.3",
        .synonyms = {{"mu friction frictioncoefficient"}}},
       {.name = "--grain",
        .value =
            read_by([&o](const std::string& text) { o.mineral = &contact::mineral(in_small_letters(text)); },
                    keys_of(contact::minerals())),
        .meaning = "Mineral of the grains: sets G_g, nu_g and density unless they are given",
        .synonyms = {{"mineral material solid"}}},
       {.name = "--sand",
        .value =
            read_by([&o](const std::string& text) { o.sand = &sands::known_sand(in_small_letters(text)); },
                    keys_of(sands::known_sands())),
        .meaning =
            "Sand by name: sets --grain, d50, C_u for laws measured on sands, and e_min and e_max, as far "
            "as published"},
       {.name = "--grain-shape",
        .value = read_by(
            [&o](const std::string& text) {
              o.grain_shape = estimate::grain_shape_of(in_small_letters(text));
            },
            std::vector<std::string>{"sphere", "sand"}),
        .meaning = "sand: result from laws measured on sands; sphere: result from the model of spheres; by "
                   "default as implied by other options, else both results"}});
  for (Number* const number :
       {&o.relative_density, &o.least_void_ratio, &o.largest_void_ratio, &o.grain_density, &o.saturation})
    command.add(input_option(*number));
}

void apply_presets(PackingOptions& packing, AnswerOptions& o) {
  if (o.sand != nullptr) {
    const sands::KnownSand& sand = *o.sand;
    if (o.mineral == nullptr)
      o.mineral = &contact::mineral(sand.mineral);
    const bool sized =
        packing.radius.given() || packing.d50.given() || (packing.sizes && packing.sizes->mean_radius());
    if (sand.d50 && !sized)
      set_unless_given(packing.d50, *sand.d50);
    if (sand.least_void_ratio)
      set_unless_given(o.least_void_ratio, *sand.least_void_ratio);
    if (sand.largest_void_ratio)
      set_unless_given(o.largest_void_ratio, *sand.largest_void_ratio);
  }
  if (o.mineral == nullptr && told_shape(packing, o) == estimate::GrainShape::sand)
    o.mineral = &contact::mineral("quartz");
  if (o.mineral != nullptr) {
    set_unless_given(packing.grain_shear_modulus, o.mineral->material.shear_modulus);
    set_unless_given(packing.grain_poisson_ratio, o.mineral->material.poisson_ratio);
    set_unless_given(o.grain_density, o.mineral->density);
  }
  apply_relative_density(packing, o);
  apply_earth_pressure(packing, o);
}

OptionRow uncertainty_row(std::vector<std::string>& settings) {
  Value value = texts(settings, "KEY=SD");
  value.joins_units = true;
  return {.name = "--uncertainty",
          .value = std::move(value),
          .meaning = "Standard deviation of an input, may be repeated. KEY is the name of its option: "
                     "void-ratio=0.02; or relative to its value: pressure=5%"};
}

estimate::Question question_of(const PackingOptions& packing, const AnswerOptions& o) {
  require_density_or_stress(packing);
  // A row of a table may contain all three numbers of contacts: C_n and z* are enough.
  const bool enough = packing.coordination_number.in_table && packing.mechanical_coordination_number.in_table;
  return {.state = resolve_state(packing, resolve_stresses(packing)),
          .preparation = o.preparation,
          .rattler_fraction = enough || !packing.rattler_fraction.given()
                                  ? std::nullopt
                                  : std::optional(require_within(packing.rattler_fraction)),
          .grain_density = require_within(o.grain_density),
          .saturation = require_within(o.saturation),
          .grain_shape = told_shape(packing, o).value_or(estimate::GrainShape::sphere),
          .sand = sand_of(packing, o),
          .shear_strain = o.strain.given() ? std::optional(require_within(o.strain)) : std::nullopt};
}

std::vector<estimate::UncertainInput> uncertain_inputs_of(const PackingOptions& given,
                                                          const AnswerOptions& given_options,
                                                          const std::vector<std::string>& texts) {
  PackingOptions packing = given;
  AnswerOptions options = given_options;
  const std::vector<Number*> all = movable(packing, options);
  std::vector<std::string> known;
  for (const Number* number : all)
    if (in_use(packing, options, *number))
      known.push_back(key_of(*number));
  const std::vector<Setting> settings = settings_of(texts, known);
  std::vector<estimate::UncertainInput> inputs;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Number& input = *all[k];
    const auto found = std::find_if(settings.begin(), settings.end(),
                                    [&](const Setting& one) { return one.key == key_of(input); });
    const bool assumed = found == settings.end();
    const double deviation = assumed ? assumed_deviation(packing, options, input)
                                     : deviation_of("--uncertainty " + found->key, found->deviation, input);
    if (deviation > 0)
      inputs.push_back({.input = key_of(input),
                        .deviation = deviation,
                        .assumed = assumed,
                        .moved = [given, given_options, k](double change) {
                          PackingOptions moved = given;
                          AnswerOptions moved_options = given_options;
                          Number& number = *movable(moved, moved_options)[k];
                          number.value += change;
                          if (&number == &moved_options.relative_density) {
                            const auto [least, largest] = void_ratio_limits(moved_options);
                            moved.void_ratio.value = largest - number.value * (largest - least);
                          }
                          if (moved_options.earth_pressure_at_rest.given() && moved.stress_h.preset)
                            moved.stress_h.value =
                                moved_options.earth_pressure_at_rest.value * moved.stress_v.value;
                          return question_of(moved, moved_options);
                        }});
  }
  return inputs;
}

std::string deviation_text(const PackingOptions& given, const AnswerOptions& given_options,
                           const estimate::UncertainInput& input) {
  PackingOptions packing = given;
  AnswerOptions options = given_options;
  for (const Number* number : movable(packing, options))
    if (key_of(*number) == input.input)
      return pretty(input.deviation, number->dimension);
  throw InvalidArgument(input.input + " is not an uncertain input");
}

} // namespace granum::cli
