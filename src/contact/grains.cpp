// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/grains.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::contact {

namespace {

constexpr double GPa = 1e9;

/// nu of a K and a G.
constexpr double poisson(double K, double G) { return (3 * K - 2 * G) / (2 * (3 * K + G)); }

constexpr std::array<Mineral, 6> table{{
    {"quartz", "quartz", "Mavko2009", {44 * GPa, poisson(37, 44)}, 2650, 0.03},
    {"feldspar", "feldspar, a mean of many", "Mavko2009", {15 * GPa, poisson(37.5, 15)}, 2620, 0.30},
    {"calcite", "calcite", "Mavko2009", {32 * GPa, poisson(77, 32)}, 2710, 0.05},
    {"dolomite", "dolomite", "Mavko2009", {45 * GPa, poisson(95, 45)}, 2870, 0.05},
    {"glass", "soda-lime glass", "Makse2004", {29 * GPa, 0.2}, 2480, 0.08},
    {"steel", "carbon steel", "BudynasNisbett2011", {79.3 * GPa, 0.292}, 7820, 0.03},
}};

} // namespace

std::span<const Mineral> minerals() { return table; }

const Mineral& mineral(std::string_view key) {
  std::vector<std::string> known;
  for (const Mineral& m : table) {
    if (key == m.key)
      return m;
    known.emplace_back(m.key);
  }
  throw InvalidArgument(unknown_word("grain", key, known));
}

double bulk_modulus(const GrainMaterial& grain) {
  require_positive("grain_shear_modulus", grain.shear_modulus, "Pa");
  const double nu = require_poisson_ratio("grain_poisson_ratio", grain.poisson_ratio);
  return nu < 0.5 ? 2 * grain.shear_modulus * (1 + nu) / (3 * (1 - 2 * nu))
                  : std::numeric_limits<double>::max();
}

NormalLaw of_sizes(const NormalLaw& law, double i, double j) {
  require_positive("size of a grain", i);
  require_positive("size of a grain", j);
  return law.of_pair_radius(pair_radius(i, j));
}

GrainMaterial pair_material(const GrainMaterial& i, const GrainMaterial& j) {
  for (const GrainMaterial& grain : {i, j}) {
    require_positive("grain_shear_modulus", grain.shear_modulus, "Pa");
    require_poisson_ratio("grain_poisson_ratio", grain.poisson_ratio);
  }
  if (i.shear_modulus == j.shear_modulus && i.poisson_ratio == j.poisson_ratio)
    return i;
  // Both conditions are linear in the compliance s = 1/G and in nu s: s - nu s and 2 s - nu s are the means
  // of the two grains'.
  const double share = j.shear_modulus / (i.shear_modulus + j.shear_modulus); // of 1/G_i in the sum of both
  return {.shear_modulus = harmonic_mean(i.shear_modulus, j.shear_modulus),
          .poisson_ratio = share * i.poisson_ratio + (1 - share) * j.poisson_ratio};
}

Friction Friction::from_coefficient(double coefficient) {
  return Friction(require_non_negative("friction_coefficient", coefficient));
}

Friction Friction::from_angle(double angle) {
  if (!(angle >= 0 && angle < std::numbers::pi / 2))
    throw InvalidArgument("friction_angle", angle, "rad", "[0, pi/2)");
  return Friction(std::tan(angle));
}

double Friction::angle() const { return std::atan(coefficient_); }

} // namespace granum::contact
