// SPDX-License-Identifier: GPL-3.0-or-later
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
#include "relaxation_kernel.hpp"
#include "stress_derivatives.hpp"

namespace granum::effective {

namespace kernel {

namespace {

/// k_n of the force area x load, by the chain rule of ln k_n.
Dual stiffness_under(const contact::NormalLaw& law, double area, const Dual& load) {
  const double value = contact_stiffness(law, area, load.value());
  return {value, load.derivatives() / load.value() * (value * law.exponent_at_force(area * load.value()))};
}

/// Means of f^exponent over the directions.
AxialMoments<Dual> moments_of(double a, const Dual& root, double exponent) {
  if (exponent == 0)
    return fabric_moments(Dual(a));
  const double c2 = root.value();
  const auto to_exponent = [&](const Dual& f) { return power(f, exponent); };
  return direction_moments(Dual(a), root, Dual(1 / root), c2, to_exponent, rule_for(c2 * c2));
}

/// Means of k_n^(+1 or -1) over those at the reference force, for a law whose b is not the same at every
/// force. Not inlined next to the closed one, which would become 6 % slower.
[[gnu::noinline]] AxialMoments<Dual> moments_of(double a, const Dual& root,
                                                const StiffnessRatio<Dual>& weight) {
  const double c2 = root.value();
  return direction_moments(Dual(a), root, Dual(1 / root), c2, weight, rule_for(c2 * c2));
}

/// The same at any size: Young's moduli are made of products that must stay within the range of a double.
Dual scaled_modulus(const Constants<Dual>& c, Modulus which) {
  const double size = std::abs(c.C11.value());
  const bool young = which == Modulus::E_v || which == Modulus::E_h;
  if (!young || (size > 1e-90 && size < 1e90) || !(size > 0) || !std::isfinite(size))
    return plain_modulus(c, which);
  const int half = std::ilogb(size) / 2; // the power of two itself may be beyond the range
  const double down = std::scalbn(1.0, -half), up = std::scalbn(1.0, half);
  const auto moved = [down](const Dual& x) { return Dual(Dual(x * down) * down); };
  const Dual x = plain_modulus(Constants<Dual>{.C11 = moved(c.C11),
                                               .C33 = moved(c.C33),
                                               .C12 = moved(c.C12),
                                               .C13 = moved(c.C13),
                                               .C44 = moved(c.C44)},
                               which);
  return Dual(Dual(x * up) * up);
}

} // namespace

void require_differentiable(const State& state, Hypothesis hypothesis, Modulus which) {
  (void)require_valid(state);
  require_positive("stress_v", state.stress_v, "Pa");
  require_contacts(state);
  if (hypothesis == Hypothesis::uniform_stress && (which == Modulus::E_v || which == Modulus::E_h))
    require_positive("tangential_ratio", state.tangential_ratio);
}

Constants<Dual> stress_derivatives(const State& s, const Model& model) {
  const Dual stress_v(s.stress_v, s.stress_v * Eigen::Vector2d::UnitX());
  const Dual stress_h(s.stress_h, s.stress_h * Eigen::Vector2d::UnitY());
  const Geometry<double> packing = geometry(s);
  const Dual a(s.fabric_anisotropy), r(s.tangential_ratio);
  const AxialMoments<Dual> fabric = fabric_moments(a);
  const bool by_stress = model.hypothesis == Hypothesis::uniform_stress;
  AxialMoments<Dual> moments = fabric;
  Dual load = stress_v + 2 * stress_h;
  if (model.forces == ContactForces::by_direction) {
    // By a power of two near 1, for the square in the derivative of a ratio leaves the range of a double.
    const double unit = std::scalbn(1.0, std::ilogb(s.stress_v));
    const NormalLoads<Dual> loads = static_loads(a, Dual(stress_v / unit), Dual(stress_h / unit));
    const Dual root = sqrt(Dual(loads.horizontal / loads.vertical));
    load = Dual(root * loads.vertical) * unit;
    if (const std::optional<double> b = s.law.constant_exponent())
      moments = moments_of(s.fabric_anisotropy, root, (by_stress ? -1 : 1) * *b);
    else
      moments = moments_of(s.fabric_anisotropy, root,
                           StiffnessRatio<Dual>{.law = s.law,
                                                .reference = packing.force_area * load,
                                                .stiffness = stiffness_under(s.law, packing.force_area, load),
                                                .inverse = by_stress});
  }
  const Dual stiffness = stiffness_under(s.law, packing.force_area, load);
  if (by_stress)
    return uniform_stress(Dual(packing.static_prefactor * stiffness), r, fabric, moments);
  return uniform_strain(Dual(packing.prefactor * stiffness), r, moments,
                        model.hypothesis == Hypothesis::free_spin ? Spin::free : Spin::none);
}

void require_modulus(double value, double C11, Modulus which) {
  if (vanishes(value, C11, which))
    throw InvalidArgument("this modulus vanishes at these values of k_t/k_n and a: it has no exponents");
}

StressExponents exponents_of(const Constants<Dual>& c, Modulus which) {
  if (!std::isfinite(c.C11.value()) || !std::isfinite(c.C33.value()))
    throw InvalidArgument("the moduli exceed the range of a double");
  const double value = effective::modulus({.C11 = c.C11.value(),
                                           .C33 = c.C33.value(),
                                           .C12 = c.C12.value(),
                                           .C13 = c.C13.value(),
                                           .C44 = c.C44.value()},
                                          which);
  require_modulus(value, c.C11.value(), which);
  const auto by = scaled_modulus(c, which).derivatives();
  return {.stress_v = by[0] / value, .stress_h = by[1] / value};
}

} // namespace kernel

double modulus(const elastic::TransverselyIsotropic& stiffness, Modulus which) {
  switch (which) {
  case Modulus::K:
    return stiffness.bulk_modulus();
  case Modulus::G_hh:
    return stiffness.G_hh();
  case Modulus::G_vh:
    return stiffness.G_vh();
  case Modulus::E_v:
    return stiffness.E_v();
  case Modulus::E_h:
    return stiffness.E_h();
  case Modulus::C11:
    return stiffness.C11;
  case Modulus::C33:
    return stiffness.C33;
  case Modulus::C12:
    return stiffness.C12;
  case Modulus::C13:
    return stiffness.C13;
  }
  throw InvalidArgument("modulus is not one of the known ones");
}

std::optional<double> modulus_if_any(const elastic::TransverselyIsotropic& stiffness, Modulus which) {
  if (which == Modulus::E_v)
    return elastic::young_modulus(stiffness, elastic::Loading::vertical);
  if (which == Modulus::E_h)
    return elastic::young_modulus(stiffness, elastic::Loading::horizontal);
  return modulus(stiffness, which);
}

StressExponents uniform_strain_exponents(const State& state, Modulus which) {
  return uniform_field_exponents(state, {.hypothesis = Hypothesis::uniform_strain}, which);
}

StressExponents free_spin_exponents(const State& state, Modulus which) {
  return uniform_field_exponents(state, {.hypothesis = Hypothesis::free_spin}, which);
}

StressExponents uniform_stress_exponents(const State& state, Modulus which) {
  return uniform_field_exponents(state, {.hypothesis = Hypothesis::uniform_stress}, which);
}

namespace {

elastic::TransverselyIsotropic of_contacts(const UniformContacts& contacts, Hypothesis hypothesis) {
  switch (hypothesis) {
  case Hypothesis::uniform_strain:
    return uniform_strain_stiffness(contacts);
  case Hypothesis::free_spin:
    return free_spin_stiffness(contacts);
  case Hypothesis::uniform_stress:
    return uniform_stress_stiffness(contacts);
  }
  throw InvalidArgument("hypothesis is not one of the known ones");
}

Estimate by_direction(const State& state, Hypothesis hypothesis) {
  switch (hypothesis) {
  case Hypothesis::uniform_strain:
    return uniform_strain(state);
  case Hypothesis::free_spin:
    return free_spin(state);
  case Hypothesis::uniform_stress:
    return uniform_stress(state);
  }
  throw InvalidArgument("hypothesis is not one of the known ones");
}

/// All contacts stiffen alike, so every modulus that does not vanish has the same exponents.
StressExponents at_mean_force(const State& state, const Model& model, Modulus which) {
  kernel::require_differentiable(state, model.hypothesis, which);
  const elastic::TransverselyIsotropic stiffness = uniform_field(state, model).stiffness;
  kernel::require_modulus(modulus(stiffness, which), stiffness.C11, which);
  const double share_v = state.stress_v / (state.stress_v + 2 * state.stress_h);
  const double b = kernel::local_exponent(state);
  return {.stress_v = b * share_v, .stress_h = b * (1 - share_v)};
}

} // namespace

Estimate uniform_field(const State& state, const Model& model) {
  if (model.forces == ContactForces::by_direction)
    return by_direction(state, model.hypothesis);
  Estimate estimate{.stiffness = {}, .validity = kernel::checked(state).validity};
  if (*state.coordination_number > 0)
    estimate.stiffness = of_contacts(uniform_contacts(state), model.hypothesis);
  return estimate;
}

StressExponents uniform_field_exponents(const State& state, const Model& model, Modulus which) {
  if (model.forces == ContactForces::mean)
    return at_mean_force(state, model, which);
  kernel::require_differentiable(state, model.hypothesis, which);
  return kernel::exponents_of(kernel::stress_derivatives(state, model), which);
}

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
  const kernel::ByExponent<Dual> effect = kernel::by_exponent(b, kernel::going_on(stiffening_of(s.law)));
  const Dual own =
      kernel::shear_relaxation(kernel::coordination_of_equal(z_star, kernel::branch_variance(s.contacts)), r,
                               effect.own, kernel::constants<Dual>(kernel::shear_coefficients));
  Dual shear = own * kernel::left_of_shear(own, effect);
  const auto of_bulk = kernel::constants<Dual>(kernel::bulk_coefficients);
  Dual bulk = kernel::stiffened_bulk(z_star, r, effect, of_bulk) *
              kernel::size_bulk_share(z_star, effect, constant(kernel::size_loss),
                                      kernel::branch_variance(s.contacts), of_bulk);
  if (s.unevenness)
    add_unevenness(s, z_star, b, growth, shear, bulk);
  const fabric::SecondMoments F = fabric::second_moments(s.fabric_anisotropy);
  const Dual log_stress(std::log(s.stress_v / s.stress_h), Vector2d(1, -1));
  const Dual stretch = kernel::log_stretch(shear, kernel::up_to_half(b), constant(std::log(F.F33 / F.F11)),
                                           log_stress, kernel::constants<Dual>(kernel::stretch_coefficients));
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
  const contact::NormalLaw closing = kernel::closing_law(state.law);
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
