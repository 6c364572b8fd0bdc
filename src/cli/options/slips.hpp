// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/core/units.hpp>
#include <granum/core/validity.hpp>
#include <granum/effective/state.hpp>

/// Numbers that are possible, but more likely a slip of unit or symbol, judged by their value alone: by the
/// program those that were given (likely_mistakes.hpp), by the page for browsers all that it shows.
/// Checked by tests/cli/people.cmake and web/tests/numbers.test.mjs
namespace granum::cli {

/// A number and the name of its option or key, as messages have it.
struct Typed {
  std::string name;
  double value; ///< in SI
  Dimension dimension = Dimension::dimensionless;
};

/// Sands with shells or mica reach 2; no packing of grains is denser than 0.1, and only wide gradings are
/// denser than 0.4, where porosities lie.
/// \param    unequal   whether the grains have sizes of their own
void judge_void_ratio(const Typed& number, bool unequal, Validity& validity);
/// Contacts of equal spheres at a state.
/// \param    without_rattlers   whether the number is z*, not C_n
/// \throws   InvalidArgument as effective::contact_prior
void judge_contacts(const Typed& number, bool without_rattlers, const effective::State& state,
                    Validity& validity);
void judge_stress(const Typed& number, Validity& validity);
/// Of grains.
void judge_length(const Typed& number, Validity& validity);
/// Of the grains' solid: quartz has 30 to 45 GPa, plastics 1 GPa, diamond 500 GPa.
void judge_modulus(const Typed& number, Validity& validity);
/// Of the grains' solid.
void judge_density(const Typed& number, Validity& validity);

} // namespace granum::cli
