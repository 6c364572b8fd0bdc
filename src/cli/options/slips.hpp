// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/core/error.hpp>
#include <granum/core/units.hpp>
#include <granum/effective/state.hpp>

/// Checks for numbers that are possible, but more likely a mistake in unit or symbol, by their value only.
/// The program checks given numbers (likely_mistakes.hpp), the page for browsers all that it shows.
/// Checked by tests/cli/rows/people.txt and web/tests/numbers.test.mjs
namespace granum::cli {

/// A number and the name of its option or key, as used in messages.
struct Typed {
  std::string name;
  double value; ///< in SI
  Dimension dimension = Dimension::dimensionless;
};

/// Void ratio. Sands with shells or mica reach 2; no packing of grains is below 0.1, and only wide gradings
/// are below 0.4, the range of porosities.
/// \param    unequal   whether the grains have different sizes
void judge_void_ratio(const Typed& number, bool unequal, Validity& validity);
/// Contacts of equal spheres at a state.
/// \param    without_rattlers   whether the number is z*, not C_n
/// \throws   InvalidArgument as effective::contact_prior
void judge_contacts(const Typed& number, bool without_rattlers, const effective::State& state,
                    Validity& validity);
void judge_stress(const Typed& number, Validity& validity);
/// Size of grains.
void judge_length(const Typed& number, Validity& validity);
/// Shear modulus of the grain mineral: quartz has 30 to 45 GPa, plastics 1 GPa, diamond 500 GPa.
void judge_modulus(const Typed& number, Validity& validity);
/// Density of the grain mineral.
void judge_density(const Typed& number, Validity& validity);

} // namespace granum::cli
