// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sand_bounds.hpp>

#include <cmath>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/rock_physics/hertz_mindlin.hpp>

#include "sphere_checks.hpp"

namespace granum::rock_physics {

namespace {

struct Moduli {
  double bulk;
  double shear;
};

/// K = 2 G (1+nu)/(3 (1-2 nu)), infinite for nu = 0.5.
Moduli mineral(const SpherePacking& s) {
  const double nu = s.poisson_ratio, G = s.shear_modulus;
  return {2 * G * (1 + nu) / (3 * (1 - 2 * nu)), G};
}

/// Shares of the volume. Each is a quotient: 1 minus the other would lose digits.
struct Shares {
  double packing;
  double mineral;
};

/// [f/(x + a) + g/(y + a)]^-1 - a without its differences, shares f and g; y may be infinite.
double shifted_harmonic_mean(double x, double y, const Shares& share, double a) {
  const auto [f, g] = share;
  if (std::isinf(y))
    return (x + a * g) / f;
  return (x * y + a * (f * x + g * y)) / (f * y + g * x + a);
}

/// G (9 K + 8 G)/(6 (K + 2 G)), the shear shift of a surrounding solid; 0 for none.
double shear_shift(const Moduli& m) {
  if (std::isinf(m.bulk))
    return 1.5 * m.shear;
  return m.shear > 0 ? m.shear * (9 * m.bulk + 8 * m.shear) / (6 * (m.bulk + 2 * m.shear)) : 0;
}

Moduli mixed(const Moduli& packing, const Moduli& solid, const Shares& f, const Moduli& surrounding) {
  return {shifted_harmonic_mean(packing.bulk, solid.bulk, f, 4.0 / 3 * surrounding.shear),
          shifted_harmonic_mean(packing.shear, solid.shear, f, shear_shift(surrounding))};
}

void require_porosity(double porosity, double critical) {
  require_open("critical_porosity", critical, 0, 1);
  if (porosity >= 0 && porosity <= critical)
    return;
  throw InvalidArgument("porosity", porosity, "",
                        detail::closed_range(0, critical, porosity) +
                            ", the critical porosity of the packing: looser grains do not touch; for a "
                            "looser packing give that "
                            "porosity to the packing itself");
}

enum class Surrounding { packing, mineral };

IsotropicEstimate sand(const SpherePacking& packing, double porosity, Surrounding which) {
  require_porosity(porosity, packing.porosity);
  IsotropicEstimate end = hertz_mindlin(packing);
  if (porosity == packing.porosity)
    return end;
  const Moduli loose{end.bulk_modulus, end.shear_modulus}, solid = mineral(packing);
  if (porosity == 0)
    return {solid.bulk, solid.shear, std::move(end.validity)};
  const Moduli& surrounding = which == Surrounding::packing ? loose : solid;
  const double critical = packing.porosity;
  const Moduli sand =
      mixed(loose, solid, {porosity / critical, (critical - porosity) / critical}, surrounding);
  return {sand.bulk, sand.shear, std::move(end.validity)};
}

} // namespace

IsotropicEstimate soft_sand(const SpherePacking& packing, double porosity) {
  return sand(packing, porosity, Surrounding::packing);
}

IsotropicEstimate stiff_sand(const SpherePacking& packing, double porosity) {
  return sand(packing, porosity, Surrounding::mineral);
}

} // namespace granum::rock_physics
