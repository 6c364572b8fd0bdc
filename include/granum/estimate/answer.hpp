// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/units.hpp>
#include <granum/estimate/question.hpp>

/// The numbers of an answer, one row each; screen, JSON, CSV, Python and the page are written from this
/// table.
namespace granum::estimate {

/// A number of an answer. Vertical quantities also represent isotropic packings.
enum class Field : std::size_t {
  shear_modulus,
  shear_wave_speed,
  compression_wave_speed,
  bulk_modulus,
  young_modulus,
  poisson_ratio,
  horizontal_shear_modulus,
  horizontal_shear_wave_speed,
  horizontal_compression_wave_speed,
  horizontal_young_modulus,
  bulk_density,
  mechanical_coordination_number,
  rattler_fraction,
  coordination_number,
  contact_softness,
  vertical_exponent,
  horizontal_exponent,
  stress_exponent,
  strained_shear_modulus,
  modulus_ratio,
  damping_ratio,
  slip_strain,
  pm4sand_coefficient
};
inline constexpr std::size_t field_count = 23;

/// For which packings a number is shown.
enum class Shown {
  always,
  by_direction, ///< if vertical and horizontal values differ
  in_full       ///< if all numbers are requested
};

/// How the contributions to a number's range are added.
enum class Spreading {
  logarithmic, ///< positive numbers, on a logarithmic scale
  difference   ///< numbers that may be 0 or negative
};

struct FieldRow {
  Field field;
  const char* key;              ///< in JSON and in Python
  const char* symbol;           ///< for an isotropic packing, on a screen
  const char* directed_symbol;  ///< where vertical and horizontal differ
  const char* column;           ///< in the heading of a CSV file
  Dimension dimension;          ///< of the number in SI
  const char* meaning;          ///< for an isotropic packing
  const char* directed_meaning; ///< where vertical and horizontal differ
  const char* in_water;         ///< appended to the meaning if there is water in the pores
  Shown shown;
  bool needs_density;  ///< only with the density of the grains
  Spreading spreading; ///< of its range
  double least;        ///< lower limit of any packing, and of the range
  double most;         ///< upper limit of isotropic packings, and of the range
};

/// All rows, in the order in which they are shown.
[[nodiscard]] std::span<const FieldRow, field_count> fields();
/// The row of one.
[[nodiscard]] const FieldRow& row_of(Field field);
/// The row with that key.
/// \throws   InvalidArgument with all keys for another text
/// Checked by tests/estimate/test_fields.cpp
[[nodiscard]] const FieldRow& field_of(std::string_view key);

/// \file
/// From the known properties of a packing to its stiffness: the one function that every command, Python and
/// the page use. The range of each number covers the unknown properties.

/// A number and its range due to uncertain inputs.
struct Range {
  double value = 0;
  double low = 0;
  double high = 0;

  bool operator==(const Range&) const = default;
  /// Half of the width over the value: a relative standard error, if the range is one deviation to each side
  /// [1].
  [[nodiscard]] double relative_error() const { return (high - low) / (2 * value); }
};

/// Numbers in the order of fields(); 0 for those that do not exist for the packing.
using Values = std::array<double, field_count>;

/// All numbers, with one input changed by one standard deviation to each side.
struct Effect {
  std::string input; ///< "contacts", "rung 3", or the name of a Spread
  bool assumed = false;
  Values low{}, high{};
};

/// Share of an input in the range of G_vh: its squared width over the sum of all squared widths.
struct Share {
  std::string input;
  double share = 0; ///< in (0, 1]; all of them add up to 1 [1]
};

/// The stiffness of a packing.
class Answer {
 public:
  /// A number with its range.
  /// \throws   InvalidArgument if it does not exist for the packing: a wave speed without the density of the
  ///           grains, an exponent without stiffness
  [[nodiscard]] const Range& operator[](Field field) const;
  /// The same; empty if it does not exist for the packing.
  [[nodiscard]] const std::optional<Range>& find(Field field) const {
    return ranges_[static_cast<std::size_t>(field)];
  }
  /// The remaining range if an input were exact.
  /// \throws   as operator[]
  [[nodiscard]] Range without(Field field, std::string_view input) const;

  /// The packing with the C_n and z* used by the answer, as input of the rungs of effective/rungs.hpp.
  [[nodiscard]] const effective::State& state() const { return state_; }
  /// The assumed kind of grains.
  [[nodiscard]] GrainShape grain_shape() const { return grain_shape_; }
  /// Shares of the inputs in the range of G_vh, largest first; empty if all inputs are exact.
  [[nodiscard]] std::vector<Share> shares() const;
  /// The effects of all inputs.
  [[nodiscard]] const std::vector<Effect>& effects() const { return effects_; }
  /// Whether an input of that name is an assumption.
  [[nodiscard]] bool assumes(std::string_view input) const;
  /// Notes on inputs outside the range of the formulas.
  [[nodiscard]] const Validity& validity() const { return validity_; }

 private:
  friend Answer possible_answer(const Question& question, std::span<const Spread> spreads);
  friend Answer sand_answer(const Question& question, std::span<const Spread> spreads);
  explicit Answer(effective::State state) : state_(std::move(state)) {}

  effective::State state_;
  GrainShape grain_shape_ = GrainShape::sphere;
  Values middle_{};
  std::vector<Effect> effects_;
  std::array<std::optional<Range>, field_count> ranges_;
  Validity validity_;
};

/// Rung 3 with the given contacts, or else with the middle of the possible contacts.
/// The range adds the effects of the inputs in quadrature, separately for each side: the contacts from the
/// loosest to the densest of the preparation with the scatter of z*, one standard error of rung 3, and one
/// deviation of each uncertain input. If only one of z*, C_n and x_0 is given, the others follow from
/// effective::contact_prior; z* from x_0 alone stays within the range of the prior.
/// The range of a stiffness begins at 0 where z* may be at the isostatic point.
/// m, n and s apply to G_vh = C44 at this void ratio. Unknown contacts grow with the mean stress according to
/// the prior, and s is then the slope of this answer along p'; given contacts do not grow.
/// Assumes   as relaxed, contact_prior and saturated; at a saturation below 1, air makes the pore fluid
///           nearly as soft as in dry pores.
/// Below e = 0.5 and above 0.75 there are no calibrated sphere packings: there the range of a stiffness
/// extends to the values measured on sands.
/// For sand (grain_shape) the same fields follow from laws measured on sands: G from
/// sands::pooled_shear_modulus at the mean stress (under anisotropic stress its exponent is split into n and
/// m); K, E and V_p with sands::poisson_ratio; the range from sands::stated_factor and the other deviations
/// there. z* and the softness of contacts are inferred: with them rung 3 gives this Poisson's ratio and this
/// G. Neither is known independently, and no other coordination number is stated.
/// \throws   InvalidArgument as require_valid, relaxed and contact_prior, if C_n, z* and x_0 are all given,
///           and if the moduli exceed the range of a double
/// Accuracy  the middle as relaxed at its z*; s of growing contacts 1e-7. No number is NaN, and each lies in
///           its range. Checked by tests/estimate/test_answer.cpp, tests/attack
[[nodiscard]] Answer answer(const Question& question, std::span<const Spread> spreads = {});

/// The same with inputs changed by functions. If no packing is possible at a full deviation to one side, a
/// half, a quarter and so on down to 1/32 of it is used, and else none.
/// \throws   InvalidArgument as answer, for the question itself
/// Checked by tests/estimate/test_answer.cpp
[[nodiscard]] Answer answer(const Question& question, std::span<const UncertainInput> inputs);

} // namespace granum::estimate
