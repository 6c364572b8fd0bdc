// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/answer.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <granum/contact/minerals.hpp>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/elastic/saturation.hpp>
#include <granum/elastic/wave_speeds.hpp>

#include "relaxation_kernel.hpp"

namespace granum::effective {

namespace {

// ---- contacts

/// The contacts of a question: the best guess, and those one step to each side.
struct KnownContacts {
  ContactCounts middle, fewer, more;
  Validity validity;
};

ContactCounts of_z_and_C_n(double z, double C_n) {
  return {.mechanical_coordination_number = z, .rattler_fraction = z > 0 ? std::max(0.0, 1 - C_n / z) : 0};
}

KnownContacts exactly(const ContactCounts& counts) { return {counts, counts, counts, {}}; }

/// z* whose share of rattlers, as packings have it, fits a number: `number_of` grows with z*.
template <class Function>
double contacts_at(const Function& number_of, double number) {
  double low = 0, high = 100;
  for (int round = 0; round < 80; ++round) {
    const double middle = (low + high) / 2;
    (number_of(middle) < number ? low : high) = middle;
  }
  return (low + high) / 2;
}

KnownContacts contacts_by_prior(const ContactPrior& prior) {
  const double z = prior.middle.mechanical_coordination_number;
  const auto step = [&](const ContactCounts& end, double sign) {
    const double at = z + sign * std::hypot(end.mechanical_coordination_number - z, prior.coordination_error);
    // Rattlers become fewer as contacts grow: the law of the prior between its ends, continued.
    const double z_there = std::max(at, 0.0);
    return ContactCounts{.mechanical_coordination_number = z_there,
                         .rattler_fraction = typical_rattler_fraction(z_there, prior.relative_overlap)};
  };
  return {.middle = prior.middle,
          .fewer = step(prior.loosest, -1),
          .more = step(prior.densest, 1),
          .validity = prior.validity};
}

/// z* is known: rattlers, and so C_n, are known to the prior's scatter.
KnownContacts contacts_by_z(double z, const ContactPrior& prior) {
  const double x = typical_rattler_fraction(z, prior.relative_overlap);
  const auto with = [&](double factor) {
    return ContactCounts{.mechanical_coordination_number = z, .rattler_fraction = std::min(x * factor, 0.9)};
  };
  const double factor = std::exp(prior.rattler_error);
  return {.middle = with(1), .fewer = with(factor), .more = with(1 / factor), .validity = {}};
}

/// C_n is known: more rattlers mean more contacts of the others.
KnownContacts contacts_by_C_n(double C_n, const ContactPrior& prior) {
  if (C_n == 0)
    return exactly({.mechanical_coordination_number = 0, .rattler_fraction = 0});
  const auto with = [&](double factor) {
    const double z = contacts_at(
        [&](double at) {
          return at * (1 - std::min(factor * typical_rattler_fraction(at, prior.relative_overlap), 0.9));
        },
        C_n);
    return of_z_and_C_n(z, C_n);
  };
  const double factor = std::exp(prior.rattler_error);
  return {.middle = with(1), .fewer = with(1 / factor), .more = with(factor), .validity = {}};
}

/// The share of rattlers is known: z* is where the prior has it, within its range. Rattlers of unequal
/// grains tell how unequal they are, rather than z*.
KnownContacts contacts_by_rattlers(double rattlers, const ContactPrior& prior, bool equal_grains) {
  KnownContacts range = contacts_by_prior(prior);
  if (!equal_grains) {
    for (ContactCounts* counts : {&range.middle, &range.fewer, &range.more})
      counts->rattler_fraction = rattlers;
    return range;
  }
  const auto with = [&](double factor) {
    const double z = contacts_at(
        [&](double at) { return -typical_rattler_fraction(at, prior.relative_overlap); }, -rattlers * factor);
    return ContactCounts{.mechanical_coordination_number =
                             std::clamp(z, range.fewer.mechanical_coordination_number,
                                        range.more.mechanical_coordination_number),
                         .rattler_fraction = rattlers};
  };
  const double factor = std::exp(prior.rattler_error);
  return {.middle = with(1), .fewer = with(factor), .more = with(1 / factor), .validity = prior.validity};
}

KnownContacts contacts_of(const PackingQuestion& q) {
  const std::optional<double>&C_n = q.coordination_number, &z = q.mechanical_coordination_number,
        &x = q.rattler_fraction;
  if (C_n && z && x)
    throw InvalidArgument("coordination_number, mechanical_coordination_number and rattler_fraction say one "
                          "thing too much: give two of them");
  if (C_n)
    require_non_negative("coordination_number", *C_n);
  if (z)
    require_non_negative("mechanical_coordination_number", *z);
  if (x)
    require_closed("rattler_fraction", *x, 0, 1);
  if (C_n && x)
    return exactly(
        {.mechanical_coordination_number = mechanical_coordination_number(*C_n, *x), .rattler_fraction = *x});
  if (z && x)
    return exactly({.mechanical_coordination_number = *z, .rattler_fraction = *x});
  if (C_n && z)
    return exactly(of_z_and_C_n(*z, *C_n));
  const ContactPrior prior = contact_prior(q.state, q.preparation);
  return z     ? contacts_by_z(*z, prior)
         : C_n ? contacts_by_C_n(*C_n, prior)
         : x   ? contacts_by_rattlers(*x, prior, q.state.contacts == sizes::ContactMeans{})
               : contacts_by_prior(prior);
}

// ---- quantities

enum Quantity : std::size_t {
  G_vh,
  K,
  E_v,
  nu,
  G_hh,
  E_h,
  V_s,
  V_p,
  V_s_h,
  V_p_h,
  density,
  coordination,
  mechanical_coordination,
  rattlers,
  quantity_count
};
using Quantities = std::array<double, quantity_count>;

Quantities quantities_of(const PackingQuestion& q, const ContactCounts& counts,
                         const elastic::TransverselyIsotropic& c) {
  Quantities all{};
  const bool stiff = c.positive_definite();
  all[G_vh] = c.G_vh();
  all[K] = c.bulk_modulus();
  all[E_v] = stiff ? c.E_v() : 0;
  all[nu] = stiff ? c.nu_vh() : 0.5; // the limit of vanishing shear stiffness
  all[G_hh] = c.G_hh();
  all[E_h] = stiff ? c.E_h() : 0;
  all[coordination] = counts.coordination_number();
  all[mechanical_coordination] = counts.mechanical_coordination_number;
  all[rattlers] = counts.rattler_fraction;
  if (!q.grain_density)
    return all;
  const double rho = elastic::bulk_density({.grain_density = *q.grain_density,
                                            .void_ratio = q.state.void_ratio,
                                            .pore_density = q.saturation * elastic::water_density});
  const elastic::TransverselyIsotropic undrained =
      q.saturation > 0
          ? elastic::saturated(c, {.grain_bulk_modulus = contact::bulk_modulus(q.state.law.grain()),
                                   .fluid_bulk_modulus = elastic::water_and_air_bulk_modulus(q.saturation),
                                   .void_ratio = q.state.void_ratio})
          : c;
  all[density] = rho;
  all[V_s] = std::sqrt(c.C44 / rho);
  all[V_s_h] = std::sqrt(c.C66() / rho);
  all[V_p] = std::sqrt(undrained.C33 / rho);
  all[V_p_h] = std::sqrt(undrained.C11 / rho);
  return all;
}

RelaxedEstimate relaxed_at(const PackingQuestion& q, const ContactCounts& counts) {
  State state = q.state;
  state.coordination_number = counts.coordination_number();
  return relaxed(state, counts.mechanical_coordination_number);
}

Quantities quantities_at(const PackingQuestion& q, const ContactCounts& counts) {
  return quantities_of(q, counts, relaxed_at(q, counts).stiffness);
}

// ---- ranges

/// What one input does to all quantities.
struct Effect {
  std::string input;
  Quantities low, high;

  Effect(std::string name, const Quantities& middle, const Quantities& a, const Quantities& b)
      : input(std::move(name)), low(middle), high(middle) {
    for (std::size_t k = 0; k < quantity_count; ++k) {
      low[k] = std::min({middle[k], a[k], b[k]});
      high[k] = std::max({middle[k], a[k], b[k]});
    }
  }
};

/// A stiffness of another K and another G, by factors.
elastic::TransverselyIsotropic scaled(const elastic::TransverselyIsotropic& c, double bulk, double shear) {
  const auto r = kernel::unbounded_relax<double>({c.C11, c.C33, c.C12, c.C13, c.C44}, bulk, shear, 0.0);
  return {.C11 = r.C11, .C33 = r.C33, .C12 = r.C12, .C13 = r.C13, .C44 = r.C44};
}

/// One standard error of rung 3, of G and of K in turn.
std::vector<Effect> effects_of_calibration(const PackingQuestion& q, const ContactCounts& counts,
                                           const RelaxedEstimate& estimate, const Quantities& middle) {
  const auto at = [&](double bulk, double shear) {
    return quantities_of(q, counts, scaled(estimate.stiffness, bulk, shear));
  };
  const double G_error = estimate.relative_error.G_vh, K_error = estimate.relative_error.bulk_modulus;
  return {{"rung 3", middle, at(1, 1 - G_error), at(1, 1 + G_error)},
          {"rung 3", middle, at(1 - K_error, 1), at(1 + K_error, 1)}};
}

double squared(double x) { return x * x; }

/// Quadrature of logarithms of what is positive, of differences of what is not.
Range range_of(std::size_t k, const Quantities& middle, const std::vector<Effect>& effects) {
  const bool logarithmic = middle[k] > 0 && k != nu && k != rattlers;
  double low = 0, high = 0;
  for (const Effect& e : effects) {
    low += squared(logarithmic ? std::log(middle[k] / e.low[k]) : middle[k] - e.low[k]);
    high += squared(logarithmic ? std::log(e.high[k] / middle[k]) : e.high[k] - middle[k]);
  }
  const double down = std::sqrt(low), up = std::sqrt(high);
  if (logarithmic)
    return {.value = middle[k], .low = middle[k] * std::exp(-down), .high = middle[k] * std::exp(up)};
  return {.value = middle[k],
          .low = k == nu ? std::max(-1.0, middle[k] - down) : std::max(0.0, middle[k] - down),
          .high = k == nu         ? std::min(0.5, middle[k] + up)
                  : k == rattlers ? std::min(1.0, middle[k] + up)
                                  : middle[k] + up};
}

std::vector<Share> shares_of(const std::vector<Effect>& effects) {
  std::vector<Share> shares;
  double sum = 0;
  for (const Effect& e : effects) {
    const double width = squared(e.high[G_vh] - e.low[G_vh]);
    sum += width;
    const auto same =
        std::find_if(shares.begin(), shares.end(), [&](const Share& s) { return s.input == e.input; });
    if (same != shares.end())
      same->share += width;
    else
      shares.push_back({e.input, width});
  }
  if (!(sum > 0))
    return {};
  for (Share& s : shares)
    s.share /= sum;
  std::erase_if(shares, [](const Share& s) { return s.share == 0; });
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& a, const Share& b) { return a.share > b.share; });
  return shares;
}

void require_valid_question(const PackingQuestion& q) {
  require_closed("saturation", q.saturation, 0, 1);
  if (q.grain_density)
    require_positive("grain_density", *q.grain_density, "kg/m3");
}

/// Whether both have the same contacts: all that the prior and the counts depend on is alike.
bool same_contacts(const PackingQuestion& a, const PackingQuestion& b) {
  return a.state.law == b.state.law && a.state.radius == b.state.radius &&
         a.state.void_ratio == b.state.void_ratio && a.state.stress_v == b.state.stress_v &&
         a.state.stress_h == b.state.stress_h && a.state.contacts == b.state.contacts &&
         a.preparation == b.preparation && a.coordination_number == b.coordination_number &&
         a.mechanical_coordination_number == b.mechanical_coordination_number &&
         a.rattler_fraction == b.rattler_fraction;
}

/// Whether both have the same stiffness as well.
bool same_packing(const PackingQuestion& a, const PackingQuestion& b) {
  return same_contacts(a, b) && a.state.tangential_ratio == b.state.tangential_ratio &&
         a.state.fabric_anisotropy == b.state.fabric_anisotropy;
}

} // namespace

PackingAnswer answer(const PackingQuestion& question, std::span<const InputSpread> uncertain) {
  require_valid_question(question);
  const KnownContacts contacts = contacts_of(question);
  const RelaxedEstimate estimate = relaxed_at(question, contacts.middle);
  const Quantities middle = quantities_of(question, contacts.middle, estimate.stiffness);
  std::vector<Effect> effects = effects_of_calibration(question, contacts.middle, estimate, middle);
  effects.emplace_back("contacts", middle, quantities_at(question, contacts.fewer),
                       quantities_at(question, contacts.more));
  // What an input leaves alone is not worked out again.
  const auto moved = [&](const PackingQuestion& q) {
    const ContactCounts counts = same_contacts(q, question) ? contacts.middle : contacts_of(q).middle;
    return same_packing(q, question) ? quantities_of(q, counts, estimate.stiffness)
                                     : quantities_at(q, counts);
  };
  for (const InputSpread& input : uncertain) {
    require_valid_question(input.less);
    require_valid_question(input.more);
    effects.emplace_back(input.name, middle, moved(input.less), moved(input.more));
  }
  const auto range = [&](std::size_t k) { return range_of(k, middle, effects); };
  const auto if_dense = [&](std::size_t k) {
    return question.grain_density ? std::optional(range(k)) : std::nullopt;
  };
  PackingAnswer all{.shear_modulus = range(G_vh),
                    .bulk_modulus = range(K),
                    .young_modulus = range(E_v),
                    .poisson_ratio = range(nu),
                    .G_hh = range(G_hh),
                    .horizontal_young_modulus = range(E_h),
                    .shear_wave_speed = if_dense(V_s),
                    .compression_wave_speed = if_dense(V_p),
                    .horizontal_shear_wave_speed = if_dense(V_s_h),
                    .horizontal_compression_wave_speed = if_dense(V_p_h),
                    .bulk_density = if_dense(density),
                    .coordination_number = range(coordination),
                    .mechanical_coordination_number = range(mechanical_coordination),
                    .rattler_fraction = range(rattlers),
                    .shares = shares_of(effects),
                    .validity = contacts.validity};
  all.validity.merge(estimate.validity);
  all.validity.keep_each_once();
  return all;
}

} // namespace granum::effective
