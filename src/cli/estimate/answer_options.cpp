// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_options.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>

#include "cli/frame/command_line.hpp"
#include "cli/frame/contradictions.hpp"
#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/options/likely_mistakes.hpp"

#include "uncertainty.hpp"

namespace granum::cli {

namespace {

/// Standard deviations of what is assumed: G_g (over itself) and nu_g of minerals from glass to quartz, a of
/// grains that were poured, density of sands [kg/m3].
constexpr double modulus_spread = 0.3, poisson_spread = 0.07, fabric_spread = 0.05, density_spread = 50;

void set_unless_given(Number& number, double value) {
  if (number.given())
    return;
  number.value = value;
  number.preset = true;
}

template <class Items>
std::string keys_of(const Items& items) {
  std::string keys;
  for (const auto& item : items)
    keys += (keys.empty() ? "" : "|") + std::string(item.key);
  return keys;
}

void apply_relative_density(PackingOptions& packing, AnswerOptions& o) {
  if (!o.relative_density.given())
    return;
  if (packing.void_ratio.given() || packing.porosity.given() || packing.solid_fraction.given())
    throw InvalidArgument(said_twice::density);
  if (!o.least_void_ratio.given() || !o.largest_void_ratio.given())
    throw InvalidArgument(
        o.sand != nullptr
            ? fmt::format("{} has no limits of its void ratio here: --relative-density needs "
                          "--least-void-ratio and --largest-void-ratio",
                          o.sand->name)
            : "--relative-density needs --least-void-ratio and --largest-void-ratio, or --sand");
  set_unless_given(packing.void_ratio, hardin::void_ratio_of_relative_density(
                                           require_share(o.relative_density, 1.2), o.least_void_ratio.value,
                                           o.largest_void_ratio.value));
}

std::optional<double> if_given(const Number& number) {
  return number.given() ? std::optional(number.value) : std::nullopt;
}

/// All numbers that may be uncertain, in the order of the options.
std::vector<Number*> movable(PackingOptions& packing, AnswerOptions& options) {
  std::vector<Number*> all = numbers(packing);
  all.push_back(&options.grain_density);
  return all;
}

/// What granum takes for the spread of a number that is not given, or that a mineral's name gives.
double assumed_deviation(const PackingOptions& packing, const AnswerOptions& o, const Number& number) {
  const bool by_name = o.mineral != nullptr && number.preset;
  if (&number == &packing.grain_shear_modulus)
    return by_name          ? o.mineral->modulus_spread * number.value
           : number.given() ? 0
                            : modulus_spread * number.value;
  if (number.given())
    return 0;
  return &number == &packing.grain_poisson_ratio ? poisson_spread
         : &number == &packing.fabric            ? fabric_spread
         : &number == &o.grain_density           ? density_spread
                                                 : 0;
}

/// The question with one number moved.
effective::PackingQuestion moved(PackingOptions packing, AnswerOptions options, std::size_t index,
                                 double step) {
  movable(packing, options)[index]->value += step;
  return question_of(packing, options);
}

/// The same, if it has an answer.
std::optional<effective::PackingQuestion> moved_if_possible(const PackingOptions& packing,
                                                            const AnswerOptions& options, std::size_t index,
                                                            double step) {
  try {
    effective::PackingQuestion question = moved(packing, options, index, step);
    (void)effective::answer(question);
    return question;
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

effective::PackingQuestion moved_as_far_as_possible(const PackingOptions& packing,
                                                    const AnswerOptions& options, std::size_t index,
                                                    double step) {
  for (int halvings = 0; halvings < 6; ++halvings, step /= 2)
    if (const auto question = moved_if_possible(packing, options, index, step))
      return *question;
  return question_of(packing, options);
}

} // namespace

void add_answer_options(CLI::App& command, AnswerOptions& o) {
  command
      .add_option_function<std::string>(
          "--preparation",
          [&o](const std::string& text) {
            o.preparation = effective::preparation_of(in_small_letters(text));
          },
          "How the grains came together, as it decides their contacts: dense, loose (friction 0.3 to 0.5), "
          "friction:0.3")
      ->check(
          taken_by([](const std::string& text) { (void)effective::preparation_of(in_small_letters(text)); }))
      ->type_name("dense|loose|friction:NUMBER");
  command
      .add_option_function<std::string>(
          "--grain", [&o](const std::string& text) { o.mineral = &contact::mineral(in_small_letters(text)); },
          "Solid of the grains: sets G_g, nu_g and density where they are not given")
      ->check(taken_by([](const std::string& text) { (void)contact::mineral(in_small_letters(text)); }))
      ->type_name(keys_of(contact::minerals()));
  command
      .add_option_function<std::string>(
          "--sand", [&o](const std::string& text) { o.sand = &hardin::known_sand(in_small_letters(text)); },
          "Sand: sets --grain, d50, C_u of the measured laws, and the limits of its void ratio, as far as a "
          "source says")
      ->check(taken_by([](const std::string& text) { (void)hardin::known_sand(in_small_letters(text)); }))
      ->type_name(keys_of(hardin::known_sands()));
  add_number_without_default(command, "--relative-density", o.relative_density,
                             "D_r instead of --void-ratio, 60%; with its limits or --sand");
  add_number_without_default(command, "--least-void-ratio", o.least_void_ratio,
                             "e_min, for --relative-density");
  add_number_without_default(command, "--largest-void-ratio", o.largest_void_ratio,
                             "e_max, for --relative-density");
  add_number(command, "--grain-density", o.grain_density, "rho_s of the grains' solid, for wave speeds");
  add_number(command, "--saturation", o.saturation,
             "Share of the pores that is water: V_p of 100% by Gassmann, below that air makes them soft");
  in_group(command, state_group,
           {"--relative-density", "--least-void-ratio", "--largest-void-ratio", "--saturation"});
  in_group(command, grains_group, {"--grain", "--sand", "--grain-density"});
  in_group(command, contacts_group, {"--preparation"});
}

void apply_presets(PackingOptions& packing, AnswerOptions& o) {
  if (o.sand != nullptr) {
    const hardin::KnownSand& sand = *o.sand;
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
  if (o.mineral != nullptr) {
    set_unless_given(packing.grain_shear_modulus, o.mineral->material.shear_modulus);
    set_unless_given(packing.grain_poisson_ratio, o.mineral->material.poisson_ratio);
    set_unless_given(o.grain_density, o.mineral->density);
  }
  apply_relative_density(packing, o);
}

effective::PackingQuestion question_of(const PackingOptions& packing, const AnswerOptions& o) {
  require_density_or_stress(packing);
  (void)resolve_mechanical_coordination_number(packing); // refuses z* and rattlers together
  return {.state = resolve_state(packing, resolve_stresses(packing)),
          .preparation = o.preparation,
          .coordination_number = if_given(packing.coordination_number),
          .mechanical_coordination_number = if_given(packing.mechanical_coordination_number),
          .rattler_fraction = if_given(packing.rattler_fraction),
          .grain_density = require_positive("--grain-density", o.grain_density.value, "kg/m3"),
          .saturation = require_share(o.saturation)};
}

std::vector<Spread> spreads_of(const PackingOptions& given, const AnswerOptions& given_options,
                               const std::vector<std::string>& settings) {
  PackingOptions packing = given;
  AnswerOptions options = given_options;
  std::vector<Spread> spreads;
  // The numbers of the copies stand at the same places, and know the same options.
  for (const Number* number : movable(packing, options)) {
    double deviation = assumed_deviation(packing, options, *number);
    bool assumed = true;
    for (const std::string& setting : settings)
      if (const std::optional<double> said = said_deviation(setting, *number)) {
        deviation = *said;
        assumed = false;
      }
    if (deviation > 0)
      spreads.push_back({.key = key_of(*number),
                         .text = pretty(deviation, number->dimension),
                         .deviation = deviation,
                         .assumed = assumed});
  }
  return spreads;
}

namespace {

template <class Moved>
std::vector<effective::InputSpread> input_spreads(const PackingOptions& packing, const AnswerOptions& options,
                                                  const std::vector<Spread>& spreads, const Moved& move) {
  PackingOptions names = packing;
  AnswerOptions option_names = options;
  const std::vector<Number*> all = movable(names, option_names);
  std::vector<effective::InputSpread> inputs;
  for (const Spread& spread : spreads)
    for (std::size_t k = 0; k < all.size(); ++k)
      if (key_of(*all[k]) == spread.key)
        inputs.push_back({.name = spread.key,
                          .less = move(packing, options, k, -spread.deviation),
                          .more = move(packing, options, k, spread.deviation)});
  return inputs;
}

} // namespace

effective::PackingAnswer answer_with_spreads(const PackingOptions& packing, const AnswerOptions& options,
                                             const std::vector<Spread>& spreads) {
  const effective::PackingQuestion question = question_of(packing, options);
  try { // most packings may have all of them, and each attempt costs as much as an answer
    return effective::answer(question, input_spreads(packing, options, spreads, moved));
  } catch (const InvalidArgument&) {
    return effective::answer(question, input_spreads(packing, options, spreads, moved_as_far_as_possible));
  }
}

} // namespace granum::cli
