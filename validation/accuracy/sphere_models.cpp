// SPDX-License-Identifier: GPL-3.0-or-later
// Further models of sphere packings as their sources print them, and the batch.
#include <granum/effective/batch.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/rock_physics/cement.hpp>
#include <granum/rock_physics/sphere_packs.hpp>

#include "harness.hpp"

namespace accuracy {

namespace {

using granum::rock_physics::CementedPacking;
using granum::rock_physics::CementScheme;
using granum::rock_physics::CoordinationRelation;

/// A decimal as printed.
Real printed(const char* text) { return Real(text); }

/// S_n = A alpha^2 + B alpha + C of the regression.                                       [DvorkinNur1996]
Real normal_stiffness(const Real& alpha, const Real& lambda) {
  return printed("-0.024153") * pow(lambda, printed("-1.3646")) * alpha * alpha +
         printed("0.20405") * pow(lambda, printed("-0.89008")) * alpha +
         printed("0.00024649") * pow(lambda, printed("-1.9864"));
}

Real shear_stiffness(const Real& alpha, const Real& lambda, const Real& nu) {
  const Real nu2 = nu * nu;
  const Real A = -(printed("0.0226") * nu2 + printed("0.0207") * nu + printed("0.023")) *
                 pow(lambda, printed("0.079") * nu2 + printed("0.1754") * nu - printed("1.342"));
  const Real B = (printed("0.0573") * nu2 + printed("0.0937") * nu + printed("0.202")) *
                 pow(lambda, printed("0.0274") * nu2 + printed("0.0529") * nu - printed("0.8765"));
  const Real C = (printed("9.654e-4") * nu2 + printed("4.945e-4") * nu + printed("3.1e-4")) *
                 pow(lambda, printed("0.01867") * nu2 + printed("0.4011") * nu - printed("1.8186"));
  return A * alpha * alpha + B * alpha + C;
}

void check_cement(Table& table, Draw& draw, CementScheme scheme, const std::string& name) {
  const CementedPacking p{.shear_modulus = draw.log_uniform(1e9, 1e11),
                          .poisson_ratio = draw.uniform_or(-0.9, 0.5, {0.0, 0.25, 0.5}),
                          .cement_shear_modulus = draw.log_uniform(1e9, 1e11),
                          .cement_poisson_ratio = draw.uniform_or(-0.9, 0.45, {0.0, 0.25}),
                          .porosity = draw.uniform(0.05, 0.6),
                          .coordination_number = draw.uniform(2, 14),
                          .cement_saturation = draw.uniform_or(1e-6, 1, {1.0, 0.1})};
  const Real phi = p.porosity, C = p.coordination_number, S = p.cement_saturation, nu = p.poisson_ratio;
  const Real alpha = scheme == CementScheme::at_contacts
                         ? Real(2 * pow(S * phi / (3 * C * (1 - phi)), Real(1) / 4))
                         : Real(sqrt(2 * S * phi / (3 * (1 - phi))));
  const Real Gc = p.cement_shear_modulus, nu_c = p.cement_poisson_ratio, G = p.shear_modulus;
  const Real lambda_n = 2 * Gc * (1 - nu) * (1 - nu_c) / (pi() * G * (1 - 2 * nu_c)),
             lambda_t = Gc / (pi() * G);
  const Real S_n = normal_stiffness(alpha, lambda_n), S_t = shear_stiffness(alpha, lambda_t, nu);
  const std::string at = said({{"G", p.shear_modulus},
                               {"nu", p.poisson_ratio},
                               {"G_c", p.cement_shear_modulus},
                               {"nu_c", p.cement_poisson_ratio},
                               {"porosity", p.porosity},
                               {"C_n", p.coordination_number},
                               {"S", p.cement_saturation}});
  table.take("cement_radius_ratio", name, closed_form, cement_radius_ratio(p, scheme), alpha, at);
  // The polynomial in alpha is a difference; within the noted range of Lambda it keeps half of its terms.
  if (!(lambda_n > 0.1 && lambda_n < 1.5 && lambda_t > 0.1 && lambda_t < 1.5 && alpha < 1))
    return;
  const auto m = contact_cement(p, scheme);
  const Real Mc = 2 * Gc * (1 - nu_c) / (1 - 2 * nu_c), K = C * (1 - phi) * Mc * S_n / 6;
  table.take("contact_cement", name + ", range of the regression", cement, m.bulk_modulus, K, at);
  table.take("contact_cement", name + ", range of the regression", cement, m.shear_modulus,
             3 * K / 5 + 3 * C * (1 - phi) * Gc * S_t / 20, at);
}

void check_saturation(Table& table, Draw& draw) {
  const double critical = draw.uniform(0.01, 0.99), porosity = critical * draw.uniform(0, 0.999);
  table.take("cement_saturation", "porosity 0 to 0.999 of critical", closed_form,
             granum::rock_physics::cement_saturation(critical, porosity), 1 - Real(porosity) / Real(critical),
             said({{"critical", critical}, {"porosity", porosity}}));
}

/// Linear between the points of the compilation.                                             [Murphy1982]
Real murphy(const Real& phi) {
  const char* points[] = {"14.007", "12.336", "10.843", "9.5078", "8.3147", "7.2517",
                          "6.3108", "5.4878", "4.7826", "4.1988", "3.7440"};
  int k = 0;
  while (k < 9 && phi > Real(k + 5) / 20)
    ++k;
  const Real left(points[k]), right(points[k + 1]);
  return left + (right - left) * (phi * 20 - (k + 4));
}

void check_relations(Table& table, Draw& draw) {
  const double porosity = draw.uniform_or(0.2, 0.7, {0.2, 0.7, 0.25, 0.3, 0.35});
  const Real phi = porosity;
  const std::string at = said({{"porosity", porosity}}), domain = "porosity 0.2 to 0.7";
  const auto found = [&](CoordinationRelation which) {
    return granum::rock_physics::coordination_number(porosity, which);
  };
  table.take("coordination_number murphy_table", domain, closed_form,
             found(CoordinationRelation::murphy_table), murphy(phi), at);
  table.take("coordination_number murphy_quadratic", domain, closed_form,
             found(CoordinationRelation::murphy_quadratic), 20 - 34 * phi + 14 * phi * phi, at);
  table.take("coordination_number murphy_exponential", domain, closed_form,
             found(CoordinationRelation::murphy_exponential),
             24 * exp(printed("-2.547") * phi) - printed("0.3731"), at);
}

/// The sum (c0 (k-2)(k-4) + ...)/(16 pi) of the source, with c in hundredths.
Real neighbours(const Real& k, int c0, int c1, int c2, int c3) {
  return (c0 * (k - 2) * (k - 4) + c1 * k * (k - 2) + c2 * k * (k - 4) + c3 * k * k) / (1600 * pi());
}

/// 1 - 2 (x first - x^2 second + x^3 third), x = 3/k.                                       [Jenkins2005]
Real jenkins(const Real& k) {
  const Real a1 = (19 * k - 22) / 48, a2 = 3 * (6 - 3 * k) / 48;
  const Real w1 = (166 - 11 * k) / 128, w2 = -(k + 14) / 128, w = w1 - 1;
  const Real g1 = w - neighbours(k, 52, 10, -13, -1), g2 = w2 + neighbours(k, 44, -24, -11, -14);
  const Real second = g1 - (a1 + a2) * w - 2 * w2 * a2 + 2 * (g2 - w2 * a1);
  const Real e1 = a1 + neighbours(k, 196, 330, 49, 32) - a1 * a1;
  const Real e2 = a2 - neighbours(k, 216, 230, 54, -6) - (2 * a1 + a2) * a2;
  const Real third = (e1 + e2) * w1 + 2 * e2 * w2 + 2 * e1 * w2;
  const Real x = 3 / k;
  return 1 - 2 * x * (w1 + 2 * w2) + 2 * x * x * second - 2 * x * x * x * third;
}

void check_jenkins(Table& table, Draw& draw) {
  const double k = draw.uniform_or(5.1, 11, {6.0, 11.0});
  table.take_against("jenkins_shear_factor", "k in [5.1, 11], of 1", quadrature,
                     granum::rock_physics::jenkins_shear_factor(k), jenkins(k), 1, said({{"k", k}}));
}

void check_walton(Table& table, Draw& draw) {
  const granum::rock_physics::UniaxialPacking p{.shear_modulus = draw.log_uniform(1e6, 1e12),
                                                .poisson_ratio = draw.poisson_ratio(),
                                                .porosity = draw.uniform(0.05, 0.95),
                                                .coordination_number = draw.coordination_number(),
                                                .uniaxial_strain = draw.log_uniform(1e-300, 0.9),
                                                .no_slip_fraction = draw.uniform_or(0, 1, {0.0, 1.0})};
  const Real nu = p.poisson_ratio, e = p.uniaxial_strain;
  const Real r = 2 * (1 - nu) / (2 - nu) * Real(p.no_slip_fraction);
  const Real M = 3 * Real(p.coordination_number) * (1 - Real(p.porosity)) * Real(p.shear_modulus) * sqrt(e) /
                 (pi() * (1 - nu));
  const std::string at = said({{"G", p.shear_modulus},
                               {"nu", p.poisson_ratio},
                               {"porosity", p.porosity},
                               {"C_n", p.coordination_number},
                               {"e3", p.uniaxial_strain},
                               {"share", p.no_slip_fraction}});
  const std::string domain = "e3 1e-300 to 0.9, smooth to rough";
  const auto c = walton_uniaxial(p).stiffness;
  const std::pair<double, Real> constants[] = {
      {c.C11, M * (1 + r) / 16}, {c.C33, M * (2 + r) / 12}, {c.C44, M * (4 + 5 * r) / 96}};
  for (const auto& [value, reference] : constants)
    table.take("walton_uniaxial C11, C33, C44", domain, closed_form, value, reference, at);
  table.take_against("walton_uniaxial C12, C13 (of C11)", domain, closed_form, c.C12, M * (1 - r) / 48,
                     M * (1 + r) / 16, at);
  table.take_against("walton_uniaxial C12, C13 (of C11)", domain, closed_form, c.C13, M * (1 - r) / 24,
                     M * (1 + r) / 16, at);
  const auto stress = walton_uniaxial_stress(p);
  table.take("walton_uniaxial_stress vertical", domain, closed_form, stress.v, M * e * (2 + r) / 18, at);
  table.take_against("walton_uniaxial_stress horizontal (of vertical)", domain, closed_form, stress.h,
                     M * e * (1 - r) / 36, M * e * (2 + r) / 18, at);
}

/// K and G of spheres from the pressure.                                                      [Walton1987]
struct Moduli {
  Real K, G;
};
Moduli hertzian(const granum::contact::GrainMaterial& grain, const Real& contacts, const Real& p,
                const Real& r) {
  const Real m = contacts * Real(grain.shear_modulus) / (1 - Real(grain.poisson_ratio));
  const Real K = cbrt(m * m * p / (18 * pi() * pi()));
  return {K, K * 3 * (2 + 3 * r) / 10};
}

/// 64 packings of one law in one call, and the first of them in a call of its own.
void check_batch(Table& table, Draw& draw) {
  constexpr std::size_t rows = 64;
  const granum::contact::GrainMaterial grain{draw.log_uniform(1e6, 1e12), draw.poisson_ratio()};
  const double R = draw.log_uniform(1e-9, 1e3), r = draw.ratio();
  std::vector<double> p(rows), C(rows), porosity(rows), K(rows), G(rows);
  for (std::size_t k = 0; k < rows; ++k)
    p[k] = draw.pressure(), C[k] = draw.coordination_number(), porosity[k] = draw.uniform(0.01, 0.99);
  p[1] = 0;
  const auto law = granum::contact::PowerLaw::sphere(grain, R);
  const auto report = granum::effective::uniform_strain({.law = law,
                                                         .tangential_ratio = r,
                                                         .radius = R,
                                                         .pressure = p,
                                                         .coordination_number = C,
                                                         .porosity = porosity},
                                                        {K, G});
  const std::string domain = "spheres, p 0 and 1e-300 to 1e12 Pa";
  for (std::size_t k = 0; k < rows; ++k) {
    const Moduli m = hertzian(grain, Real(C[k]) * (1 - Real(porosity[k])), p[k], r);
    const std::string at = said({{"p", p[k]},
                                 {"C_n", C[k]},
                                 {"porosity", porosity[k]},
                                 {"r", r},
                                 {"R", R},
                                 {"G", grain.shear_modulus},
                                 {"nu", grain.poisson_ratio},
                                 {"failed", static_cast<double>(report.failed)}});
    table.take("batch uniform_strain K", domain, stiffness_form, K[k], m.K, at);
    table.take("batch uniform_strain G", domain, stiffness_form, G[k], m.G, at);
  }
  const double e = draw.log_uniform(0.05, 5);
  const auto one = granum::effective::uniform_strain_moduli({.law = law,
                                                             .tangential_ratio = r,
                                                             .radius = R,
                                                             .void_ratio = e,
                                                             .coordination_number = C[0],
                                                             .pressure = p[0]});
  const Moduli m = hertzian(grain, Real(C[0]) / (1 + Real(e)), p[0], r);
  const std::string at = said({{"p", p[0]},
                               {"C_n", C[0]},
                               {"e", e},
                               {"r", r},
                               {"R", R},
                               {"G", grain.shear_modulus},
                               {"nu", grain.poisson_ratio}});
  table.take("uniform_strain_moduli", domain, closed_form, one.bulk_modulus, m.K, at);
  table.take("uniform_strain_moduli", domain, closed_form, one.shear_modulus, m.G, at);
}

} // namespace

void check_sphere_models(Table& table, std::size_t samples) {
  Draw draw(11);
  for (std::size_t k = 0; k < samples; ++k) {
    check_cement(table, draw, CementScheme::at_contacts, "cement at contacts");
    check_cement(table, draw, CementScheme::surface_layer, "cement in a layer");
    check_saturation(table, draw);
    check_relations(table, draw);
    check_jenkins(table, draw);
    check_walton(table, draw);
    if (k % 10 == 0)
      check_batch(table, draw);
  }
}

} // namespace accuracy
