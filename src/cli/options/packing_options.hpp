// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/contact/laws.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>
#include <granum/sizes/distribution.hpp>
#include <granum/stress/axial_stress.hpp>
#include <nlohmann/json.hpp>

#include "cli/frame/option_row.hpp"
#include "column_names.hpp"

/// The options for a packing and its stress, for every command that computes closed forms.
namespace granum::cli {

using estimate::contacts_group;
using estimate::grains_group;
using estimate::Input;
using estimate::law_group;
using estimate::sizes_group;
using estimate::state_group;

/// A number of a contact law, for one row of the table of laws.
struct LawNumber {
  const contact::LawRow* row;
  const contact::LawParameter* parameter;
  Number number;
};
/// All of them in the order of the table, with its values.
[[nodiscard]] std::vector<LawNumber> law_numbers();

/// Defaults: grains of Table 1 of [Chung2014]; contact laws have those of the table of laws. Numbers without
/// a default are never used unless given.
struct PackingOptions {
  contact::Shape contact = contact::Shape::sphere;
  bool contact_typed = false;
  bool contact_in_table = false;
  std::vector<LawNumber> law_numbers = cli::law_numbers();
  Number grain_shear_modulus = number_of(Input::grain_shear_modulus);
  Number grain_poisson_ratio = number_of(Input::grain_poisson_ratio);
  Number grain_bulk_modulus = number_of(Input::grain_bulk_modulus); ///< instead of Poisson's ratio
  Number radius = number_of(Input::radius);
  Number d50 = number_of(Input::d50);
  std::optional<sizes::Distribution> sizes = {}; ///< of unequal grains
  bool graded = false;                           ///< sizes are given as for a soil, by a sieve curve or C_u
  std::optional<double> uniformity = {};         ///< C_u if the sizes were given by it, exactly
  Number tangential_ratio = number_of(Input::tangential_ratio);
  Number void_ratio = number_of(Input::void_ratio);
  Number porosity = number_of(Input::porosity);
  Number solid_fraction = number_of(Input::solid_fraction);
  Number coordination_number = number_of(Input::coordination_number);
  Number mechanical_coordination_number = number_of(Input::mechanical_coordination_number);
  Number rattler_fraction = number_of(Input::rattler_fraction);
  Number fabric = number_of(Input::fabric);
  Number pressure = number_of(Input::pressure);
  Number stress_v = number_of(Input::stress_v);
  Number stress_h = number_of(Input::stress_h);

  [[nodiscard]] bool contact_given() const { return contact_typed || contact_in_table; }
  /// The number of that key in the table of laws.
  [[nodiscard]] const Number& law_number(std::string_view key) const;
};

/// The material of the grains: the shear modulus, and Poisson's ratio or the bulk modulus.
/// \throws   InvalidArgument if both are given, or for impossible moduli
[[nodiscard]] contact::GrainMaterial grain_of(const PackingOptions& options);

/// The numbers of a packing besides those of its contact law, in the order of their effects.
[[nodiscard]] std::span<Number PackingOptions::*const> packing_numbers();
/// All numbers: columns of tables, and inputs that may be uncertain.
[[nodiscard]] std::vector<Number*> numbers(PackingOptions& options);

void add_packing_options(Command& command, PackingOptions& options);
/// The options for the contact law: shape and material of the grains.
/// \param    name   of the option for the shape
void add_law_options(Command& command, PackingOptions& options, const std::string& name = "--contact");
/// The option of one number, by its name.
void add_packing_number(Command& command, PackingOptions& options, std::string_view name);

/// The contact law given by the options, for two grains; for unequal grains that of the mean pair.
/// \throws   InvalidArgument for options that contradict each other or are out of range
[[nodiscard]] contact::NormalLaw resolve_law(const PackingOptions& options);

/// \throws   InvalidArgument naming both, if neither density nor stress is given
void require_density_or_stress(const PackingOptions& options);

/// The stresses given by the options.
/// \throws   InvalidArgument if they are missing or given more than once
[[nodiscard]] stress::AxialStress resolve_stresses(const PackingOptions& options);

/// The packing given by the options, at a stress.
/// \throws   InvalidArgument for options that contradict each other or are impossible
[[nodiscard]] effective::State resolve_state(const PackingOptions& options,
                                             const stress::AxialStress& stress);

/// Assumptions about shape, grains and fabric that were not given, one sentence each.
[[nodiscard]] std::vector<std::string> assumed_grains(const PackingOptions& options,
                                                      const effective::State& state);
/// Contact, grains and packing in SI, without the stress; contacts if known.
[[nodiscard]] nlohmann::ordered_json packing_json(const PackingOptions& options,
                                                  const effective::State& state);

} // namespace granum::cli
