// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives by differences of 50-digit values: five points at steps of 1e-6, whose error is 1e-24.
#include <granum/effective/exponents.hpp>
#include <granum/effective/uniform_field.hpp>

#include "packing.hpp"

namespace accuracy {

namespace {

using granum::effective::Hypothesis;
using granum::effective::Modulus;
using granum::effective::StressExponents;

constexpr Modulus moduli[] = {Modulus::K, Modulus::G_hh, Modulus::G_vh, Modulus::E_v, Modulus::E_h};

/// Logarithmic derivative of each of `moduli` by a member of a packing.
struct Slopes {
  Real of[5];
};
Slopes slopes(const Packing& packing, Hypothesis hypothesis, Real Packing::*member) {
  const Real step = Real(1) / 1000000;
  Slopes sum{};
  for (const int k : {-2, -1, 1, 2}) {
    Packing moved = packing;
    moved.*member *= 1 + k * step;
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
  }
}

} // namespace accuracy
