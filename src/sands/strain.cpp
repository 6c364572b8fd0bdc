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

constexpr std::array<StrainLaw, 6> strain_table{{
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
}};

/// Standard deviation of ln(G/G0) between the laws.
double spread(const StrainedSand& s) {
  double sum = 0, squares = 0;
  for (const StrainLaw& law : strain_table) {
    const double y = std::log(law.ratio(s));
    sum += y;
    squares += y * y;
  }
  const auto n = static_cast<double>(strain_table.size());
  return std::sqrt(std::max(0.0, (squares - sum * sum / n) / (n - 1)));
}

} // namespace

std::span<const StrainLaw> strain_laws() { return strain_table; }

double damping_ratio(double r) { return std::max(0.0, 0.333 * (0.586 * r * r - 1.547 * r + 1)); }

StrainAnswer strained(const StrainedSand& s) {
  require_open("strain", s.strain, 0, 0.05 * (1 + 1e-12));
  require_positive("mean_stress", s.mean_stress, "Pa");
  (void)extrapolated_shear_modulus(s.sand, s.void_ratio, s.mean_stress); // refuses impossible values
  StrainAnswer out{.ratio = s.sand.uniformity ? wang_stokoe_ratio_e_C_u(s) : wang_stokoe_ratio_e(s),
                   .validity = {}};
  const double r = out.ratio, usual = std::log(1.13);
  out.log_deviation = std::min(std::max(usual, spread(s)), -std::log(r));
  out.damping = damping_ratio(r);
  if (s.strain > 5e-3)
    out.validity.add("beyond a shear strain of 0.5 % the laws of G(strain) are not valid: strength governs");
  else if (s.strain > 2e-4)
    out.validity.add(
        "above a shear strain of about 0.02 % cycles compact drained sand, or raise its pore pressure: "
        "the result depends on their number");
  return out;
}

} // namespace granum::sands
