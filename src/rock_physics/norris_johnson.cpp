// SPDX-License-Identifier: GPL-3.0-or-later
// Under the strain e0 + e3 x^2 along the normal, x = n3, and with e = e0 + e3, c = e0/e, s = e3/e, the
// stiffness of a contact is proportional to u = sqrt(c + s x^2), its normal force to u^3.
// The textbook integrals of x^k sqrt(a^2 + x^2), a^2 = e0/e3, cancel as a grows: the fourth power is lost at
// a = 1e4. Here they are used for a < 1 only, where they cost a bit or two. Beyond, a Gauss-Legendre rule
// of 24 points on [-1, 1] errs by less than (1 + sqrt 2)^-48 = 4e-19: its branch points are at a >= 1.
#include <granum/rock_physics/norris_johnson.hpp>

#include <cmath>
#include <utility>
#include <vector>

#include <granum/core/quadrature.hpp>

#include "effective/kernels.hpp"
#include "strained_contacts.hpp"

namespace granum::rock_physics {

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

} // namespace granum::rock_physics
