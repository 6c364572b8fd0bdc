// SPDX-License-Identifier: GPL-3.0-or-later
// Exponents of rung 3, of packings whose contacts grow with the stress.
#include <granum/effective/exponents.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <granum/core/error.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/fabric/orientation.hpp>

#include "contact_prior_kernel.hpp"
#include "kernels.hpp"
#include "mixture_kernel.hpp"
#include "relaxation_kernel.hpp"
#include "relaxed_constants.hpp"
#include "stress_derivatives.hpp"
#include "unevenness_kernel.hpp"

namespace granum::effective {

namespace {

using Eigen::Vector2d;
using kernel::Dual;

/// d ln p by ln stress_v and ln stress_h.
Vector2d pressure_slopes(const State& s) {
  return Vector2d(s.stress_v, 2 * s.stress_h) / (3 * s.mean_stress());
}

/// d ln (C_n/(1+e))/d ln p.
double density_growth(const State& s, const Growth& growth) {
  return growth.coordination_number - growth.void_ratio / (1 + s.void_ratio);
}

/// Constants of uniform_strain(state) with their derivatives by the stresses. Each constant is C_n/(1+e)
/// times a function of stresses over C_n/(1+e), so its derivative is that at frozen contacts plus that by the
/// density of contacts C_n/(1+e); where b is the same at every force, the constant grows as its power 1-b.
kernel::RelaxedConstants<Dual> uniform_constants(const State& s, const Growth& growth) {
  const kernel::Constants<Dual> frozen = kernel::stress_derivatives(s, {});
  const Vector2d slopes = density_growth(s, growth) * pressure_slopes(s);
  const std::optional<double> b = s.law.constant_exponent();
  const auto growing = [&](const Dual& X) {
    const double by_density = b ? (1 - *b) * X.value() : X.value() - X.derivatives().sum();
    return Dual(X.value(), X.derivatives() + by_density * slopes);
  };
  return {growing(frozen.C11), growing(frozen.C33), growing(frozen.C12), growing(frozen.C13),
          growing(frozen.C44)};
}

/// b at the mean force, with its derivatives by the stresses, which change that force.
Dual growing_exponent(const State& s, const Growth& growth) {
  const double b = kernel::local_exponent(s);
  if (s.law.constant_exponent())
    return {b, Vector2d::Zero()};
  const double by_force = s.law.exponent_slope_at_force(mean_contact_force(s));
  return {b, by_force * (1 - density_growth(s, growth)) * pressure_slopes(s)};
}

/// kernel::shortened_branches with its derivatives by the stresses.
Dual shortened_branches(const State& s, const Dual& b, const Growth& growth) {
  const double w = kernel::mean_overlap(s);
  if (w > kernel::longest_shortening)
    return kernel::shortened_branches(Dual(kernel::longest_shortening, Vector2d::Zero()), b);
  const double by_pressure =
      w > 0 ? w * kernel::overlap_exponent(s.law, mean_contact_force(s)) * (1 - density_growth(s, growth))
            : 0;
  return kernel::shortened_branches(Dual(w, by_pressure * pressure_slopes(s)), b);
}

/// Multiplies both factors by what the unevenness of forces says, which changes with the forces.
void add_unevenness(const State& s, const Dual& z, const Dual& b, const Growth& growth, Dual& shear,
                    Dual& bulk) {
  using std::exp;
  const Dual share = kernel::share_of_unevenness(z), h = shear,
             Q(s.unevenness->value,
               s.unevenness->by_pressure * (1 - density_growth(s, growth)) * pressure_slopes(s));
  for (const auto& [factor, c] :
       {std::pair{&shear, &kernel::shear_gain}, std::pair{&bulk, &kernel::bulk_gain}}) {
    const Dual gain = share * kernel::gain_by_unevenness(Q, h, b, z, kernel::branch_variance(s.contacts),
                                                         kernel::constants<Dual>(*c));
    *factor = Dual(*factor * exp(gain));
  }
}

kernel::Constants<Dual> relaxed_constants(const State& s, double z, const Growth& growth) {
  const auto constant = [](double value) { return Dual(value, Vector2d::Zero()); };
  const Dual z_star(z, growth.mechanical_coordination_number * pressure_slopes(s));
  const Dual r = constant(s.tangential_ratio), b = growing_exponent(s, growth);
  const kernel::ByExponent<Dual> effect =
      kernel::by_exponent(b, kernel::going_on(s.law.surface().stiffening));
  const Dual own = kernel::rolled_shear_relaxation(
      kernel::coordination_of_equal(z_star, kernel::branch_variance(s.contacts)), r, effect.own,
      kernel::constants<Dual>(kernel::shear_coefficients), s.rolling);
  Dual shear = own * kernel::left_of_shear(own, effect);
  const auto of_bulk = kernel::constants<Dual>(kernel::bulk_coefficients);
  Dual bulk = kernel::stiffened_bulk(z_star, r, effect, of_bulk, s.rolling) *
              kernel::size_bulk_share(z_star, effect, constant(kernel::size_loss),
                                      kernel::branch_variance(s.contacts), of_bulk);
  if (s.unevenness)
    add_unevenness(s, z_star, b, growth, shear, bulk);
  const fabric::SecondMoments F = fabric::second_moments(s.fabric_anisotropy);
  const Dual log_stress(std::log(s.stress_v / s.stress_h), Vector2d(1, -1));
  const Dual stretch = kernel::log_stretch(shear, kernel::up_to_half(b), constant(std::log(F.F33 / F.F11)),
                                           log_stress, kernel::constants<Dual>(kernel::stretch_coefficients));
  for (const auto& [factor, mixing] :
       {std::pair{&shear, &kernel::shear_mixing}, std::pair{&bulk, &kernel::bulk_mixing}}) {
    const kernel::Mixed mixed = kernel::left_by_mixing(s.pair_shares, z, *mixing);
    *factor *= Dual(mixed.left, mixed.by_coordination * z_star.derivatives());
  }
  const kernel::RelaxedConstants<Dual> c =
      kernel::relax<Dual>(uniform_constants(s, growth), bulk, shear, stretch);
  const Dual left = shortened_branches(s, b, growth);
  return {.C11 = left * c.C11,
          .C33 = left * c.C33,
          .C12 = left * c.C12,
          .C13 = left * c.C13,
          .C44 = left * c.C44};
}

void require_finite(const Growth& growth) {
  granum::require_finite("growth.coordination_number", growth.coordination_number);
  granum::require_finite("growth.mechanical_coordination_number", growth.mechanical_coordination_number);
  granum::require_finite("growth.void_ratio", growth.void_ratio);
}

constexpr ClosingGapLaw law_of(const std::array<double, 7>& c) {
  return {.initial = c[0],
          .amplitude = c[1],
          .exponent = c[2],
          .spread = c[3],
          .rattlers = c[4],
          .rattler_decay = c[5],
          .scatter = c[6]};
}

void require_valid(const MeasuredPacking& packing) {
  require_positive("pressure", packing.pressure, "Pa");
  require_positive("coordination_number", packing.coordination_number);
  require_positive("mechanical_coordination_number", packing.mechanical_coordination_number);
  require_positive("void_ratio", packing.void_ratio);
}

} // namespace

Growth growth_between(const MeasuredPacking& first, const MeasuredPacking& second) {
  require_valid(first);
  require_valid(second);
  const double step = std::log(second.pressure / first.pressure);
  if (step == 0)
    throw InvalidArgument("growth between two packings needs two pressures; both are " +
                          std::to_string(first.pressure) + " Pa");
  return {.coordination_number = std::log(second.coordination_number / first.coordination_number) / step,
          .mechanical_coordination_number =
              (second.mechanical_coordination_number - first.mechanical_coordination_number) / step,
          .void_ratio = (second.void_ratio - first.void_ratio) / step};
}

StressExponents relaxed_exponents(const State& state, double mechanical_coordination_number,
                                  const Growth& growth, Modulus which) {
  require_finite(growth);
  const Relaxation factors =
      relaxation(mechanical_coordination_number, state.tangential_ratio, kernel::local_exponent(state));
  effective::require_valid(state);
  require_positive("stress_v", state.stress_v, "Pa");
  if (!(factors.shear.value > 0))
    throw InvalidArgument("mechanical_coordination_number", mechanical_coordination_number, "",
                          "above the isostatic point");
  kernel::require_contacts(state);
  return kernel::exponents_of(relaxed_constants(state, mechanical_coordination_number, growth), which);
}

PredictedPacking predict_packing(const ClosingGapLaw& law, const State& state, double pressure) {
  require_positive("pressure", pressure, "Pa");
  require_positive("radius", state.radius, "m");
  require_positive("void_ratio", state.void_ratio);
  sizes::require_valid(state.contacts);
  const double R = state.radius;
  const double diameter = 2 * R * state.contacts.branch; // of the mean contact
  const double load = 4 * std::numbers::pi * R * R * (1 + state.void_ratio) * pressure *
                      (state.contacts.grain_volume / state.contacts.branch); // f C_n
  const auto rattlers = [&](double z) { return law.rattlers * std::exp(-law.rattler_decay * (z - 4)); };
  const contact::NormalLaw closing = state.law.closing_law();
  // C_n enters as C_n^(-q(1-b)) with an exponent below 1/2 and a small prefactor: each iteration gains
  // digits.
  double z = law.initial;
  for (int round = 0; round < 60; ++round) {
    const double force = load / (z * (1 - rattlers(z)));
    const double b = kernel::up_to_half(closing.exponent_at_force(force));
    const double amplitude = law.amplitude * (1 - law.spread * b);
    z = law.initial + amplitude * std::pow(closing.overlap(force) / diameter, law.exponent);
  }
  const double x0 = rattlers(z);
  const double relative = 1 / z + law.rattler_decay * x0 / (1 - x0); // d ln C_n/dz
  const double free =
      law.exponent * kernel::overlap_exponent(closing, load / (z * (1 - x0))) * (z - law.initial);
  const double slope = free / (1 + free * relative);
  return {.coordination_number = z * (1 - x0),
          .mechanical_coordination_number = z,
          .growth = {.coordination_number = relative * slope,
                     .mechanical_coordination_number = slope,
                     .void_ratio = 0}};
}

const ClosingGapLaw& dense_closing_gaps() {
  static constexpr ClosingGapLaw law = law_of(kernel::dense_gaps);
  return law;
}
const ClosingGapLaw& loose_closing_gaps() {
  static constexpr ClosingGapLaw law = law_of(kernel::loose_gaps);
  return law;
}

} // namespace granum::effective
