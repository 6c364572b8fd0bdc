// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/elastic/transverse_isotropic.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/estimate/input_values.hpp>
#include <granum/estimate/question.hpp>

/// The parts of a question and of an answer: its contacts, its numbers for a sand, and its ranges.
namespace granum::estimate {

/// The contacts of a question: the best estimate, and one standard deviation to each side.
struct KnownContacts {
  effective::ContactCounts middle, fewer, more;
  Validity validity;
};

/// Contacts as given, or according to effective::contact_prior.
/// \throws   InvalidArgument as answer
KnownContacts contacts_of(const Question& question);

/// How each of them grows with the mean stress at this void ratio and stress ratio.
struct ContactGrowth {
  effective::Growth middle, fewer, more;
};

/// Central differences of contacts_of by ln p; 0 if the contacts are given: they do not change.
/// Assumes   stress
/// Accuracy  1e-7 of each slope
ContactGrowth growth_of(const Question& question);

/// What a question must have for its formulas to exist, also if a standard deviation has changed it.
/// \throws   InvalidArgument
void require_possible(const Question& question);

/// A note where no soil is strong enough for the stresses: outside of K_0 0.13 to 7.5.
void note_strength(const Question& question, Validity& validity);

/// As answer, for a question that a standard deviation may have taken beyond the limits of require_valid.
[[nodiscard]] Answer possible_answer(const Question& question, std::span<const Spread> spreads = {});

/// The effect of an input on all numbers: the smallest and the largest of the values on its two sides and in
/// the middle.
Effect effect_of(std::string input, bool assumed, const Values& middle, const Values& a, const Values& b);

/// The range of a number: the effects of all inputs in quadrature, except those of one name. Never NaN, and
/// low <= value <= high. It is limited to possible values; a Poisson's ratio of an anisotropic packing may
/// exceed 0.5, then up to the largest effect of a single input.
/// Assumes   finite values and effects
Range range_of(const FieldRow& row, const Values& middle, std::span<const Effect> effects,
               std::string_view without = {});

/// Shares of the inputs in the range of a number, largest first, without shares of zero.
std::vector<Share> shares_of(Field field, std::span<const Effect> effects);

inline double& at(Values& values, Field field) { return values[static_cast<std::size_t>(field)]; }

/// estimate::answer of grain_shape sand.
/// Assumes   a question validated by answer()
Answer sand_answer(const Question& question, std::span<const Spread> spreads);

/// Fills in the densities and wave speeds of a stiffness.
/// Assumes   that the density of the grains is known
void set_speeds(Values& all, const Question& question, const elastic::TransverselyIsotropic& stiffness);

/// \throws   InvalidArgument if a number exceeds the range of a double
void require_finite_values(const Values& all);

/// Whether a void ratio follows from D_r with the limits of usual sands.
bool by_usual_limits(const InputValues& values);
/// C_u: as it is given, of the sizes, or of the named sand.
std::optional<double> uniformity_of(const InputValues& values);
/// e_min and e_max: those that are known, or those of usual sands of that C_u.
std::pair<double, double> void_ratio_limits(const InputValues& values);

} // namespace granum::estimate
