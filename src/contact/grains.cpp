// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/grains.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

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

std::vector<MineralShare> mineral_shares(std::string_view text) {
  if (text.find_first_of(":,") == std::string_view::npos)
    return {{.mineral = &mineral(text), .share = 1}};
  std::vector<MineralShare> parts;
  double sum = 0;
  for (std::string_view rest = text;;) {
    const std::string_view part = rest.substr(0, rest.find(','));
    const std::size_t colon = part.find(':');
    if (colon == std::string_view::npos)
      throw InvalidArgument("'" + std::string(part) +
                            "' lacks its share: several minerals are quartz:70%,calcite:30%");
    const Mineral* const found = &mineral(part.substr(0, colon));
    if (std::any_of(parts.begin(), parts.end(), [=](const MineralShare& p) { return p.mineral == found; }))
      throw InvalidArgument(std::string(found->key) + " is named twice");
    const std::string name = "share of " + std::string(found->key);
    parts.push_back({.mineral = found,
                     .share = require_positive(
                         name, parse_quantity(name, part.substr(colon + 1), Dimension::dimensionless))});
    sum += parts.back().share;
    if (part.size() == rest.size())
      break;
    rest.remove_prefix(part.size() + 1);
  }
  constexpr double rounding = 1e-6;
  if (!(std::abs(sum - 1) <= rounding))
    throw InvalidArgument("sum of the shares of the minerals", sum, "", "1");
  return parts;
}

std::string text_of(std::span<const MineralShare> minerals) {
  std::string text;
  for (const MineralShare& part : minerals)
    text += (text.empty() ? "" : ",") + std::string(part.mineral->key) +
            (minerals.size() > 1 ? ":" + short_text(100 * part.share) + "%" : "");
  return text;
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
  if (std::tie(j.shear_modulus, j.poisson_ratio) < std::tie(i.shear_modulus, i.poisson_ratio))
    return pair_material(j, i); // to the same bits in either order
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
