// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/sand_bounds.hpp>

#include <granum/core/error.hpp>

#include "sphere_pack.hpp"

namespace granum::effective {

namespace {

/// Volume shares of the pack and the mineral. Each is a quotient: 1 minus the other would lose digits.
struct Shares {
  double pack;
  double mineral;
};

/// 1/(s_a/(a+c) + s_b/(b+c)) - c, written without the difference.
double mixed(double a, double b, const Shares& s, double c) {
  if (s.pack == 0)
    return b;
  if (s.mineral == 0)
    return a;
  const double numerator = a * b + c * (s.pack * a + s.mineral * b);
  return numerator == 0 ? 0 : numerator / (c + s.pack * b + s.mineral * a);
}

/// G/6 (9 K + 8 G)/(K + 2 G).
double shear_constant(const IsotropicModuli& m) {
  if (m.shear_modulus == 0)
    return 0;
  return m.shear_modulus / 6 *
         ((9 * m.bulk_modulus + 8 * m.shear_modulus) / (m.bulk_modulus + 2 * m.shear_modulus));
}

/// The pack in the mineral, `around` being the phase that surrounds the other.
IsotropicModuli mixture(const IsotropicModuli& pack, const IsotropicModuli& mineral, const Shares& s,
                        const IsotropicModuli& around) {
  return {.bulk_modulus = mixed(pack.bulk_modulus, mineral.bulk_modulus, s, 4.0 / 3 * around.shear_modulus),
          .shear_modulus = mixed(pack.shear_modulus, mineral.shear_modulus, s, shear_constant(around))};
}

IsotropicModuli mineral_of(const contact::GrainMaterial& grain) {
  const double nu = grain.poisson_ratio;
  if (nu == 0.5)
    throw InvalidArgument("grain_poisson_ratio", nu, "", "(-1, 0.5): the mineral's bulk modulus is needed");
  return {.bulk_modulus = 2 * grain.shear_modulus * (1 + nu) / (3 * (1 - 2 * nu)),
          .shear_modulus = grain.shear_modulus};
}

Shares shares(double porosity, double critical) {
  require_non_negative("porosity", porosity);
  if (porosity > critical)
    throw InvalidArgument("porosity", porosity, "",
                          "[0, critical porosity]; a more porous packing is a suspension, or hertz_mindlin "
                          "with that porosity");
  return {.pack = porosity / critical, .mineral = (critical - porosity) / critical};
}

struct Ends {
  IsotropicModuli pack;
  IsotropicModuli mineral;
  Shares shares;
};

Ends ends(const Sand& sand) {
  const IsotropicModuli pack = hertz_mindlin(sand.end_member, sand.no_slip_share);
  return {pack, mineral_of(sand.end_member.grain), shares(sand.porosity, sand.end_member.porosity)};
}

} // namespace

IsotropicModuli soft_sand(const Sand& sand) {
  const auto [pack, mineral, s] = ends(sand);
  return mixture(pack, mineral, s, pack);
}

IsotropicModuli stiff_sand(const Sand& sand) {
  const auto [pack, mineral, s] = ends(sand);
  return mixture(pack, mineral, s, mineral);
}

IsotropicModuli sand_below(const IsotropicModuli& point, double point_porosity,
                           const contact::GrainMaterial& grain, double porosity) {
  require_grain(grain);
  require_positive("bulk_modulus", point.bulk_modulus, "Pa");
  require_positive("shear_modulus", point.shear_modulus, "Pa");
  require_open("point_porosity", point_porosity, 0, 1);
  return mixture(point, mineral_of(grain), shares(porosity, point_porosity), point);
}

} // namespace granum::effective
