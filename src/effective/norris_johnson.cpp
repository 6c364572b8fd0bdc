// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: e0 hydrostatic, e3 uniaxial strain, x = n3; J_k = mean of x^k (e0 + e3 x^2)^(1/2) over the
// directions. A contact has k_n = kappa (e0 + e3 x^2)^(1/2)/P, kappa = 3 C_n (1-porosity) G_g/(pi (1-nu)).
#include <granum/effective/norris_johnson.hpp>

#include <cmath>
#include <numbers>

#include <granum/core/quadrature.hpp>

#include "kernels.hpp"
#include "sphere_pack.hpp"

namespace granum::effective {

namespace {

using kernel::AxialMoments;

struct Strains {
  double e0;
  double e3;
};

/// Smooth integrands: the branch point lies at i sqrt(e0/e3), 0.55 i or farther, and the symmetric rule of 40
/// points errs by less than 1e-17.
AxialMoments<double> moments_by_quadrature(const Strains& e) {
  static const std::vector<QuadratureNode> rule = gauss_legendre(40);
  AxialMoments<double> sum;
  for (std::size_t k = rule.size() / 2; k < rule.size(); ++k) {
    const double x2 = rule[k].abscissa * rule[k].abscissa;
    const double term = rule[k].weight * std::sqrt(e.e0 + e.e3 * x2);
    sum.m0 += term;
    sum.m2 += x2 * term;
    sum.m4 += x2 * x2 * term;
  }
  return sum;
}

/// The integrals in terms of q = e0/e3 <= 0.3, where the differences in them stay mild.
AxialMoments<double> moments_in_closed_form(const Strains& e) {
  const double q = e.e0 / e.e3, root = std::sqrt(1 + q);
  const double logarithm = q > 0 ? q * std::asinh(1 / std::sqrt(q)) : 0;
  const double m0 = (root + logarithm) / 2;
  const double m2 = ((1 + q) * root - q * m0) / 4;
  const double m4 = ((1 + q) * root - 3 * q * m2) / 6;
  const double scale = std::sqrt(e.e3);
  return {.m0 = scale * m0, .m2 = scale * m2, .m4 = scale * m4};
}

AxialMoments<double> moments(const Strains& e) {
  return e.e0 >= 0.3 * e.e3 ? moments_by_quadrature(e) : moments_in_closed_form(e);
}

struct Checked {
  Strains strain;
  double kappa; ///< [Pa]
  double ratio; ///< k_t/k_n
};

Checked checked(const StrainedPack& p) {
  const SpherePack pack{p.grain, p.porosity, p.coordination_number, 0};
  require_valid(pack);
  require_non_negative("hydrostatic_strain", p.hydrostatic_strain);
  require_non_negative("uniaxial_strain", p.uniaxial_strain);
  return {.strain = {p.hydrostatic_strain, p.uniaxial_strain},
          .kappa = 3 / std::numbers::pi * contact_modulus(pack),
          .ratio = slipping_ratio(p.grain, p.no_slip_share)};
}

/// Mean over the directions of (secant k_t over r kappa) e3 x^2 (1-x^2), the work of the tangential forces.
double tangential_mean(const Strains& e, const AxialMoments<double>& J, StrainPath path) {
  switch (path) {
  case StrainPath::together: // k_t grows from 0 with the strain: its mean is 2/3 of its end
    return 2.0 / 3 * e.e3 * (J.m2 - J.m4);
  case StrainPath::uniaxial_first: // 2/3 (e3 x^2)^(1/2)
    return 2.0 / 3 * e.e3 * std::sqrt(e.e3) * (1.0 / 4 - 1.0 / 6);
  case StrainPath::hydrostatic_first: { // 2/3 ((e0 + e3 x^2)^(3/2) - e0^(3/2))/(e3 x^2)
    const double all = e.e0 * (J.m0 - J.m2) + e.e3 * (J.m2 - J.m4);
    return 2.0 / 3 * (all - 2.0 / 3 * e.e0 * std::sqrt(e.e0));
  }
  }
  return 0;
}

} // namespace

elastic::TransverselyIsotropic norris_johnson(const StrainedPack& pack) {
  const auto [strain, kappa, ratio] = checked(pack);
  const auto c = kernel::uniform_strain(kappa, ratio, moments(strain), kernel::Spin::none);
  return {.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
}

AxisymmetricStress norris_johnson_stress(const StrainedPack& pack, StrainPath path) {
  const auto [strain, kappa, ratio] = checked(pack);
  const AxialMoments<double> J = moments(strain);
  const double all = 2.0 / 3 * (strain.e0 * J.m0 + strain.e3 * J.m2); // mean of 2/3 (e0 + e3 x^2)^(3/2)
  const double along = 2.0 / 3 * (strain.e0 * J.m2 + strain.e3 * J.m4);
  const double tangential = ratio * tangential_mean(strain, J, path);
  return {.vertical = kappa * (along + tangential),
          .horizontal = kappa * ((all - along) / 2 - tangential / 2)};
}

} // namespace granum::effective
