// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/exponents.hpp>

#include <cmath>
#include <optional>

#include <granum/core/error.hpp>

#include "kernels.hpp"
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

} // namespace granum::effective
