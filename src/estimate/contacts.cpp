// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts.hpp"

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/effective/relaxation.hpp>

#include "core/root.hpp"
#include "effective/contact_prior_kernel.hpp"

namespace granum::estimate {

namespace {

using effective::ContactCounts;
using effective::ContactPrior;

/// Largest fraction of rattlers of any packing.
constexpr double most_rattlers = 0.9;

ContactCounts of_z_and_C_n(double z, double C_n) {
  return {.mechanical_coordination_number = z, .rattler_fraction = z > 0 ? std::max(0.0, 1 - C_n / z) : 0};
}

KnownContacts exactly(const ContactCounts& counts) { return {counts, counts, counts, {}}; }

/// z* in [0, 100] at which a function that grows with z* reaches 0, or the end that is nearer to it.
template <class Function>
double contacts_at_root(const Function& grows) {
  const double low = 0, high = 100;
  const double at_low = grows(low), at_high = grows(high);
  if (at_low >= 0 || at_high <= 0)
    return at_low >= 0 ? low : high;
  return middle(root_between(grows, low, high, at_low, at_high, within_share(1e-15), 80));
}

KnownContacts contacts_by_prior(const ContactPrior& prior) {
  const double z = prior.middle.mechanical_coordination_number;
  const auto step = [&](const ContactCounts& end, double sign) {
    const double at = z + sign * std::hypot(end.mechanical_coordination_number - z, prior.coordination_error);
    // Rattlers decrease as contacts grow: the law of the prior between its ends, extrapolated.
    const double z_there = std::max(at, 0.0);
    return ContactCounts{.mechanical_coordination_number = z_there,
                         .rattler_fraction =
                             effective::typical_rattler_fraction(z_there, prior.relative_overlap)};
  };
  return {.middle = prior.middle,
          .fewer = step(prior.loosest, -1),
          .more = step(prior.densest, 1),
          .validity = prior.validity};
}

/// z* is given: rattlers, and so C_n, follow with the scatter of the prior.
KnownContacts contacts_by_z(double z, const ContactPrior& prior) {
  const double x = effective::typical_rattler_fraction(z, prior.relative_overlap);
  const auto with = [&](double factor) {
    return ContactCounts{.mechanical_coordination_number = z,
                         .rattler_fraction = std::min(x * factor, most_rattlers)};
  };
  const double factor = std::exp(prior.rattler_error);
  return {.middle = with(1), .fewer = with(factor), .more = with(1 / factor), .validity = {}};
}

/// C_n is given: more rattlers mean more contacts of the other grains.
KnownContacts contacts_by_C_n(double C_n, const ContactPrior& prior) {
  if (C_n == 0)
    return exactly({.mechanical_coordination_number = 0, .rattler_fraction = 0});
  const auto with = [&](double factor) {
    const auto missing = [&](double z) {
      const double x = factor * effective::typical_rattler_fraction(z, prior.relative_overlap);
      return z * (1 - std::min(x, most_rattlers)) - C_n;
    };
    return of_z_and_C_n(contacts_at_root(missing), C_n);
  };
  const double factor = std::exp(prior.rattler_error);
  return {.middle = with(1), .fewer = with(1 / factor), .more = with(factor), .validity = {}};
}

/// The fraction of rattlers is given: z* follows from the prior, among the packings of this void ratio; if
/// none of them has this fraction, only the range grows. Rattlers of unequal grains follow from their sizes,
/// not from z*.
KnownContacts contacts_by_rattlers(double rattlers, const ContactPrior& prior, bool equal_grains) {
  KnownContacts range = contacts_by_prior(prior);
  if (!equal_grains) {
    for (ContactCounts* counts : {&range.middle, &range.fewer, &range.more})
      counts->rattler_fraction = rattlers;
    return range;
  }
  ContactPrior of_packings = prior;
  of_packings.coordination_error = prior.packing_scatter;
  range = contacts_by_prior(of_packings);
  const auto with = [&](double factor, double doubt) {
    const double z = contacts_at_root([&](double at) {
      return rattlers * factor - effective::typical_rattler_fraction(at, prior.relative_overlap);
    });
    const double among =
        std::clamp(z, range.fewer.mechanical_coordination_number, range.more.mechanical_coordination_number);
    return ContactCounts{.mechanical_coordination_number = std::max(among + doubt, 0.0),
                         .rattler_fraction = rattlers};
  };
  const double factor = std::exp(prior.rattler_error);
  const double doubt = prior.coordination_error - prior.packing_scatter;
  return {.middle = with(1, 0),
          .fewer = with(factor, -doubt),
          .more = with(1 / factor, doubt),
          .validity = prior.validity};
}

effective::Growth growth_between(const ContactCounts& before, const ContactCounts& after, double step) {
  const double few = before.coordination_number(), many = after.coordination_number();
  return {.coordination_number = few > 0 && many > 0 ? std::log(many / few) / step : 0,
          .mechanical_coordination_number =
              (after.mechanical_coordination_number - before.mechanical_coordination_number) / step};
}

} // namespace

KnownContacts contacts_of(const Question& q) {
  const std::optional<double>&C_n = q.state.coordination_number, &z = q.state.mechanical_coordination_number,
        &x = q.rattler_fraction;
  if (C_n && z && x)
    throw InvalidArgument(
        "coordination_number, mechanical_coordination_number and rattler_fraction determine one another: "
        "give at most two of them");
  if (C_n)
    require_non_negative("coordination_number", *C_n);
  if (z)
    require_non_negative("mechanical_coordination_number", *z);
  if (x)
    require_closed("rattler_fraction", *x, 0, 1);
  if (C_n && x)
    return exactly({.mechanical_coordination_number = effective::mechanical_coordination_number(*C_n, *x),
                    .rattler_fraction = *x});
  if (z && x)
    return exactly({.mechanical_coordination_number = *z, .rattler_fraction = *x});
  if (C_n && z)
    return exactly(of_z_and_C_n(*z, *C_n));
  const ContactPrior prior = effective::kernel::possible_contact_prior(q.state, q.preparation);
  if (z)
    return contacts_by_z(*z, prior);
  KnownContacts known = C_n ? contacts_by_C_n(*C_n, prior)
                        : x ? contacts_by_rattlers(*x, prior, q.state.contacts == sizes::ContactMeans{})
                            : contacts_by_prior(prior);
  if (q.state.rolling > 0)
    known.validity.add("z* is estimated as in packings without rolling resistance; with it, grains may rest "
                       "with fewer contacts: better give mechanical_coordination_number");
  return known;
}

ContactGrowth growth_of(const Question& question) {
  if (question.knows_contacts())
    return {};
  constexpr double half = 5e-4;
  const auto at = [&](double step) {
    Question moved = question;
    moved.state.stress_v *= std::exp(step);
    moved.state.stress_h *= std::exp(step);
    return contacts_of(moved);
  };
  const KnownContacts before = at(-half), after = at(half);
  return {.middle = growth_between(before.middle, after.middle, 2 * half),
          .fewer = growth_between(before.fewer, after.fewer, 2 * half),
          .more = growth_between(before.more, after.more, 2 * half)};
}

} // namespace granum::estimate
