// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives by differences of 50-digit values: five points at steps of 1e-6, whose error is 1e-24.
#include <granum/effective/exponents.hpp>
#include <granum/effective/sensitivity/gradients.hpp>
#include <granum/effective/uniform_field.hpp>

#include "packing.hpp"

namespace accuracy {

namespace {

using granum::effective::Gradient;
using granum::effective::Hypothesis;
using granum::effective::Input;
using granum::effective::Modulus;
using granum::effective::StressExponents;

constexpr Modulus moduli[] = {Modulus::K, Modulus::G_hh, Modulus::G_vh, Modulus::E_v, Modulus::E_h};

/// Logarithmic derivative of each of `moduli` by a member of a packing; by the member itself if `plain`.
struct Slopes {
  Real of[5];
};
Slopes slopes(const Packing& packing, Hypothesis hypothesis, Real Packing::*member, bool plain = false) {
  const Real step = Real(1) / 1000000, unit = plain ? Real(1) : packing.*member;
  Slopes sum{};
  for (const int k : {-2, -1, 1, 2}) {
    Packing moved = packing;
    moved.*member += k * step * unit;
    const Five c = static_stiffness(moved, hypothesis);
    const Real weight = Real(k == 1 ? 8 : k == -1 ? -8 : k == 2 ? -1 : 1) / (12 * step);
    for (int m = 0; m < 5; ++m)
      sum.of[m] += weight * modulus(c, moduli[m]);
  }
  const Five c = static_stiffness(packing, hypothesis);
  for (int m = 0; m < 5; ++m)
    sum.of[m] /= modulus(c, moduli[m]);
  return sum;
}

StressExponents exponents(const PackingCase& drawn, Hypothesis hypothesis, Modulus which) {
  switch (hypothesis) {
  case Hypothesis::uniform_strain:
    return uniform_strain_exponents(drawn.state, which);
  case Hypothesis::free_spin:
    return free_spin_exponents(drawn.state, which);
  default:
    return uniform_stress_exponents(drawn.state, which);
  }
}

void check_exponents(Table& table, const PackingCase& drawn, Hypothesis hypothesis, const std::string& name) {
  const Slopes v = slopes(drawn.packing, hypothesis, &Packing::stress_v);
  const Slopes h = slopes(drawn.packing, hypothesis, &Packing::stress_h);
  const std::string domain = "K, G and E, of 1, forces up to 1e4 apart";
  for (int m = 0; m < 5; ++m) {
    const StressExponents found = exponents(drawn, hypothesis, moduli[m]);
    table.take_against(name + " m, n", domain, derivative, found.stress_v, v.of[m], 1, drawn.where);
    table.take_against(name + " m, n", domain, derivative, found.stress_h, h.of[m], 1, drawn.where);
    table.take_against(name + " s", domain, derivative, found.sum(), 1 / (1 + drawn.packing.alpha), 1,
                       drawn.where);
  }
}

/// A logarithmic derivative (by a: plain) against the largest of them, at least 1.
void check_gradient(Table& table, const PackingCase& drawn, Hypothesis hypothesis) {
  struct Pair {
    Input input;
    Real Packing::*member;
    double value;
  };
  const auto& s = drawn.state;
  const auto& p = drawn.packing;
  const Pair pairs[] = {{Input::coordination_number, &Packing::C, s.coordination_number},
                        {Input::void_ratio, &Packing::e, s.void_ratio},
                        {Input::fabric_anisotropy, &Packing::a, 1},
                        {Input::alpha, &Packing::alpha, static_cast<double>(p.alpha)},
                        {Input::grain_poisson_ratio, &Packing::nu, 1},
                        {Input::tangential_ratio, &Packing::r, 1}};
  const std::string domain = "6 inputs of K, G, E, of the largest";
  Gradient gradients[5];
  for (int m = 0; m < 5; ++m)
    gradients[m] = gradient(s, {.hypothesis = hypothesis}, moduli[m]);
  Slopes all[6];
  Real largest[5] = {1, 1, 1, 1, 1};
  for (int k = 0; k < 6; ++k) {
    all[k] = slopes(p, hypothesis, pairs[k].member, pairs[k].value == 1);
    for (int m = 0; m < 5; ++m)
      largest[m] = std::max(largest[m], Real(abs(all[k].of[m])));
  }
  for (int k = 0; k < 6; ++k)
    for (int m = 0; m < 5; ++m)
      table.take_against("gradient", domain, derivative,
                         gradients[m][pairs[k].input] * pairs[k].value / gradients[m].value, all[k].of[m],
                         largest[m], drawn.where);
}

} // namespace

void check_static_field(Table& table, std::size_t samples) {
  Draw draw(7);
  for (std::size_t k = 0; k < samples; ++k) {
    const PackingCase drawn = draw_packing(draw);
    compare(table, "free_spin(state)", "forces 1 to 1e4 apart, a in [-1, 1]", quadrature,
            free_spin(drawn.state).stiffness, static_stiffness(drawn.packing, Hypothesis::free_spin),
            drawn.where);
  }
}

void check_derivatives(Table& table, std::size_t samples) {
  Draw draw(8);
  for (std::size_t k = 0; k < samples; ++k) {
    PackingCase drawn = draw_packing(draw);
    if (drawn.packing.r < 0.01) { // E and G of uniform stress vanish there
      drawn.state.tangential_ratio = 0.5;
      drawn.packing.r = 0.5;
    }
    check_exponents(table, drawn, Hypothesis::uniform_strain, "uniform_strain_exponents");
    check_exponents(table, drawn, Hypothesis::free_spin, "free_spin_exponents");
    check_exponents(table, drawn, Hypothesis::uniform_stress, "uniform_stress_exponents");
    check_gradient(table, drawn, static_cast<Hypothesis>(k % 3));
  }
}

} // namespace accuracy
