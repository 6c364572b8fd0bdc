// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <granum/contact/shape.hpp>
#include <granum/core/units.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>
#include <granum/sizes/distribution.hpp>
#include <granum/stress/axial_stress.hpp>
#include <nlohmann/json.hpp>

namespace CLI {
class App;
class Option;
} // namespace CLI

/// The options that describe a packing and its stress, for every command that works out closed forms.
namespace granum::cli {

/// Groups of options in help.
inline constexpr const char* state_group = "Density and stress";
inline constexpr const char* grains_group = "Grains";
inline constexpr const char* contacts_group = "Contacts";
inline constexpr const char* sizes_group = "Sizes of the grains";
inline constexpr const char* law_group = "Shape of the contacts";

/// A number of the command line or of a table: its value in SI, by default until it is given.
struct Number {
  double value = 0;
  Dimension dimension = Dimension::dimensionless;
  /// What columns of tables may call it besides its option's name, separated by blanks.
  std::string_view symbols = {};
  std::string name = {}; ///< of the option, "--radius"
  const CLI::Option* option = nullptr;
  bool in_table = false; ///< a row of a table gives it
  bool preset = false;   ///< what else was told decides it, as the name of a mineral does
  bool per_cent = false; ///< the column of the table says so

  [[nodiscard]] bool given() const;
  /// That the number is not within `range`, and where it is above `most` and may be per cent without its
  /// sign, how that is written.
  [[noreturn]] void refuse_share(const std::string& range, double most) const;
};

/// Adds the option of a number; its value is the default.
CLI::Option* add_number(CLI::App& command, const std::string& name, Number& number, const std::string& help);
/// The same for a number that has no default to show.
CLI::Option* add_number_without_default(CLI::App& command, const std::string& name, Number& number,
                                        const std::string& help);

/// Defaults: grains of Table 1 of [Chung2014] and the C_n of its dense spheres (Table 2); cone and punch are
/// those that agree with its Table 5. Numbers without a default are 0 and never used unless given.
struct PackingOptions {
  contact::Shape contact = contact::Shape::sphere;
  const CLI::Option* contact_option = nullptr;
  bool contact_in_table = false;
  Number slope{0.4};
  Number punch_radius{5.7e-6, Dimension::length};
  Number alpha;
  Number profile_constant;
  Number grain_shear_modulus{30e9, Dimension::pressure};
  Number grain_poisson_ratio{0.15};
  Number radius{0.5e-3, Dimension::length};
  Number d50{0, Dimension::length};
  std::optional<sizes::Distribution> sizes = {}; ///< of unequal grains
  Number tangential_ratio;
  Number void_ratio{0, Dimension::dimensionless, "e"};
  Number porosity;
  Number solid_fraction;
  Number coordination_number{5.73, Dimension::dimensionless, "C_n Cn"};
  Number mechanical_coordination_number{0, Dimension::dimensionless, "z_star z*"};
  Number rattler_fraction;
  Number fabric{0, Dimension::dimensionless, "a"};
  Number pressure{0, Dimension::pressure, "p p'"};
  Number stress_v{0, Dimension::pressure, "sigma_v sigma'_v \u03c3_v \u03c3'_v"};
  Number stress_h{0, Dimension::pressure, "sigma_h sigma'_h \u03c3_h \u03c3'_h"};

  [[nodiscard]] bool contact_given() const;
};

/// All numbers, in the order of their options.
[[nodiscard]] std::vector<Number*> numbers(PackingOptions& options);

void add_packing_options(CLI::App& command, PackingOptions& options);
/// The part of them that names the contact law: shape and material of the grains.
/// \param    name   of the option for the shape
void add_law_options(CLI::App& command, PackingOptions& options, const std::string& name = "--contact");

/// The contact law that the options describe, of two grains, of unequal ones of the mean pair.
/// \throws   InvalidArgument for options that contradict one another or are out of range
[[nodiscard]] contact::PowerLaw resolve_law(const PackingOptions& options);

/// \throws   InvalidArgument that names both where neither density nor stress is given
void require_density_or_stress(const PackingOptions& options);

/// The stresses that the options give.
/// \throws   InvalidArgument if they are missing or given more than once
[[nodiscard]] stress::AxialStress resolve_stresses(const PackingOptions& options);

/// The packing that the options describe, at a stress.
/// \throws   InvalidArgument for options that contradict one another or that no packing can have
[[nodiscard]] effective::State resolve_state(const PackingOptions& options,
                                             const stress::AxialStress& stress);

/// z* of the packing, if it is given, or the share of rattlers. A table may hold both: then z*.
/// \throws   InvalidArgument if both are given, or if the value is out of its range
[[nodiscard]] std::optional<double> resolve_mechanical_coordination_number(const PackingOptions& options);

/// What was not given of shape, grains and fabric, one sentence each.
[[nodiscard]] std::vector<std::string> assumed_grains(const PackingOptions& options,
                                                      const effective::State& state);
/// The same, and that rattlers of unequal grains were not given.
[[nodiscard]] std::vector<std::string> assumed_inputs(const PackingOptions& options,
                                                      const effective::State& state);
/// That the coordination number was not given, and how much less a loosely prepared packing may have.
[[nodiscard]] std::vector<std::string> assumed_coordination(const PackingOptions& options,
                                                            const effective::State& state);

/// Contact, grains and packing in SI, without the stress.
[[nodiscard]] nlohmann::ordered_json packing_json(const PackingOptions& options,
                                                  const effective::State& state);

/// Whether a calibrated rung declines: z* is not above the isostatic point, where a network of contacts is
/// not rigid. Its moduli are then zero, and it states no error of them.
[[nodiscard]] bool declines(const effective::RungAnswer& answer);

} // namespace granum::cli
