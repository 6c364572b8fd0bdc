// SPDX-License-Identifier: GPL-3.0-or-later
// Notation of the sources: alpha disc radius by grain radius, Lambda cement by grain stiffness, S contact
// stiffness; n normal, t tangential.
#include <granum/rock_physics/cement.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/rock_physics/sphere_packs.hpp>

#include "sphere_checks.hpp"

namespace granum::rock_physics {

namespace {

/// 2 G (1-nu)/(1-2 nu), the modulus of a thin layer that cannot spread.
double layer_modulus(double shear, double nu) { return 2 * shear * (1 - nu) / (1 - 2 * nu); }

/// 2 G (1+nu)/(3 (1-2 nu)).
double bulk_modulus(double shear, double nu) { return 2 * shear * (1 + nu) / (3 * (1 - 2 * nu)); }

struct StiffnessRatios {
  double normal;
  double tangential;
};

/// Lambda_n and Lambda_t.
StiffnessRatios stiffness_ratios(const CementedPacking& p) {
  const double tangential = p.cement_shear_modulus / (std::numbers::pi * p.shear_modulus);
  return {layer_modulus(tangential, p.cement_poisson_ratio) * (1 - p.poisson_ratio), tangential};
}

double normal_stiffness(double alpha, double lambda) {
  const double A = -0.024153 * std::pow(lambda, -1.3646);
  const double B = 0.20405 * std::pow(lambda, -0.89008);
  const double C = 0.00024649 * std::pow(lambda, -1.9864);
  return (A * alpha + B) * alpha + C;
}

double tangential_stiffness(double alpha, double lambda, double nu) {
  const double A =
      -0.01 * ((2.26 * nu + 2.07) * nu + 2.3) * std::pow(lambda, (0.079 * nu + 0.1754) * nu - 1.342);
  const double B =
      ((0.0573 * nu + 0.0937) * nu + 0.202) * std::pow(lambda, (0.0274 * nu + 0.0529) * nu - 0.8765);
  const double C =
      1e-4 * ((9.654 * nu + 4.945) * nu + 3.1) * std::pow(lambda, (0.01867 * nu + 0.4011) * nu - 1.8186);
  return (A * alpha + B) * alpha + C;
}

void require_packing(const CementedPacking& p) {
  sphere::require_grain(p);
  require_positive("cement_shear_modulus", p.cement_shear_modulus, "Pa");
  require_open("cement_poisson_ratio", p.cement_poisson_ratio, -1, 0.5);
  require_closed("cement_saturation", p.cement_saturation, 0, 1);
}

void note_if_outside(const char* what, double value, double low, double high, Validity& validity) {
  if (!(value >= low && value <= high))
    validity.add(detail::formatted("%s is %.3g: the contact-cement regression is valid in [%g, %g]", what,
                                   value, low, high));
}

Validity range_notes(const CementedPacking& p, double alpha, const StiffnessRatios& lambda) {
  Validity validity;
  sphere::note_coordination(p, validity);
  note_if_outside("radius of the cement by grain radius", alpha, 0.05, 1, validity);
  note_if_outside("normal stiffness of the cement by that of the grain", lambda.normal, 0.1, 1.5, validity);
  note_if_outside("shear stiffness of the cement by that of the grain", lambda.tangential, 0.1, 1.5,
                  validity);
  return validity;
}

/// No mixture is stiffer than the average of its parts.
void note_bound(const CementedPacking& p, IsotropicEstimate& estimate) {
  const double grain = 1 - p.porosity, cement = p.porosity * p.cement_saturation;
  const double K = grain * bulk_modulus(p.shear_modulus, p.poisson_ratio) +
                   cement * bulk_modulus(p.cement_shear_modulus, p.cement_poisson_ratio);
  const double G = grain * p.shear_modulus + cement * p.cement_shear_modulus;
  if (estimate.bulk_modulus > K || estimate.shear_modulus > G)
    estimate.validity.add("stiffer than the average of grain, cement and pore, which no mixture can be");
}

void require_regression(const char* name, double stiffness) {
  if (!(stiffness > 0))
    throw InvalidArgument(std::string(name) + " of the contact-cement regression is not positive: the cement "
                                              "is too soft against the grain; check cement_shear_modulus");
}

} // namespace

double cement_saturation(double critical_porosity, double porosity) {
  require_open("critical_porosity", critical_porosity, 0, 1);
  require_closed("porosity", porosity, 0, critical_porosity);
  return (critical_porosity - porosity) / critical_porosity;
}

double cement_radius_ratio(const CementedPacking& packing, CementScheme scheme) {
  require_packing(packing);
  const double filled = packing.porosity * packing.cement_saturation / (3 * (1 - packing.porosity));
  switch (scheme) {
  case CementScheme::at_contacts:
    require_positive("coordination_number", packing.coordination_number);
    return 2 * std::sqrt(std::sqrt(filled / packing.coordination_number));
  case CementScheme::surface_layer:
    return std::sqrt(2 * filled);
  }
  throw InvalidArgument("cement scheme is neither at_contacts nor surface_layer");
}

IsotropicEstimate contact_cement(const CementedPacking& packing, CementScheme scheme) {
  const double alpha = cement_radius_ratio(packing, scheme);
  const StiffnessRatios lambda = stiffness_ratios(packing);
  const double S_n = normal_stiffness(alpha, lambda.normal);
  const double S_t = tangential_stiffness(alpha, lambda.tangential, packing.poisson_ratio);
  require_regression("normal stiffness", S_n);
  require_regression("shear stiffness", S_t);

  IsotropicEstimate estimate{
      .bulk_modulus = 0, .shear_modulus = 0, .validity = range_notes(packing, alpha, lambda)};
  const double contacts = packing.coordination_number * (1 - packing.porosity);
  estimate.bulk_modulus =
      contacts / 6 * layer_modulus(packing.cement_shear_modulus, packing.cement_poisson_ratio) * S_n;
  estimate.shear_modulus = 0.6 * estimate.bulk_modulus + 0.15 * contacts * packing.cement_shear_modulus * S_t;
  note_bound(packing, estimate);
  return estimate;
}

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
