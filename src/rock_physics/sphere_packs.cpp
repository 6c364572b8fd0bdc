// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sphere_packs.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>

#include "effective/kernels.hpp"
#include "sphere_checks.hpp"

namespace granum::rock_physics {

namespace {

/// True only for packings that the checks below pass without a note: the usual case, in a few comparisons.
bool unremarkable(const SpherePacking& s) {
  return s.shear_modulus > 0 && s.shear_modulus <= std::numeric_limits<double>::max() &&
         s.poisson_ratio > -1 && s.poisson_ratio <= 0.5 && s.porosity >= 0 && s.porosity < 1 &&
         s.coordination_number > 0 && s.coordination_number <= 12 && s.no_slip_fraction >= 0 &&
         s.no_slip_fraction <= 1 && s.pressure >= 0 &&
         s.pressure < 2e-3 * sphere::stiffness_density(s) * s.shear_modulus;
}

void note_load(const SpherePacking& s, Validity& validity) {
  if (s.pressure == 0)
    return;
  if (s.coordination_number == 0)
    return validity.add("no contacts carry the pressure: the moduli are zero");
  const double contact_radius_cubed = s.pressure / s.shear_modulus / (2 * sphere::stiffness_density(s));
  if (contact_radius_cubed > 1e-3)
    sphere::note_contact_radius(std::cbrt(contact_radius_cubed), validity);
}

} // namespace

Validity require_valid(const SpherePacking& s) {
  if (unremarkable(s))
    return {};
  sphere::require_grain(s);
  require_non_negative("pressure", s.pressure, "Pa");
  require_closed("no_slip_fraction", s.no_slip_fraction, 0, 1);

  Validity validity;
  sphere::note_coordination(s, validity);
  note_load(s, validity);
  return validity;
}

namespace {

/// C_n at porosities 0.20, 0.25, ..., 0.70.
constexpr std::array<double, 11> murphy{14.007, 12.336, 10.843, 9.5078, 8.3147, 7.2517,
                                        6.3108, 5.4878, 4.7826, 4.1988, 3.7440};

double from_table(double porosity) {
  const double place = (porosity - 0.2) / 0.05;
  const std::size_t i = std::min(static_cast<std::size_t>(place), murphy.size() - 2);
  const double t = place - static_cast<double>(i);
  return (1 - t) * murphy[i] + t * murphy[i + 1];
}

} // namespace

PorosityRange porosity_range(CoordinationRelation relation) {
  switch (relation) {
  case CoordinationRelation::murphy_table:
  case CoordinationRelation::murphy_quadratic:
  case CoordinationRelation::murphy_exponential:
    return {.low = 0.2, .high = 0.7};
  }
  throw InvalidArgument(
      "coordination relation must be one of murphy_table, murphy_quadratic, murphy_exponential");
}

double coordination_number(double porosity, CoordinationRelation relation) {
  const PorosityRange range = porosity_range(relation);
  require_closed("porosity", porosity, range.low, range.high);
  switch (relation) {
  case CoordinationRelation::murphy_quadratic:
    return (20 - 14 * porosity) * (1 - porosity); // factors keep the digits that the sum would lose
  case CoordinationRelation::murphy_exponential:
    return 24 * std::exp(-2.547 * porosity) - 0.3731;
  default:
    return from_table(porosity);
  }
}

namespace {

/// (x^2 y)^(1/3) of x, y >= 0. The cubed value may leave the range of a double where the root does not.
double cube_root_of_square(double x, double y) {
  constexpr double smallest = std::numeric_limits<double>::min();
  const double cubed = x * x * y;
  if (cubed >= smallest && std::isfinite(cubed))
    return std::cbrt(cubed);
  const double root = std::cbrt(x);
  return root * root * std::cbrt(y);
}

} // namespace

IsotropicEstimate hertz_mindlin(const SpherePacking& packing) {
  IsotropicEstimate estimate{.bulk_modulus = 0, .shear_modulus = 0, .validity = require_valid(packing)};
  // K^3 = (stiffness_density G)^2 p/2
  const double modulus = sphere::stiffness_density(packing) * packing.shear_modulus;
  estimate.bulk_modulus = cube_root_of_square(modulus, packing.pressure / 2);
  estimate.shear_modulus = estimate.bulk_modulus * (0.6 + 0.9 * sphere::mean_tangential_ratio(packing));
  return estimate;
}

namespace {

Validity checked(const BondedPacking& p) {
  sphere::require_grain(p);
  require_non_negative("pressure", p.pressure, "Pa");
  if (!(p.bond_radius_ratio >= 0 && p.bond_radius_ratio < 1))
    throw InvalidArgument("bond_radius_ratio", p.bond_radius_ratio, "", "[0, 1)");
  Validity validity;
  sphere::note_coordination(p, validity);
  return validity;
}

/// The real root of d^3 + 3 m d = q for m, q >= 0. Cardano's difference t - m/t, multiplied out into a
/// quotient of positive terms.
double monotone_cubic_root(double m, double q) {
  const double t = std::cbrt(q / 2 + std::hypot(q / 2, m * std::sqrt(m)));
  if (t == 0)
    return 0;
  const double other = m / t;
  return q / (t * t + m + other * other);
}

/// Contact radius a by grain radius from the bond radius b; p/(2 modulus) is the cube of the radius without
/// bonds. Lengths are measured in 2^-100 grain radii, so that tiny pressures keep their digits.
double contact_radius(double b, double pressure, double modulus) {
  constexpr double radius = 0x1p100;
  const double bond = b * radius;
  const double d =
      monotone_cubic_root(bond * bond / 2, pressure * (radius * radius * radius) / (2 * modulus));
  return std::sqrt(d * d + bond * bond) / radius;
}

} // namespace

IsotropicEstimate digby(const BondedPacking& packing) {
  IsotropicEstimate estimate{.bulk_modulus = 0, .shear_modulus = 0, .validity = checked(packing)};
  const double modulus = sphere::stiffness_density(packing) * packing.shear_modulus;
  if (modulus == 0)
    return estimate;
  const double b = packing.bond_radius_ratio;
  const double a = contact_radius(b, packing.pressure, modulus);
  sphere::note_contact_radius(a, estimate.validity);
  estimate.bulk_modulus = modulus * a;
  estimate.shear_modulus = modulus * (0.6 * a + 0.9 * sphere::no_slip_ratio(packing.poisson_ratio) * b);
  return estimate;
}

// The coefficients of the source as polynomials in k, with its own letters: the pair's response to the mean
// strain (omega, alpha), the contribution of its neighbours (gamma, rho), and their products (kappa, eta) in
// the second and third order of 3/k.

namespace {

/// [c0 (k-2)(k-4) + c1 k(k-2) + c2 k(k-4) + c3 k^2]/(16 pi): neighbours of two or of one of a pair's spheres.
double neighbours(double k, double c0, double c1, double c2, double c3) {
  return (c0 * (k - 2) * (k - 4) + c1 * k * (k - 2) + c2 * k * (k - 4) + c3 * k * k) /
         (16 * std::numbers::pi);
}

} // namespace

double jenkins_shear_factor(double coordination_number) {
  const double k = require_closed("coordination_number", coordination_number, 5.1, 11);

  const double alpha_1 = (19 * k - 22) / 48;
  const double alpha_2 = (18 - 9 * k) / 48;
  const double omega_1 = (166 - 11 * k) / 128;
  const double omega_2 = -(k + 14) / 128;
  const double omega_mean = (38 - 11 * k) / 128;

  const double gamma_1 = omega_mean - neighbours(k, 0.52, 0.10, -0.13, -0.01);
  const double gamma_2 = omega_2 + neighbours(k, 0.44, -0.24, -0.11, -0.14);
  const double kappa_1 = gamma_1 - (alpha_1 + alpha_2) * omega_mean - 2 * omega_2 * alpha_2;
  const double kappa_2 = gamma_2 - omega_2 * alpha_1;

  const double eta_1 = alpha_1 + neighbours(k, 1.96, 3.30, 0.49, 0.32) - alpha_1 * alpha_1;
  const double eta_2 = alpha_2 - neighbours(k, 2.16, 2.30, 0.54, -0.06) - (2 * alpha_1 + alpha_2) * alpha_2;
  const double xi_1 = (eta_1 + eta_2) * omega_1 + 2 * eta_2 * omega_2;
  const double xi_2 = eta_1 * omega_2;

  const double order = 3 / k;
  const double first = omega_1 + 2 * omega_2, second = kappa_1 + 2 * kappa_2, third = xi_1 + 2 * xi_2;
  return 1 - 2 * order * (first - order * (second - order * third));
}

double jenkins_shear_modulus(const SpherePacking& packing) {
  if (packing.no_slip_fraction != 0)
    throw InvalidArgument("no_slip_fraction", packing.no_slip_fraction, "",
                          "{0}: the theory is made for frictionless spheres");
  return jenkins_shear_factor(packing.coordination_number) * hertz_mindlin(packing).shear_modulus;
}

// Under the strain e0 + e3 x^2 along the normal, x = n3, and with e = e0 + e3, c = e0/e, s = e3/e, the
// stiffness of a contact is proportional to u = sqrt(c + s x^2), its normal force to u^3.
// The textbook integrals of x^k sqrt(a^2 + x^2), a^2 = e0/e3, cancel as a grows: the fourth power is lost at
// a = 1e4. Here they are used for a < 1 only, where they cost a bit or two. Beyond, a Gauss-Legendre rule
// of 24 points on [-1, 1] errs by less than (1 + sqrt 2)^-48 = 4e-19: its branch points are at a >= 1.

namespace {

/// The strains as a sum and its two shares.
struct Strain {
  double sum;
  double hydrostatic; ///< c
  double uniaxial;    ///< s
};

/// Means of the normal force u^3, of u^3 x^2, and the contribution of the tangential forces to the latter at
/// k_t = k_n.
struct StressMoments {
  double isotropic = 0;
  double axial = 0;
  double tangential = 0;
};

Strain strain_of(const StrainedPacking& p) {
  const double sum = p.hydrostatic_strain + p.uniaxial_strain;
  return sum > 0 ? Strain{sum, p.hydrostatic_strain / sum, p.uniaxial_strain / sum} : Strain{0, 1, 0};
}

bool nearly_isotropic(const Strain& e) { return e.hydrostatic >= e.uniaxial; }

const std::vector<QuadratureNode>& half_rule() {
  static const std::vector<QuadratureNode> half = [] {
    const std::vector<QuadratureNode> rule = gauss_legendre(24);
    return std::vector<QuadratureNode>(rule.begin() + 12, rule.end());
  }();
  return half;
}

effective::kernel::AxialMoments<double> by_quadrature(const Strain& e) {
  effective::kernel::AxialMoments<double> m;
  for (const auto& [x, weight] : half_rule()) {
    const double term = weight * std::sqrt(e.hydrostatic + e.uniaxial * x * x);
    const double cos2 = x * x, sin2 = (1 - x) * (1 + x);
    m.s4 += term * sin2 * sin2;
    m.s2c2 += term * sin2 * cos2;
    m.c4 += term * cos2 * cos2;
  }
  return m;
}

effective::kernel::AxialMoments<double> by_closed_form(const Strain& e) {
  const double a2 = e.hydrostatic / e.uniaxial;
  const double root = std::sqrt(1 + a2);
  const double cube = root * (1 + a2);
  const double tail = a2 > 0 ? a2 * std::asinh(1 / std::sqrt(a2)) : 0;
  const double I0 = (root + tail) / 2;
  const double I2 = (cube - a2 * I0) / 4;
  const double I4 = (cube - 3 * a2 * I2) / 6;
  const double scale = std::sqrt(e.uniaxial);
  return {.s4 = scale * (I0 - 2 * I2 + I4), .s2c2 = scale * (I2 - I4), .c4 = scale * I4};
}

/// Moments of the weight u. Without uniaxial strain those of 1, exactly.
effective::kernel::AxialMoments<double> stiffness_moments(const Strain& e) {
  if (e.uniaxial == 0)
    return {.s4 = 8.0 / 15, .s2c2 = 2.0 / 15, .c4 = 0.2};
  return nearly_isotropic(e) ? by_quadrature(e) : by_closed_form(e);
}

/// Integral of (1-x^2) (u^3 - v^3), v = u(0): tangential displacement at a normal force that grows from v.
double after_hydrostatic(const Strain& e, const StressMoments& m) {
  const double v = std::sqrt(e.hydrostatic);
  if (!nearly_isotropic(e))
    return (m.isotropic - m.axial) - 2.0 / 3 * v * e.hydrostatic;
  double sum = 0;
  for (const auto& [x, weight] : half_rule()) {
    const double u2 = e.hydrostatic + e.uniaxial * x * x;
    const double u = std::sqrt(u2);
    sum += weight * (1 - x * x) * x * x * (u2 + u * v + e.hydrostatic) / (u + v);
  }
  return e.uniaxial * sum;
}

double tangential_moment(const Strain& e, const effective::kernel::AxialMoments<double>& w,
                         const StressMoments& m, StrainPath path) {
  switch (path) {
  case StrainPath::hydrostatic_first:
    return after_hydrostatic(e, m);
  case StrainPath::uniaxial_first:
    return e.uniaxial * std::sqrt(e.uniaxial) / 12;
  case StrainPath::simultaneous:
    return e.uniaxial * w.s2c2;
  }
  throw InvalidArgument("strain path must be one of hydrostatic_first, uniaxial_first, simultaneous");
}

Validity checked(const StrainedPacking& p) {
  sphere::require_grain(p);
  sphere::require_strain("hydrostatic_strain", p.hydrostatic_strain);
  sphere::require_strain("uniaxial_strain", p.uniaxial_strain);
  require_closed("no_slip_fraction", p.no_slip_fraction, 0, 1);
  Validity validity;
  sphere::note_coordination(p, validity);
  sphere::note_contact_radius(std::sqrt(p.hydrostatic_strain + p.uniaxial_strain), validity);
  return validity;
}

} // namespace

effective::Estimate norris_johnson(const StrainedPacking& packing) {
  Validity validity = checked(packing);
  const Strain e = strain_of(packing);
  const auto c = effective::kernel::uniform_strain(sphere::contact_modulus(packing, e.sum),
                                                   sphere::mean_tangential_ratio(packing),
                                                   stiffness_moments(e), effective::kernel::Spin::none);
  return {{.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44}, std::move(validity)};
}

stress::AxialStress norris_johnson_stress(const StrainedPacking& packing, StrainPath path) {
  checked(packing);
  const Strain e = strain_of(packing);
  const auto w = stiffness_moments(e);
  const double cos2 = vertical_square(w);
  StressMoments m{.isotropic = e.hydrostatic * mean_weight(w) + e.uniaxial * cos2,
                  .axial = e.hydrostatic * cos2 + e.uniaxial * w.c4};
  m.tangential = tangential_moment(e, w, m, path);
  const double scale = 2.0 / 3 * sphere::contact_modulus(packing, e.sum) * e.sum;
  const double shear = sphere::mean_tangential_ratio(packing) * m.tangential;
  return {.v = scale * (m.axial + shear), .h = scale * ((m.isotropic - m.axial) - shear) / 2};
}

namespace {

Validity checked(const UniaxialPacking& p) {
  return checked(StrainedPacking{.shear_modulus = p.shear_modulus,
                                 .poisson_ratio = p.poisson_ratio,
                                 .porosity = p.porosity,
                                 .coordination_number = p.coordination_number,
                                 .hydrostatic_strain = 0,
                                 .uniaxial_strain = p.uniaxial_strain,
                                 .no_slip_fraction = p.no_slip_fraction});
}

} // namespace

effective::Estimate walton_uniaxial(const UniaxialPacking& packing) {
  Validity validity = checked(packing);
  const double M = sphere::contact_modulus(packing, packing.uniaxial_strain);
  const double r = sphere::mean_tangential_ratio(packing);
  return {{.C11 = M * (1 + r) / 16,
           .C33 = M * (2 + r) / 12,
           .C12 = M * (1 - r) / 48,
           .C13 = M * (1 - r) / 24,
           .C44 = M * (4 + 5 * r) / 96},
          std::move(validity)};
}

stress::AxialStress walton_uniaxial_stress(const UniaxialPacking& packing) {
  checked(packing);
  const double strain = packing.uniaxial_strain;
  const double M = sphere::contact_modulus(packing, strain);
  const double r = sphere::mean_tangential_ratio(packing);
  return {.v = M * strain * (2 + r) / 18, .h = M * strain * (1 - r) / 36};
}

} // namespace granum::rock_physics
