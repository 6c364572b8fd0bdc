// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/exponents.hpp>

#include <cmath>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>

#include "effective/sensitivity/differentiated.hpp"

namespace granum::effective {

namespace kernel {

// Derivatives by the two stresses only: two a node, carried through the whole integral.
AxialMoments<Dual<stress_seeds>> moments_of(const Dual<stress_seeds>& a, const Dual<stress_seeds>& root,
                                            const Dual<stress_seeds>& exponent) {
  if (exponent.value() == 0)
    return fabric_moments(a);
  const double c2 = root.value();
  const auto to_exponent = [&](const Dual<stress_seeds>& f) { return power(f, exponent.value()); };
  return direction_moments(a, root, Dual<stress_seeds>(1 / root), c2, to_exponent, rule_for(c2 * c2));
}

// Not inlined beside the closed one, which would take 1.06 of its time.
[[gnu::noinline]] AxialMoments<Dual<stress_seeds>>
moments_of(const Dual<stress_seeds>& a, const Dual<stress_seeds>& root,
           const StiffnessRatio<Dual<stress_seeds>>& weight) {
  const double c2 = root.value();
  return direction_moments(a, root, Dual<stress_seeds>(1 / root), c2, weight, rule_for(c2 * c2));
}

void require_differentiable(const State& state, Hypothesis hypothesis, Modulus which) {
  (void)require_valid(state);
  require_positive("stress_v", state.stress_v, "Pa");
  require_contacts(state);
  if (hypothesis == Hypothesis::uniform_stress && (which == Modulus::E_v || which == Modulus::E_h))
    require_positive("tangential_ratio", state.tangential_ratio);
}

Constants<Dual<stress_seeds>> stress_derivatives(const State& state, const Model& model) {
  return differentiated<stress_seeds>(state, model);
}

void require_modulus(double value, double C11, Modulus which) {
  if (vanishes(value, C11, which))
    throw InvalidArgument("this modulus vanishes at these values of k_t/k_n and a: it has no exponents");
}

StressExponents exponents_of(const Constants<Dual<stress_seeds>>& constants, Modulus which) {
  const double value = checked_modulus(constants, which);
  require_modulus(value, constants.C11.value(), which);
  const Dual<stress_seeds> X = modulus(constants, which);
  return {.stress_v = X.derivatives()[log_stress_v] / value,
          .stress_h = X.derivatives()[log_stress_h] / value};
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

} // namespace granum::effective
