// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/strain.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <granum/core/error.hpp>

#include "constants.hpp"

namespace granum::sands {

namespace {

double in_per_cent(const StrainedSand& s) { return 100 * s.strain; }
double in_atmospheres(const StrainedSand& s) { return s.mean_stress / standard_atmosphere; }
double uniformity(const StrainedSand& s) { return s.sand.uniformity.value_or(uniform_sand); }

/// 1/(1 + (strain/at_half)^a)^b, strains in per cent.
double hyperbola(double strain, double at_half, double a, double b = 1) {
  return std::pow(1 + std::pow(strain / at_half, a), -b);
}

double wang_stokoe_plain(const StrainedSand& s) {
  return hyperbola(in_per_cent(s), 0.068 * std::pow(in_atmospheres(s), 0.4), 0.729, 0.985);
}

double wang_stokoe_ratio_e(const StrainedSand& s) {
  const double at_half = 0.13 * std::pow(s.void_ratio, 0.545) - 0.043;
  return hyperbola(in_per_cent(s), std::max(at_half, 1e-3) * std::pow(in_atmospheres(s), 0.45), 0.804, 0.882);
}

double wang_stokoe_ratio_e_C_u(const StrainedSand& s) {
  const double at_half = 0.05 * std::pow(s.void_ratio, 0.1 * uniformity(s)) + 0.011;
  return hyperbola(in_per_cent(s), at_half * std::pow(in_atmospheres(s), 0.45), 0.834, 0.839);
}

double darendeli(const StrainedSand& s) {
  return hyperbola(in_per_cent(s), 0.0352 * std::pow(in_atmospheres(s), 0.3483), 0.919);
}

double menq_ratio(const StrainedSand& s) {
  const double C_u = uniformity(s), p = in_atmospheres(s);
  const double a = std::max(0.86 + 0.1 * std::log10(p), 0.1);
  return hyperbola(in_per_cent(s), 0.12 * std::pow(C_u, -0.6) * std::pow(p, 0.5 * std::pow(C_u, -0.15)), a);
}

double ishibashi_zhang(const StrainedSand& s) {
  const auto part = [&](double strain, double power) {
    return std::tanh(std::log(std::pow(strain / s.strain, power)));
  };
  const double K = 0.5 * (1 + part(0.000102, 0.492)), m = 0.272 * (1 - part(0.000556, 0.4));
  return std::min(1.0, K * std::pow(s.mean_stress / 1e3, m));
}

double oztoprak_bolton_ratio(const StrainedSand& s) {
  const auto [least, largest, deviation] = usual_limits(s.sand.uniformity);
  const double D_r = std::clamp(
      relative_density_of(s.sand, s.void_ratio).value_or((largest - s.void_ratio) / (largest - least)), 0.0,
      1.0);
  const double at_half =
      0.01 * std::pow(uniformity(s), -0.3) * s.mean_stress / reference_stress + 0.08 * s.void_ratio * D_r;
  const double elastic = 0.0002 + 0.012 * at_half;
  return hyperbola(std::max(0.0, in_per_cent(s) - elastic), at_half, std::pow(uniformity(s), -0.075));
}

constexpr std::array<StrainLaw, 7> strain_table{{
    {"wang-stokoe-e-C_u", "WangStokoe2022",
     "1/(1+(g/g_r)^0.834)^0.839, g_r = (0.05 e^(0.1 C_u)+0.011) % (p/atm)^0.45", wang_stokoe_ratio_e_C_u},
    {"wang-stokoe-e", "WangStokoe2022",
     "1/(1+(g/g_r)^0.804)^0.882, g_r = (0.13 e^0.545-0.043) % (p/atm)^0.45", wang_stokoe_ratio_e},
    {"wang-stokoe", "WangStokoe2022", "1/(1+(g/g_r)^0.729)^0.985, g_r = 0.068 % (p/atm)^0.4",
     wang_stokoe_plain},
    {"darendeli", "Darendeli2001", "1/(1+(g/g_r)^0.919), g_r = 0.0352 % (p/atm)^0.3483", darendeli},
    {"menq", "Menq2003",
     "1/(1+(g/g_r)^a), a = 0.86+0.1 log10(p/atm), g_r = 0.12 % C_u^-0.6 (p/atm)^(0.5 C_u^-0.15)", menq_ratio},
    {"ishibashi-zhang", "IshibashiZhang1993",
     "K p^m, p in kPa, K = 0.5(1+tanh ln((0.000102/g)^0.492)), m = 0.272(1-tanh ln((0.000556/g)^0.4))",
     ishibashi_zhang},
    {"oztoprak-bolton", "OztoprakBolton2013",
     "1/(1+((g-g_e)/g_r)^a), a = C_u^-0.075, g_r = 0.01 % C_u^-0.3 p/p_a + 0.08 % e D_r, g_e = 0.0002 % + "
     "0.012 g_r",
     oztoprak_bolton_ratio},
}};

/// In per cent.
double reference_strain(const StrainedSand& s) {
  return 0.062 * std::pow(uniformity(s), -0.3) * std::pow(s.mean_stress / reference_stress, 0.37);
}

} // namespace

std::span<const StrainLaw> strain_laws() { return strain_table; }

StrainAnswer strained(const StrainedSand& s, const StrainMoves& moves) {
  require_open("strain", s.strain, 0, 0.05 * (1 + 1e-12));
  require_positive("mean_stress", s.mean_stress, "Pa");
  (void)extrapolated_shear_modulus(s.sand, s.void_ratio, s.mean_stress); // refuses impossible values
  const double moved = reference_strain(s) * std::pow(1.6, moves.reference_strain);
  const double ratio =
      std::clamp(hyperbola(in_per_cent(s), moved, 0.81) + 0.01 * moves.reference_strain, 0.0, 1.0);
  const double least = 0.0080 * std::pow(s.mean_stress / reference_stress, -0.15);
  StrainAnswer out{.ratio = ratio,
                   .damping = least * std::pow(1.6, moves.least_damping) +
                              0.195 * std::pow(1.3, moves.damping_growth) * std::pow(1 - ratio, 1.22),
                   .validity = {}};
  if (s.strain > 0.01 * (1 + 1e-12))
    out.validity.add("beyond a shear strain of 1 % no curve was measured: strength governs");
  else if (s.strain > 2e-4)
    out.validity.add(
        "above a shear strain of about 0.02 % cycles compact drained sand, or raise its pore pressure: "
        "the result depends on their number");
  return out;
}

} // namespace granum::sands
