// SPDX-License-Identifier: GPL-3.0-or-later
// The unknown contacts of a question.
#pragma once

#include <granum/core/validity.hpp>
#include <granum/effective/relaxed_exponents.hpp>
#include <granum/estimate/question.hpp>

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

} // namespace granum::estimate
