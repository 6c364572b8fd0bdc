// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/core/validity.hpp>
#include <granum/estimate/fields.hpp>
#include <granum/estimate/question.hpp>

/// From what is known of a packing to its stiffness: the one route that every command, Python and the page
/// take. Each number has a range that covers what is not known.
namespace granum::estimate {

/// A number and the range that its inputs leave open.
struct Range {
  double value = 0;
  double low = 0;
  double high = 0;

  bool operator==(const Range&) const = default;
  /// Half of the width over the value: a standard error, if the range is that of one deviation [1].
  [[nodiscard]] double relative_error() const { return (high - low) / (2 * value); }
};

/// Numbers in the order of fields(). Those that a packing does not have are 0 there.
using Values = std::array<double, field_count>;

/// What one input makes of all numbers when it moves by one standard deviation to each side.
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
  /// \throws   InvalidArgument if the packing does not have it: a wave speed without the density of the
  ///           grains, an exponent without stiffness
  [[nodiscard]] const Range& operator[](Field field) const;
  /// The same; nothing where the packing does not have it.
  [[nodiscard]] const std::optional<Range>& find(Field field) const {
    return ranges_[static_cast<std::size_t>(field)];
  }
  /// The range that would be left if an input were exact.
  /// \throws   as operator[]
  [[nodiscard]] Range without(Field field, std::string_view input) const;

  /// The packing with the contacts that the answer takes, C_n and z*: for the rungs of effective/rungs.hpp.
  [[nodiscard]] const effective::State& state() const { return state_; }
  /// What the grains were taken to be.
  [[nodiscard]] GrainShape grain_shape() const { return grain_shape_; }
  /// Which inputs make the range of G_vh, largest first; empty where nothing is open.
  [[nodiscard]] std::vector<Share> shares() const;
  /// What each input makes of the numbers, one after the other.
  [[nodiscard]] const std::vector<Effect>& effects() const { return effects_; }
  /// Whether an input of that name is an assumption.
  [[nodiscard]] bool assumes(std::string_view input) const;
  /// Notes on inputs outside of what formulas are made for.
  [[nodiscard]] const Validity& validity() const { return validity_; }

 private:
  friend Answer answer(const Question& question, std::span<const Spread> spreads);
  friend Answer sand_answer(const Question& question, std::span<const Spread> spreads);
  explicit Answer(effective::State state) : state_(std::move(state)) {}

  effective::State state_;
  GrainShape grain_shape_ = GrainShape::sphere;
  Values middle_{};
  std::vector<Effect> effects_;
  std::array<std::optional<Range>, field_count> ranges_;
  Validity validity_;
};

/// Rung 3 at the contacts that are known, or else in the middle of those that the packing may have.
/// The range covers, each input by itself and added in quadrature, to each side as far as it goes there: the
/// contacts from the loosest to the densest of the preparation with the scatter of z*, one standard error of
/// rung 3, and one deviation of each uncertain input. Of z* alone, C_n follows with the rattlers of
/// effective::contact_prior; of C_n alone z* does; of rattlers alone z* does, within the prior's range.
/// The range of a stiffness begins at 0 where z* may be at the isostatic point.
/// m, n and s are those of G_vh = C44 at this void ratio. Where nothing is known of the contacts they grow
/// with the mean stress as the prior has them, and s is the slope of this answer along p'; known contacts
/// stay.
/// Assumes   as relaxed, contact_prior and saturated; air in the pores of a saturation below 1 makes them
///           nearly as soft as dry ones.
/// Below e = 0.5 and above 0.75 no sphere packing was calibrated: the range of a stiffness there reaches what
/// is measured on sands.
/// Of a sand (grain_shape) the same fields come from what was measured: G by sands::pooled_shear_modulus at
/// the mean stress, and as n and m share its exponent where stresses differ; Poisson's ratio by
/// sands::poisson_ratio, and with it K, E, V_p; the range is that of sands::stated_factor and of the other
/// deviations there. z* and the softness of contacts are inferred: those at which rung 3 has this ratio and
/// this G; neither is known by itself, and no other contact number is stated.
/// \throws   InvalidArgument as relaxed and contact_prior, for a saturation or density out of its range,
///           for a shear strain of spheres, for spheres of C_u above sphere_uniformity_limit, if C_n, z* and
///           x_0 are all given, and if the moduli are beyond what a double holds
/// Accuracy  of the middle as relaxed at its z*; of s where contacts grow 1e-7. No number is NaN, and each
///           lies in its range. Checked by tests/estimate/test_answer.cpp, tests/attack
[[nodiscard]] Answer answer(const Question& question, std::span<const Spread> spreads = {});

/// Largest C_u of spheres that the answer stands for.
inline constexpr double sphere_uniformity_limit = 4;

/// The same with inputs that functions move. A side that no packing can have is moved by a half, a quarter
/// and so on, down to 1/32 of the deviation, and else not at all.
/// \throws   InvalidArgument as answer, for the question itself
/// Checked by tests/estimate/test_answer.cpp
[[nodiscard]] Answer answer(const Question& question, std::span<const UncertainInput> inputs);

} // namespace granum::estimate
