// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/sensitivity/gradients.hpp>

#include <cmath>

#include <boost/math/special_functions/digamma.hpp>

#include <granum/core/check.hpp>

#include "differentiated.hpp"

namespace granum::effective {

namespace kernel {

namespace {

/// psi(z + 1/2) - psi(z); beyond 25 by its asymptotic series, where the difference would lose digits.
double digamma_step(double z) {
  if (z < 25)
    return boost::math::digamma(z + 0.5) - boost::math::digamma(z);
  const double w = 1 / (z * z);
  return 1 / (2 * z) + w * (1.0 / 8 - w * (1.0 / 64 - w * (1.0 / 128 - w * 17.0 / 2048)));
}

/// d ln c/d alpha of c = 2 G/(1-nu) alpha/(alpha+1) (g/A)^(1/alpha), g = Gamma((alpha+1)/2)/(2 sqrt(pi)
/// Gamma(alpha/2+1)).
double log_coefficient_by_shape(const contact::PowerLaw& law) {
  const auto& grain = law.grain();
  const double alpha = law.alpha();
  const double radius = law.coefficient() * law.force_exponent() * (1 - grain.poisson_ratio) /
                        (2 * grain.shear_modulus); // (g/A)^(1/alpha)
  return (1 / (alpha + 1) - std::log(radius) - digamma_step((alpha + 1) / 2) / 2) / alpha;
}

} // namespace

double log_stiffness_by_shape(const contact::PowerLaw& law, double log_force) {
  const double alpha = law.alpha();
  if (std::isinf(alpha))
    return 0;
  // ln k_n = ln(1 + 1/alpha) + (1-b) ln c + b ln f
  const double b = law.stiffness_exponent();
  return -b / alpha + b * b * (std::log(law.coefficient()) - log_force) +
         (1 - b) * log_coefficient_by_shape(law);
}

// The integrand depends on four numbers alone. Nodes carry derivatives by these four; the chain rule
// follows after the integral.
AxialMoments<Dual<all_seeds>> moments_of(const Dual<all_seeds>& a, const Dual<all_seeds>& root,
                                         const Dual<all_seeds>& exponent) {
  using Node = Dual<4>;
  const Dual<all_seeds> inverse = 1 / root;
  const double c2 = root.value();
  const Node node_exponent(exponent.value(), 4, 3);
  const auto to_exponent = [&](const Node& f) { return power(f, node_exponent); };
  const AxialMoments<Node> m = direction_moments(
      Node(a.value(), 4, 0), Node(c2, 4, 1), Node(inverse.value(), 4, 2), c2, to_exponent, rule_for(c2 * c2));
  const auto outer = [&](const Node& x) -> Dual<all_seeds> {
    const auto& d = x.derivatives();
    return {x.value(), d[0] * a.derivatives() + d[1] * root.derivatives() + d[2] * inverse.derivatives() +
                           d[3] * exponent.derivatives()};
  };
  return {.s4 = outer(m.s4), .s2c2 = outer(m.s2c2), .c4 = outer(m.c4)};
}

Constants<Dual<all_seeds>> all_derivatives(const State& state, const Model& model) {
  (void)power_law_of(state, "the derivative by every input");
  return differentiated<all_seeds>(state, model);
}

Gradient by_inputs(const State& s, double value, const Dual<all_seeds>::DerType& by) {
  Gradient g{.value = value};
  g[Input::mean_stress] = 3 * (by[log_stress_v] + by[log_stress_h]) / (s.stress_v + 2 * s.stress_h);
  g[Input::stress_v] = by[log_stress_v] / s.stress_v;
  g[Input::stress_h] = by[log_stress_h] / s.stress_h;
  g[Input::coordination_number] = by[log_coordination] / s.coordination_number;
  g[Input::void_ratio] = by[voids];
  g[Input::fabric_anisotropy] = by[anisotropy];
  g[Input::alpha] = by[shape];
  g[Input::tangential_ratio] = by[ratio];
  g[Input::radius] = by[log_radius] / s.radius;
  // The grain's elasticity enters by k_n ~ c^(1-b), c ~ G/(1-nu), alone.
  const auto& grain = s.law.grain();
  const double by_log_coefficient =
      (1 - power_law_of(s, "the derivative by every input").stiffness_exponent()) * g.value;
  g[Input::grain_shear_modulus] = by_log_coefficient / grain.shear_modulus;
  g[Input::grain_poisson_ratio] = by_log_coefficient / (1 - grain.poisson_ratio);
  const double other = 2 - grain.poisson_ratio; // r = 2(1-nu)/(2-nu), dr/dnu = -2/(2-nu)^2
  g[Input::grain_poisson_ratio_mindlin] =
      g[Input::grain_poisson_ratio] - 2 / (other * other) * g[Input::tangential_ratio];
  return g;
}

} // namespace kernel

Gradient operator*(const Gradient& x, const Gradient& y) {
  Gradient product{.value = x.value * y.value};
  for (std::size_t i = 0; i < input_count; ++i)
    product.by[i] = x.by[i] * y.value + x.value * y.by[i];
  return product;
}

Gradient gradient(const State& s, const Model& model, Modulus which) {
  kernel::require_differentiable(s, model.hypothesis, which);
  const auto constants = kernel::all_derivatives(s, model);
  const kernel::Dual<kernel::all_seeds> X = kernel::modulus(constants, which);
  return kernel::by_inputs(s, kernel::checked_modulus(constants, which), X.derivatives());
}

} // namespace granum::effective
