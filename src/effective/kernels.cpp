// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <granum/core/error.hpp>

namespace granum::effective::kernel {

namespace {

/// The integrand is even: half of the symmetric rule is enough. Each rule is made when it is first needed,
/// because its nodes cost milliseconds where long double is emulated.
template <int order>
std::span<const QuadratureNode> positive_half() {
  static const std::vector<QuadratureNode> rule = gauss_legendre(order);
  return std::span(rule).last(order / 2);
}

} // namespace

/// Means of weights f^(-1/2) to f^(1/2) are accurate to 2e-14 (measured) up to each ratio.
std::span<const QuadratureNode> rule_for(double ratio) {
  const double larger = std::max(ratio, 1 / ratio);
  if (larger <= 3)
    return positive_half<24>();
  if (larger <= 25)
    return positive_half<48>();
  return larger <= 300 ? positive_half<96>() : positive_half<256>();
}

double contact_stiffness(const contact::NormalLaw& law, double area, double load) {
  constexpr double smallest = 1e-290; // below, a product may lose digits to underflow
  const double force = area * load;
  if (force >= smallest || load == 0) [[likely]]
    return law.stiffness_at_force(force);
  const std::optional<double> exponent = law.constant_exponent();
  if (!exponent)
    return law.stiffness_at_force(force);
  constexpr int lift = 600;
  return law.stiffness_at_force(area * std::ldexp(load, lift)) * std::exp2(-lift * *exponent);
}

double local_exponent(const State& state) {
  if (const std::optional<double> exponent = state.law.constant_exponent())
    return *exponent;
  const double force = geometry(state).force_area * (state.stress_v + 2 * state.stress_h);
  return state.law.exponent_at_force(state.coordination_number.value_or(0) > 0 ? force : 0);
}

double overlap_exponent(const contact::NormalLaw& law, double force) {
  if (const std::optional<double> b = law.constant_exponent())
    return 1 - *b;
  return force / (law.overlap(force) * law.stiffness_at_force(force));
}

double mean_overlap(const State& state) {
  const double force = state.coordination_number.value_or(0) > 0 ? mean_contact_force(state) : 0;
  if (force == 0)
    return 0;
  const double diameter = 2 * state.radius * state.contacts.branch;
  if (state.law.constant_exponent().value_or(0) > 0.5)
    return 2 * force / (state.law.stiffness_at_force(force) * diameter);
  return state.law.overlap(force) / diameter;
}

const contact::PowerLaw& power_law_of(const State& state, const char* asked) {
  if (const contact::PowerLaw* law = state.law.power_law())
    return *law;
  throw InvalidArgument(std::string(asked) +
                        " is available for contact laws of the power family only, not for " +
                        state.law.text());
}

} // namespace granum::effective::kernel
