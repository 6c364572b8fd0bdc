// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts that the question of a packing leaves open.
#pragma once

#include <granum/core/validity.hpp>
#include <granum/effective/relaxed_exponents.hpp>
#include <granum/estimate/question.hpp>

namespace granum::estimate {

/// The contacts of a question: the best guess, and those one standard deviation to each side.
struct KnownContacts {
  effective::ContactCounts middle, fewer, more;
  Validity validity;
};

/// Contacts as they are known, or as effective::contact_prior has them.
/// \throws   InvalidArgument as answer
KnownContacts contacts_of(const Question& question);

/// How each of them grows with the mean stress at this void ratio and stress ratio.
struct ContactGrowth {
  effective::Growth middle, fewer, more;
};

/// Central differences of contacts_of by ln p; 0 where contacts are known: those of this packing stay.
/// Assumes   stress
/// Accuracy  1e-7 of each slope
ContactGrowth growth_of(const Question& question);

} // namespace granum::estimate
