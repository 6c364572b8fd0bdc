// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/slip.hpp>
#include <granum/sands/strain.hpp>

#include "core/root.hpp"
#include "parts.hpp"

namespace granum::estimate {

namespace {

using elastic::TransverselyIsotropic;
using sands::Sand;

/// Changes of each law of sands from its middle.
struct Moved {
  double shear_factor = 1;     ///< factor on G
  double poisson_ratio = 0;    ///< added
  double exponent = 0;         ///< added to s
  double horizontal_share = 0; ///< added to m/s
  double shear_anisotropy = 0; ///< added to G_hh/G_vh
  double young_anisotropy = 0; ///< added to E_h/E_v
  sands::StrainMoves strain = {};
};

/// The isotropic stress with the same effect on G_vh: sigma_v^n sigma_h^m = p^(n + m).
double shear_stress_equivalent(const effective::State& s) {
  return s.stress_v == s.stress_h
             ? s.stress_v
             : std::pow(s.stress_v, sands::vertical_share) * std::pow(s.stress_h, sands::horizontal_share);
}

/// Poisson's ratio, limited to the possible range of an isotropic skeleton.
double poisson_ratio(const Question& q, const Moved& moved) {
  return std::clamp(sands::poisson_ratio(q.sand, q.state.mean_stress()).value + moved.poisson_ratio, 0.0,
                    0.45);
}

double oedometric(double G, double nu) { return G * 2 * (1 - nu) / (1 - 2 * nu); }

/// Equal spheres of these grains under the mean stress, free to roll.
effective::State spheres_of(const Question& q) {
  effective::State state = q.state;
  if (state.contacts.pair_radius != 1) // the law is that of the mean pair
    state.law = state.law.of_pair_radius(1 / state.contacts.pair_radius);
  state.contacts = {};
  state.rolling = 0;
  state.fabric_anisotropy = 0;
  state.stress_v = state.stress_h = q.state.mean_stress();
  return state;
}

/// The z* at which rung 3 has this Poisson's ratio, and the contact stiffness relative to the model that
/// gives this G.
void infer_contacts(Values& all, const Question& q, double G, double nu) {
  const effective::State state = spheres_of(q);
  const auto stiffness = [&](double z) {
    effective::State there = state;
    there.coordination_number = there.mechanical_coordination_number = z;
    return effective::relaxed(there, z).stiffness;
  };
  // nu decreases as z* grows.
  const auto missing = [&](double z) { return nu - stiffness(z).nu_vh(); };
  const double least = effective::isostatic_coordination_number(state.tangential_ratio) + 0.05, most = 12;
  double z = least;
  const double at_least = missing(least), at_most = missing(most);
  if (at_most <= 0)
    z = most;
  else if (at_least < 0)
    z = middle(root_between(missing, least, most, at_least, at_most, within_share(1e-14), 60));
  at(all, Field::mechanical_coordination_number) = z;
  at(all, Field::contact_softness) = G / stiffness(z).G_vh();
}

/// Strain at which slip at the inferred contacts reduces G by 1 %.
double slip_strain(Values& all, const Question& q) {
  constexpr double loss = 0.01;
  effective::State state = spheres_of(q);
  const double z = at(all, Field::mechanical_coordination_number);
  state.coordination_number = state.mechanical_coordination_number = z;
  const effective::SlipOnset onset = effective::slip_onset(state, z, sands::grain_friction);
  return effective::strain_of_slip_loss(onset, loss) / at(all, Field::contact_softness);
}

sands::StrainAnswer strained(const Question& q, const sands::StrainMoves& moves) {
  return sands::strained({.strain = *q.shear_strain,
                          .void_ratio = q.state.void_ratio,
                          .mean_stress = q.state.mean_stress(),
                          .sand = q.sand},
                         moves);
}

void set_strain(Values& all, const Question& q, const Moved& moved) {
  const sands::StrainAnswer of_strain = strained(q, moved.strain);
  at(all, Field::modulus_ratio) = of_strain.ratio;
  at(all, Field::strained_shear_modulus) = of_strain.ratio * at(all, Field::shear_modulus);
  at(all, Field::damping_ratio) = of_strain.damping;
  at(all, Field::slip_strain) = slip_strain(all, q);
}

bool is_strained(const Question& q) { return q.shear_strain && q.state.mean_stress() > 0; }

Values sand_values(const Question& q, const Moved& moved = {}) {
  Values all{};
  const effective::State& s = q.state;
  const auto G = [&](double stress) {
    return moved.shear_factor * sands::extrapolated_shear_modulus(q.sand, s.void_ratio, stress);
  };
  const double nu = poisson_ratio(q, moved), by_young = 2 * (1 + nu);
  const double G_vh = G(shear_stress_equivalent(s)), mean = G(s.mean_stress());
  const double K = mean * by_young / (3 * (1 - 2 * nu));
  at(all, Field::shear_modulus) = G_vh;
  at(all, Field::horizontal_shear_modulus) =
      (sands::shear_anisotropy + moved.shear_anisotropy) * G(s.stress_h);
  at(all, Field::bulk_modulus) = K;
  at(all, Field::young_modulus) = by_young * G(s.stress_v);
  at(all, Field::horizontal_young_modulus) =
      (sands::young_anisotropy + moved.young_anisotropy) * by_young * G(s.stress_h);
  at(all, Field::poisson_ratio) = nu;
  if (mean > 0)
    infer_contacts(all, q, mean, nu);
  const double exponent = sands::growth_exponent(q.sand, shear_stress_equivalent(s)).value + moved.exponent;
  at(all, Field::stress_exponent) = exponent;
  at(all, Field::horizontal_exponent) = (sands::horizontal_share + moved.horizontal_share) * exponent;
  at(all, Field::vertical_exponent) = (sands::vertical_share - moved.horizontal_share) * exponent;
  if (is_strained(q))
    set_strain(all, q, moved);
  if (q.grain_density) {
    TransverselyIsotropic c{.C11 = oedometric(G(s.stress_h), nu),
                            .C33 = oedometric(G(s.stress_v), nu),
                            .C12 = 0,
                            .C13 = 0,
                            .C44 = G_vh};
    c.C12 = c.C11 - 2 * all[static_cast<std::size_t>(Field::horizontal_shear_modulus)];
    c.C13 = (9 * K - 2 * c.C11 - c.C33 - 2 * c.C12) / 4;
    set_speeds(all, q, c);
  }
  require_finite_values(all);
  return all;
}

/// Whether that number exists for this sand.
bool has(const FieldRow& row, const Question& q) {
  switch (row.field) {
  case Field::rattler_fraction:
  case Field::coordination_number:
    return false; // cannot be inferred: rattlers are unknown
  case Field::mechanical_coordination_number:
  case Field::contact_softness:
  case Field::vertical_exponent:
  case Field::horizontal_exponent:
  case Field::stress_exponent:
    return q.state.stress_v > 0 && q.state.stress_h > 0;
  case Field::strained_shear_modulus:
  case Field::modulus_ratio:
  case Field::damping_ratio:
  case Field::slip_strain:
    return is_strained(q);
  default:
    return !row.needs_density || q.grain_density;
  }
}

} // namespace

Answer sand_answer(const Question& q, std::span<const Spread> spreads) {
  effective::State beside = q.state;
  if (q.sand.uniformity.value_or(1) > sphere_uniformity_limit)
    beside.contacts = {};
  Question spheres = q;
  spheres.state = beside;
  const effective::ContactCounts counts = contacts_of(spheres).middle;
  beside.coordination_number = beside.coordination_number.value_or(counts.coordination_number());
  beside.mechanical_coordination_number = counts.mechanical_coordination_number;

  Answer all(std::move(beside));
  all.grain_shape_ = GrainShape::sand;
  all.middle_ = sand_values(q);
  const auto add = [&](const char* input, bool assumed, const Moved& less, const Moved& more) {
    all.effects_.push_back(
        effect_of(input, assumed, all.middle_, sand_values(q, less), sand_values(q, more)));
  };
  const double p = q.state.mean_stress();
  const double factor = sands::stated_factor(q.sand, q.state.void_ratio, p);
  const double nu = sands::poisson_ratio(q.sand, p).deviation;
  const double s = sands::growth_exponent(q.sand, shear_stress_equivalent(q.state)).deviation;
  add("sand to sand", true, {.shear_factor = 1 / factor}, {.shear_factor = factor});
  add("Poisson's ratio", true, {.poisson_ratio = -nu}, {.poisson_ratio = nu});
  add("exponent", true, {.exponent = -s}, {.exponent = s});
  add("exponent", true, {.horizontal_share = -sands::share_deviation},
      {.horizontal_share = sands::share_deviation});
  add("anisotropy", true, {.shear_anisotropy = -sands::shear_anisotropy_deviation},
      {.shear_anisotropy = sands::shear_anisotropy_deviation});
  add("anisotropy", true, {.young_anisotropy = -sands::young_anisotropy_deviation},
      {.young_anisotropy = sands::young_anisotropy_deviation});
  if (is_strained(q)) {
    for (const auto& [name, part] : {std::pair{"strain", &sands::StrainMoves::reference_strain},
                                     {"damping", &sands::StrainMoves::least_damping},
                                     {"damping", &sands::StrainMoves::damping_growth}}) {
      Moved less, more;
      less.strain.*part = -1;
      more.strain.*part = 1;
      add(name, true, less, more);
    }
    all.validity_.merge(strained(q, {}).validity);
  }
  for (const Spread& spread : spreads)
    all.effects_.push_back(effect_of(spread.input, spread.assumed, all.middle_, sand_values(spread.less),
                                     sand_values(spread.more)));
  for (const FieldRow& row : fields())
    if (has(row, q))
      all.ranges_[static_cast<std::size_t>(row.field)] = range_of(row, all.middle_, all.effects_);
  note_strength(q, all.validity_);
  all.validity_.merge(sands::outside_of_tests(q.sand, q.state.void_ratio, p));
  all.validity_.keep_each_once();
  return all;
}

} // namespace granum::estimate
