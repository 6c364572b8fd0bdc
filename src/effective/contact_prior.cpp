// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/contact_prior.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

#include "contact_prior_coefficients.hpp"
#include "contact_prior_kernel.hpp"
#include "core/root.hpp"

namespace granum::effective {

namespace {

/// Friction coefficients of smooth minerals.
constexpr double least_friction = 0.3, most_friction = 0.5;
/// Void ratios of the loosest packing of equal spheres possible in theory at any friction
/// [SongWangMakse2008], and of the densest disordered one.
constexpr double loosest_spheres = 0.866, densest_disorder = 0.55;
/// Growth of the error of z* per unit of e, beyond the void ratios where packings of spheres are known. Loose
/// side: one contact between e_l and the loosest packing possible in theory. Dense side: the slope of the
/// densest line. The error stops growing at the distance to the fewest, or the most, contacts of any packing.
constexpr double error_slope_loose = 7, error_slope_dense = 15;
constexpr double largest_error_loose = 2, largest_error_dense = 6;
/// Standard deviation of ln x_0 of unequal grains, which have one to ten times as many rattlers as equal
/// ones.
constexpr double unequal_rattler_error = 1.5;

void require_prior_inputs(const State& s) {
  require_positive("radius", s.radius, "m");
  require_positive("void_ratio", s.void_ratio);
  sizes::require_valid(s.contacts);
  require_non_negative("stress_v", s.stress_v, "Pa");
  require_non_negative("stress_h", s.stress_h, "Pa");
}

/// Closing overlap of the mean force over the mean branch, at C_n contacts.
double relative_overlap(const State& s, double pressure, double coordination_number) {
  const double R = s.radius, branch = s.contacts.branch;
  const double load =
      4 * std::numbers::pi * R * R * (1 + s.void_ratio) * pressure * (s.contacts.grain_volume / branch);
  return s.law.closing_law().overlap(load / coordination_number) / (2 * R * branch);
}

ContactCounts with_rattlers(double z, double overlap) {
  return {.mechanical_coordination_number = z,
          .rattler_fraction = kernel::rattlers_of_contacts(z, overlap, kernel::rattler_coefficients)};
}

/// Solves for consistent counts and overlap: more overlap means more contacts and a smaller force on each.
struct Rest {
  ContactCounts counts;
  double void_ratio = 0;
  double overlap = 0;
};

/// \param   counts_at   of void ratio and overlap
/// \param   void_ratio_at   of the overlap
template <class CountsAt, class VoidRatioAt>
Rest at_rest(State s, double pressure, const CountsAt& counts_at, const VoidRatioAt& void_ratio_at) {
  Rest rest{.counts = counts_at(s.void_ratio, 0.0), .void_ratio = s.void_ratio, .overlap = 0};
  // Each iteration leaves a small part of the difference, since contacts grow as the root of the overlap.
  for (int round = 0; round < 60; ++round) {
    const double overlap = relative_overlap(s, pressure, rest.counts.coordination_number());
    const bool settled = std::abs(overlap - rest.overlap) <= 1e-15 * overlap;
    rest.overlap = overlap;
    rest.void_ratio = s.void_ratio = void_ratio_at(overlap);
    rest.counts = counts_at(s.void_ratio, overlap);
    if (settled)
      break;
  }
  return rest;
}

/// The rigid void ratio of the densest packing of the same grains, if it is known and one of spheres.
std::optional<double> known_densest(const State& s, const Preparation& preparation) {
  constexpr double usual_pressure = 10e3; // up to which packings are made without friction
  State densest = s;
  densest.void_ratio = preparation.densest_void_ratio;
  if (!(densest.void_ratio > 0 && densest.void_ratio <= kernel::loosest_densest))
    return std::nullopt;
  const double overlap = relative_overlap(
      densest, preparation.pressure > 0 ? preparation.pressure : usual_pressure, kernel::most_rigid_contacts);
  return kernel::rigid_void_ratio(densest.void_ratio, overlap, kernel::contact_coefficients);
}

/// That of equal spheres, where the densest packing is known.
double comparable_void_ratio(double rigid_void_ratio, std::optional<double> densest) {
  return densest ? kernel::as_of_equal(rigid_void_ratio, *densest, kernel::contact_coefficients)
                 : rigid_void_ratio;
}

/// What the shape of contacts and the sizes of grains add to z* of packings compressed with friction.
double shift_by_grains(const State& s) {
  return kernel::shift_by_grains(s.law.closing_law().exponent_at_force(0),
                                 kernel::branch_variance(s.contacts), kernel::grain_shift);
}

/// Contacts on the densest line, or of grains with a friction coefficient.
Rest packing_of(const State& s, std::optional<double> friction, std::optional<double> densest) {
  const double shift = densest ? shift_by_grains(s) : 0;
  const auto counts_at = [&](double void_ratio, double overlap) {
    const double rigid = comparable_void_ratio(
        kernel::rigid_void_ratio(void_ratio, overlap, kernel::contact_coefficients), densest);
    const double z =
        friction
            ? kernel::contacts_of_friction(*friction, rigid, overlap, kernel::contact_coefficients) + shift
            : kernel::densest_contacts(rigid, overlap, kernel::contact_coefficients);
    return with_rattlers(z, overlap);
  };
  return at_rest(s, s.mean_stress(), counts_at, [&](double) { return s.void_ratio; });
}

/// The range of friction of a preparation; empty for the densest line.
struct FrictionRange {
  std::optional<double> most, least;
};

FrictionRange frictions_of(const Preparation& preparation) {
  switch (preparation.kind) {
  case Preparation::Kind::dense:
    return {};
  case Preparation::Kind::loose:
    return {.most = most_friction, .least = least_friction};
  case Preparation::Kind::friction:
    require_positive("friction_coefficient", preparation.friction_coefficient);
    return {.most = preparation.friction_coefficient, .least = preparation.friction_coefficient};
  default:
    return {.most = most_friction, .least = std::nullopt};
  }
}

/// How far a void ratio lies beyond those of disordered packings of equal spheres.
struct Beyond {
  double loose = 0, dense = 0;
};
Beyond beyond_spheres(double rigid_void_ratio) {
  const auto& [densest, loosest] =
      std::pair(kernel::contact_coefficients[0], kernel::contact_coefficients[1]);
  return {.loose = std::max(0.0, rigid_void_ratio - loosest),
          .dense = std::max(0.0, std::min(densest, densest_disorder) - rigid_void_ratio)};
}

bool unequal(const State& s) { return s.contacts != sizes::ContactMeans{}; }

/// "0.9", or "0.6 (0.88 without overlaps)" where they matter.
std::string void_ratio_text(double void_ratio, double rigid_void_ratio) {
  constexpr int digits = 3;
  const std::string text = short_text(void_ratio, digits), rigid = short_text(rigid_void_ratio, digits);
  return text == rigid ? text : text + " (" + rigid + " without overlaps)";
}

void note_density(double void_ratio, double rigid_void_ratio, const Beyond& beyond, Validity& validity) {
  if (!(beyond.loose > 0 || beyond.dense > 0))
    return;
  const std::string e = void_ratio_text(void_ratio, rigid_void_ratio);
  if (beyond.loose > 0)
    validity.add(rigid_void_ratio > loosest_spheres
                     ? "no sphere packing is so loose: void ratio " + e +
                           ", at most 0.87. In a sand this loose, angular or rough grains support each other "
                           "where spheres would roll away; contacts of the loosest spheres are used"
                     : "at void ratio " + e +
                           " spheres are stable only if they can hardly roll, like angular grains: with "
                           "friction alone their loosest packing has 0.75. Contacts of the loosest spheres "
                           "with friction are used");
  if (beyond.dense > 0)
    validity.add("no disordered packing of equal spheres is so dense: void ratio " + e +
                 ", at least 0.55. A sand this dense has grains of many sizes, or grains that fit together; "
                 "contacts of the densest spheres are used");
}

void note_friction(const State& s, const Preparation& preparation, double rigid_void_ratio,
                   Validity& validity) {
  if (preparation.kind != Preparation::Kind::friction)
    return;
  const double own =
      kernel::rigid_contacts_of_friction(preparation.friction_coefficient, kernel::contact_coefficients);
  const double line = kernel::densest_rigid_contacts(rigid_void_ratio, kernel::contact_coefficients);
  if (own > line + 2 * kernel::friction_scatter)
    validity.add(detail::formatted("friction %.3g is too small for a packing of void ratio %.3g: the "
                                   "contacts are those of the smallest sufficient friction",
                                   preparation.friction_coefficient, s.void_ratio));
}

void note_sizes(const State& s, Validity& validity) {
  if (unequal(s))
    validity.add(
        "contacts of unequal grains are assumed to be those of equal ones: at the same void ratio unequal "
        "grains have fewer contacts, and more rattlers (validation/sizes: 13 % dense, 39 % loose); give them "
        "if known");
}

void note_overlap(double overlap, Validity& validity) {
  if (overlap > kernel::largest_overlap)
    validity.add(detail::formatted(
        "mean overlap is %.3g diameters: the numbers of contacts are calibrated up to 0.01", overlap));
}

} // namespace

Preparation preparation_of(std::string_view given) {
  std::string text(given);
  for (std::size_t k = 0; k < text.size() && text[k] != ':'; ++k) // units keep their letters
    if (text[k] >= 'A' && text[k] <= 'Z')
      text[k] = static_cast<char>(text[k] - 'A' + 'a');
  constexpr std::string_view friction = "friction:", dense = "dense:";
  if (text == "dense")
    return {.kind = Preparation::Kind::dense};
  if (text == "loose")
    return {.kind = Preparation::Kind::loose};
  if (text.starts_with(dense))
    return {.kind = Preparation::Kind::dense,
            .pressure = require_positive(
                "pressure of preparation",
                parse_quantity("pressure of preparation", text.substr(dense.size()), Dimension::pressure),
                "Pa")};
  if (!text.starts_with(friction))
    throw InvalidArgument(unknown_word(
        "preparation", text, std::vector<std::string>{"dense", "dense:10kPa", "loose", "friction:0.3"}));
  const double coefficient =
      parse_quantity("friction_coefficient", text.substr(friction.size()), Dimension::dimensionless);
  return {.kind = Preparation::Kind::friction,
          .friction_coefficient = require_positive("friction_coefficient", coefficient)};
}

double typical_rattler_fraction(double mechanical_coordination_number, double relative_overlap) {
  const double z = require_non_negative("mechanical_coordination_number", mechanical_coordination_number);
  const double overlap = require_non_negative("relative_overlap", relative_overlap);
  return std::min(kernel::rattlers_of_contacts(z, overlap, kernel::rattler_coefficients), 0.9);
}

namespace {

/// Standard deviation of z* of packings of spheres: of recipes left out; with the densest packing known of
/// those and of unequal grains and codes.
double scatter_of(const State& s, const Preparation& preparation) {
  if (!known_densest(s, preparation))
    return preparation.kind == Preparation::Kind::dense ? kernel::line_scatter : kernel::friction_scatter;
  return std::hypot(kernel::above_densest_scatter, kernel::above_densest_code_scatter,
                    kernel::above_densest_size_scatter * std::sqrt(kernel::branch_variance(s.contacts)));
}

} // namespace

void require_valid(const Preparation& preparation, const State& state) {
  const double p = state.mean_stress();
  if (preparation.pressure > 0 && p > 0 && !(preparation.pressure <= p))
    throw InvalidArgument("pressure of preparation", preparation.pressure, "Pa",
                          "(0, " + pretty(p, Dimension::pressure) +
                              "], the mean stress: a packing that was unloaded has other forces");
  if (const double densest = preparation.densest_void_ratio; densest > 0) {
    constexpr double densest_equal = 0.5, densest_of_sizes = 0.2; // packed without friction
    constexpr double overlaps = 1.02;                             // which make packings denser under pressure
    const double least = unequal(state) ? densest_of_sizes : densest_equal;
    const double most = overlaps * (1 + state.void_ratio) - 1;
    if (!(densest >= least && densest <= most))
      throw InvalidArgument("least_void_ratio", densest, "",
                            detail::closed_range(least, most, densest) +
                                ", from that of spheres packed without friction to the void ratio");
  }
}

ContactPrior contact_prior(const State& state, const Preparation& preparation) {
  require_prior_inputs(state);
  require_valid(preparation, state);
  return kernel::possible_contact_prior(state, preparation);
}

ContactPrior kernel::possible_contact_prior(const State& state, const Preparation& preparation) {
  require_prior_inputs(state);
  const auto [most, least] = frictions_of(preparation);
  const std::optional<double> densest_known = known_densest(state, preparation);
  const Rest loosest = packing_of(state, most, densest_known),
             densest = packing_of(state, least, densest_known);
  const double overlap = (loosest.overlap + densest.overlap) / 2;
  const double rigid = comparable_void_ratio(
      kernel::rigid_void_ratio(state.void_ratio, overlap, kernel::contact_coefficients), densest_known);
  const Beyond beyond = beyond_spheres(rigid);
  const double scatter = scatter_of(state, preparation);
  ContactPrior prior{
      .loosest = loosest.counts,
      .middle = with_rattlers(
          (loosest.counts.mechanical_coordination_number + densest.counts.mechanical_coordination_number) / 2,
          overlap),
      .densest = densest.counts,
      .coordination_error =
          std::hypot(scatter, std::min(error_slope_loose * beyond.loose, largest_error_loose) +
                                  std::min(error_slope_dense * beyond.dense, largest_error_dense)),
      .packing_scatter = scatter,
      .rattler_error = unequal(state) ? unequal_rattler_error : kernel::rattler_scatter,
      .relative_overlap = overlap,
      .validity = {}};
  note_density(state.void_ratio, densest_known ? state.void_ratio : rigid, beyond, prior.validity);
  note_friction(state, preparation, rigid, prior.validity);
  note_sizes(state, prior.validity);
  note_overlap(overlap, prior.validity);
  if (preparation.densest_void_ratio > kernel::loosest_densest)
    prior.validity.add(detail::formatted(
        "least void ratio %.4g: spheres packed without friction have at most %.3g; it is not used",
        preparation.densest_void_ratio, kernel::loosest_densest));
  return prior;
}

CarriedContacts carried_contacts(const State& known, const ContactCounts& counts, double pressure) {
  require_prior_inputs(known);
  const double z = require_positive("mechanical_coordination_number", counts.mechanical_coordination_number);
  require_closed("rattler_fraction", counts.rattler_fraction, 0, 1);
  require_positive("1 - rattler_fraction", 1 - counts.rattler_fraction);
  require_non_negative("pressure", pressure, "Pa");
  const auto& c = kernel::contact_coefficients;
  const double before = relative_overlap(known, known.mean_stress(), counts.coordination_number());
  const double rigid = kernel::rigid_void_ratio(known.void_ratio, before, c);
  const double rattlers = kernel::rattlers_of_contacts(z, before, kernel::rattler_coefficients);
  const auto counts_at = [&](double, double overlap) {
    const double z_here = kernel::carried_contacts(z, rigid, before, overlap, c);
    const double share = counts.rattler_fraction / rattlers *
                         kernel::rattlers_of_contacts(z_here, overlap, kernel::rattler_coefficients);
    return ContactCounts{.mechanical_coordination_number = z_here, .rattler_fraction = std::min(share, 0.99)};
  };
  const auto void_ratio_at = [&](double overlap) { return (1 + rigid) / (1 + c[3] * overlap) - 1; };
  const Rest rest = at_rest(known, pressure, counts_at, void_ratio_at);
  CarriedContacts carried{.counts = rest.counts,
                          .void_ratio = rest.void_ratio,
                          .relative_overlap = rest.overlap,
                          .coordination_error =
                              kernel::carried_scatter * kernel::root_of_way(before, rest.overlap),
                          .validity = {}};
  note_overlap(std::max(before, rest.overlap), carried.validity);
  return carried;
}

namespace {

/// Largest number of neighbours that equal spheres can touch.
constexpr double most_contacts = 12;
/// z* above the isostatic point at which a network counts as just rigid.
constexpr double just_rigid = 1e-9;

double modulus_with(const State& state, double z, std::optional<double> rattlers, Modulus which) {
  const double fraction = rattlers ? *rattlers : expected_rattlers(state, z).fraction;
  return modulus(relaxed(with_contacts(state, z, fraction), z).stiffness, which);
}

void require_growing(Modulus which) {
  if (which == Modulus::K || which == Modulus::G_hh || which == Modulus::G_vh || which == Modulus::C11 ||
      which == Modulus::C33)
    return;
  throw InvalidArgument(
      "a coordination number follows from K, G_hh, G_vh, C11 or C33, which grow with it; the given "
      "modulus may not");
}

} // namespace

ExpectedRattlers expected_rattlers(const State& state, double mechanical_coordination_number) {
  const double z = require_positive("mechanical_coordination_number", mechanical_coordination_number);
  double fraction = 0;
  // Fewer contacts carry larger forces and overlap more: each iteration leaves a small part of the
  // difference.
  for (int round = 0; round < 60; ++round) {
    const State with = with_contacts(state, z, fraction);
    const double overlap =
        with.law.closing_law().overlap(mean_contact_force(with)) / (2 * with.radius * with.contacts.branch);
    const double before = fraction;
    fraction = kernel::rattlers_of_contacts(z, overlap, kernel::rattler_coefficients);
    if (std::abs(fraction - before) <= 1e-15 * fraction)
      break;
  }
  return {.fraction = fraction, .scatter = kernel::rattler_scatter};
}

State with_contacts(State state, double mechanical_coordination_number, double rattler_fraction) {
  const double z = require_non_negative("mechanical_coordination_number", mechanical_coordination_number);
  if (!(rattler_fraction >= 0 && rattler_fraction < 1))
    throw InvalidArgument("rattler_fraction", rattler_fraction, "", "[0, 1)");
  state.coordination_number = z * (1 - rattler_fraction);
  state.mechanical_coordination_number = z;
  return state;
}

ImpliedCoordination implied_coordination(const State& state, Modulus which, double modulus,
                                         std::optional<double> rattler_fraction) {
  require_growing(which);
  require_positive("modulus", modulus, "Pa");
  require_positive("stress_v", state.stress_v, "Pa");
  const double isostatic = isostatic_coordination_number(state.tangential_ratio);
  // In ln(z* - isostatic point) a modulus is nearly a power law, also where it vanishes.
  const auto excess = [&](double logarithm) {
    return std::log(modulus_with(state, isostatic + std::exp(logarithm), rattler_fraction, which) / modulus);
  };
  const double low = std::log(just_rigid), high = std::log(most_contacts - isostatic);
  const double below = excess(low), above = excess(high);
  ImpliedCoordination implied{.mechanical_coordination_number = std::nullopt,
                              .softest = modulus * std::exp(below),
                              .stiffest = modulus * std::exp(above)};
  if (below > 0 || above < 0) {
    implied.explained = below > 0 ? Explained::too_soft : Explained::too_stiff;
    return implied;
  }
  const double at =
      middle(root_between(excess, low, high, below, above, boost::math::tools::eps_tolerance<double>()));
  implied.mechanical_coordination_number = isostatic + std::exp(at);
  return implied;
}

} // namespace granum::effective
