// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/exponents.hpp>

#include <cmath>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/fabric/orientation.hpp>

#include "kernels.hpp"

namespace granum::effective {

namespace {

using elastic::TransverselyIsotropic;
using kernel::LogDual;

/// A stiffness and its derivatives by ln stress_v and ln stress_h.
struct Slopes {
  TransverselyIsotropic value;
  TransverselyIsotropic v;
  TransverselyIsotropic h;
};

TransverselyIsotropic part(const kernel::Constants<LogDual>& c, double LogDual::*member) {
  return {.C11 = c.C11.*member,
          .C33 = c.C33.*member,
          .C12 = c.C12.*member,
          .C13 = c.C13.*member,
          .C44 = c.C44.*member};
}

Slopes slopes(const kernel::Constants<LogDual>& c) {
  return {part(c, &LogDual::value), part(c, &LogDual::v), part(c, &LogDual::h)};
}

/// dX for a change dC. A Young's modulus is the least energy 2U = e C e over the free lateral strains, so
/// that its change is e dC e at the strains e of the stretched specimen; the other moduli are linear in C.
double change(const TransverselyIsotropic& C, const TransverselyIsotropic& dC, Modulus which) {
  if (which == Modulus::E_v) {
    const double e1 = -C.C13 / (C.C11 + C.C12);
    return dC.C33 + 4 * e1 * dC.C13 + 2 * e1 * e1 * (dC.C11 + dC.C12);
  }
  if (which == Modulus::E_h) {
    const double e2 = -(C.C12 - C.C13 * C.C13 / C.C33) / (C.C11 - C.C13 * C.C13 / C.C33);
    const double e3 = -C.C13 * (1 + e2) / C.C33;
    return dC.C11 * (1 + e2 * e2) + 2 * e2 * dC.C12 + e3 * e3 * dC.C33 + 2 * e3 * (1 + e2) * dC.C13;
  }
  return modulus(dC, which);
}

StressExponents logarithmic(const Slopes& s, Modulus which) {
  const double X = modulus(s.value, which);
  return {.stress_v = change(s.value, s.v, which) / X, .stress_h = change(s.value, s.h, which) / X};
}

void require_loaded(const State& state) {
  require_valid(state);
  require_positive("stress_v", state.stress_v, "Pa");
}

kernel::AxialMoments<LogDual> moments(const State& s, double sign) {
  const StaticForceField field = kernel::static_force_field(s, fabric::second_moments(s.fabric_anisotropy));
  return kernel::stiffness_moment_slopes(s.fabric_anisotropy, field, s.law.stiffness_exponent(), sign);
}

} // namespace

double modulus(const TransverselyIsotropic& stiffness, Modulus which) {
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
  }
  throw InvalidArgument("modulus is not one of the known ones");
}

StressExponents uniform_strain_exponents(const State& state, Modulus which) {
  require_loaded(state);
  return logarithmic(slopes(kernel::uniform_strain(1, state.tangential_ratio, moments(state, 1))), which);
}

StressExponents uniform_stress_exponents(const State& state, Modulus which) {
  require_loaded(state);
  const bool vanishes =
      which == Modulus::G_hh || which == Modulus::G_vh || which == Modulus::E_v || which == Modulus::E_h;
  if (vanishes)
    require_positive("tangential_ratio", state.tangential_ratio);
  const fabric::SecondMoments F = fabric::second_moments(state.fabric_anisotropy);
  return logarithmic(slopes(kernel::uniform_stress(1, state.tangential_ratio, F, moments(state, -1))), which);
}

} // namespace granum::effective
