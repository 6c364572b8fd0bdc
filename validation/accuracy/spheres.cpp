// SPDX-License-Identifier: GPL-3.0-or-later
// Models of rock physics and of sphere packings as their sources print them, and the batch.
#include <granum/effective/batch.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/rock_physics/cement.hpp>
#include <granum/rock_physics/sphere_packs.hpp>

#include "packing.hpp"

namespace accuracy {

namespace {

using granum::contact::GrainMaterial;
using granum::rock_physics::CementedPacking;
using granum::rock_physics::CementScheme;
using granum::rock_physics::CoordinationRelation;
using granum::rock_physics::SpherePacking;

// ---- spheres under pressure ----

SpherePacking draw_pack(Draw& draw) {
  return {.shear_modulus = draw.log_uniform(1e6, 1e12),
          .poisson_ratio = draw.poisson_ratio(),
          .porosity = draw.uniform(0.05, 0.95),
          .coordination_number = draw.coordination_number(),
          .pressure = draw.pressure()};
}

std::string said_of(const SpherePacking& p, const std::string& more, std::initializer_list<double> values) {
  return said("G nu porosity C_n p",
              {p.shear_modulus, p.poisson_ratio, p.porosity, p.coordination_number, p.pressure}) +
         " " + said(more, values);
}

/// C_n times the share of the spheres.
Real contacts_of(const SpherePacking& p) { return Real(p.coordination_number) * (1 - Real(p.porosity)); }

/// k_t/k_n of the share of contacts that do not slip.
Real no_slip_ratio(const Real& nu, const Real& share = 1) { return share * 2 * (1 - nu) / (2 - nu); }

Moduli hertzian_of(const SpherePacking& p, const Real& share) {
  return hertzian({p.shear_modulus, p.poisson_ratio}, contacts_of(p), p.pressure,
                  no_slip_ratio(p.poisson_ratio, share));
}

void take(const At& at, const std::string& function, const auto& found, const Real& K, const Real& G) {
  at(function, found.bulk_modulus, K);
  at(function, found.shear_modulus, G);
}

void check_hertz_mindlin(Table& table, SpherePacking p, double share) {
  p.no_slip_fraction = share;
  const Moduli m = hertzian_of(p, share);
  take({table, "p 1e-300 to 1e12 Pa, C_n to 14", said_of(p, "share", {share})}, "hertz_mindlin",
       granum::rock_physics::hertz_mindlin(p), m.K, m.G);
}

/// The real root of the cubic by Newton's method from above, where it is convex.
Real cubic_root(const Real& q, const Real& t) {
  Real d = cbrt(2 * t) + sqrt(q);
  for (int k = 0; k < 200; ++k) {
    const Real next = d - (d * d * d + 3 * q * d - 2 * t) / (3 * d * d + 3 * q);
    if (!(next < d))
      break;
    d = next;
  }
  return d;
}

void check_digby(Table& table, const SpherePacking& p, double b) {
  const Real nu = p.poisson_ratio, mu = p.shear_modulus, C = contacts_of(p);
  const Real d = cubic_root(Real(b) * b / 2, 3 * pi() * (1 - nu) * p.pressure / (4 * C * mu));
  const Real S_n = 4 * mu * sqrt(d * d + Real(b) * b) / (1 - nu), S_t = 8 * mu * b / (2 - nu);
  take({table, "b/R 1e-9 to 1, p 1e-300 to 1e12 Pa", said_of(p, "b/R", {b})}, "digby",
       granum::rock_physics::digby({.shear_modulus = p.shear_modulus,
                                    .poisson_ratio = p.poisson_ratio,
                                    .porosity = p.porosity,
                                    .coordination_number = p.coordination_number,
                                    .pressure = p.pressure,
                                    .bond_radius_ratio = b}),
       C * S_n / (12 * pi()), C * (S_n + 3 * S_t / 2) / (20 * pi()));
}

/// 1/(s/(a+c) + (1-s)/(b+c)) - c.
Real bound(const Real& a, const Real& b, const Real& s, const Real& c) {
  return 1 / (s / (a + c) + (1 - s) / (b + c)) - c;
}
Real zeta(const Real& K, const Real& G) { return G / 6 * (9 * K + 8 * G) / (K + 2 * G); }

void check_sand(Table& table, const SpherePacking& p, double porosity) {
  if (p.poisson_ratio == 0.5)
    return;
  const Real nu = p.poisson_ratio, G_s = p.shear_modulus, s = Real(porosity) / p.porosity;
  const Real K_s = 2 * G_s * (1 + nu) / (3 * (1 - 2 * nu));
  const auto [K, G] = hertzian_of(p, 1);
  const At at{table, "porosity 0.01 to 0.99 of critical", said_of(p, "sand", {porosity})};
  take(at, "soft_sand", soft_sand(p, porosity), bound(K, K_s, s, 4 * G / 3), bound(G, G_s, s, zeta(K, G)));
  take(at, "stiff_sand", stiff_sand(p, porosity), bound(K, K_s, s, 4 * G_s / 3),
       bound(G, G_s, s, zeta(K_s, G_s)));
}

/// Means of x^n (e0 + e3 x^2)^(1/2) over x from 0 to 1 by the recurrence of its source, with digits to spare
/// for what it cancels.
Moments root_means(const Real& e0, const Real& e3) {
  const Real q = e0 / e3, root = sqrt(1 + q);
  const Real logarithm = q > 0 ? Real(q * log((1 + root) / sqrt(q))) : Real(0);
  Moments m;
  m.m0 = sqrt(e3) * (root + logarithm) / 2;
  m.m2 = (sqrt(e3) * (1 + q) * root - q * m.m0) / 4;
  m.m4 = (sqrt(e3) * (1 + q) * root - 3 * q * m.m2) / 6;
  return m;
}

void check_norris_johnson(Table& table, const SpherePacking& p, double e0, double e3) {
  const Real nu = p.poisson_ratio, kappa = 3 * contacts_of(p) * Real(p.shear_modulus) / (pi() * (1 - nu));
  const Five five = strain_stiffness(kappa, no_slip_ratio(nu), root_means(e0, e3));
  const auto c = granum::rock_physics::norris_johnson({.shear_modulus = p.shear_modulus,
                                                       .poisson_ratio = p.poisson_ratio,
                                                       .porosity = p.porosity,
                                                       .coordination_number = p.coordination_number,
                                                       .hydrostatic_strain = e0,
                                                       .uniaxial_strain = e3})
                     .stiffness;
  const At at{table, "e0/e3 1e-8 to 1e8", said_of(p, "e0 e3", {e0, e3}), stiffness_form};
  at("norris_johnson", c.C33, five.C33);
  at("norris_johnson", c.C11, five.C11);
  at("norris_johnson", c.C44, five.C44);
}

// ---- cement ----

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
  const std::string where =
      said("G nu G_c nu_c porosity C_n S",
           {p.shear_modulus, p.poisson_ratio, p.cement_shear_modulus, p.cement_poisson_ratio, p.porosity,
            p.coordination_number, p.cement_saturation});
  At{table, name, where}("cement_radius_ratio", cement_radius_ratio(p, scheme), alpha);
  // The polynomial in alpha is a difference; within the noted range of Lambda it keeps half of its terms.
  if (!(lambda_n > 0.1 && lambda_n < 1.5 && lambda_t > 0.1 && lambda_t < 1.5 && alpha < 1))
    return;
  const Real Mc = 2 * Gc * (1 - nu_c) / (1 - 2 * nu_c), K = C * (1 - phi) * Mc * S_n / 6;
  take({table, name + ", range of the regression", where, cement}, "contact_cement",
       contact_cement(p, scheme), K, 3 * K / 5 + 3 * C * (1 - phi) * Gc * S_t / 20);
}

void check_saturation(Table& table, Draw& draw) {
  const double critical = draw.uniform(0.01, 0.99), porosity = critical * draw.uniform(0, 0.999);
  At{table, "porosity 0 to 0.999 of critical", said("critical porosity", {critical, porosity})}(
      "cement_saturation", granum::rock_physics::cement_saturation(critical, porosity),
      1 - Real(porosity) / Real(critical));
}

// ---- contacts ----

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
  const At at{table, "porosity 0.2 to 0.7", said("porosity", {porosity})};
  const auto found = [&](CoordinationRelation which) {
    return granum::rock_physics::coordination_number(porosity, which);
  };
  at("coordination_number murphy_table", found(CoordinationRelation::murphy_table), murphy(phi));
  at("coordination_number murphy_quadratic", found(CoordinationRelation::murphy_quadratic),
     20 - 34 * phi + 14 * phi * phi);
  at("coordination_number murphy_exponential", found(CoordinationRelation::murphy_exponential),
     24 * exp(printed("-2.547") * phi) - printed("0.3731"));
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
  At{table, "k in [5.1, 11], of 1", said("k", {k}), quadrature}.of(
      1, "jenkins_shear_factor", granum::rock_physics::jenkins_shear_factor(k), jenkins(k));
}

// ---- uniaxial strain ----

void check_walton(Table& table, Draw& draw) {
  const granum::rock_physics::UniaxialPacking p{.shear_modulus = draw.log_uniform(1e6, 1e12),
                                                .poisson_ratio = draw.poisson_ratio(),
                                                .porosity = draw.uniform(0.05, 0.95),
                                                .coordination_number = draw.coordination_number(),
                                                .uniaxial_strain = draw.log_uniform(1e-300, 0.9),
                                                .no_slip_fraction = draw.uniform_or(0, 1, {0.0, 1.0})};
  const Real nu = p.poisson_ratio, e = p.uniaxial_strain;
  const Real r = no_slip_ratio(nu, p.no_slip_fraction);
  const Real M = 3 * Real(p.coordination_number) * (1 - Real(p.porosity)) * Real(p.shear_modulus) * sqrt(e) /
                 (pi() * (1 - nu));
  const At at{
      table, "e3 1e-300 to 0.9, smooth to rough",
      said("G nu porosity C_n e3 share", {p.shear_modulus, p.poisson_ratio, p.porosity, p.coordination_number,
                                          p.uniaxial_strain, p.no_slip_fraction})};
  const auto c = walton_uniaxial(p).stiffness;
  const auto stress = walton_uniaxial_stress(p);
  const Real C11 = M * (1 + r) / 16, vertical = M * e * (2 + r) / 18;
  at("walton_uniaxial C11, C33, C44", c.C11, C11);
  at("walton_uniaxial C11, C33, C44", c.C33, M * (2 + r) / 12);
  at("walton_uniaxial C11, C33, C44", c.C44, M * (4 + 5 * r) / 96);
  at.of(C11, "walton_uniaxial C12, C13 (of C11)", c.C12, M * (1 - r) / 48);
  at.of(C11, "walton_uniaxial C12, C13 (of C11)", c.C13, M * (1 - r) / 24);
  at("walton_uniaxial_stress vertical", stress.v, vertical);
  at.of(vertical, "walton_uniaxial_stress horizontal (of vertical)", stress.h, M * e * (1 - r) / 36);
}

// ---- the batch ----

/// 64 packings of one law in one call, and the first of them in a call of its own.
void check_batch(Table& table, Draw& draw) {
  constexpr std::size_t rows = 64;
  const GrainMaterial grain{draw.log_uniform(1e6, 1e12), draw.poisson_ratio()};
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
    const At at{
        table, domain,
        said("p C_n porosity r R G nu failed", {p[k], C[k], porosity[k], r, R, grain.shear_modulus,
                                                grain.poisson_ratio, static_cast<double>(report.failed)}),
        stiffness_form};
    at("batch uniform_strain K", K[k], m.K);
    at("batch uniform_strain G", G[k], m.G);
  }
  const double e = draw.log_uniform(0.05, 5);
  const auto one = granum::effective::uniform_strain_moduli({.law = law,
                                                             .tangential_ratio = r,
                                                             .radius = R,
                                                             .void_ratio = e,
                                                             .coordination_number = C[0],
                                                             .pressure = p[0]});
  const Moduli m = hertzian(grain, Real(C[0]) / (1 + Real(e)), p[0], r);
  const At at{table, domain,
              said("p C_n e r R G nu", {p[0], C[0], e, r, R, grain.shear_modulus, grain.poisson_ratio})};
  at("uniform_strain_moduli", one.bulk_modulus, m.K);
  at("uniform_strain_moduli", one.shear_modulus, m.G);
}

} // namespace

void check_sphere_packs(Table& table, Draw& draw, std::size_t /*sample*/) {
  const SpherePacking p = draw_pack(draw);
  check_hertz_mindlin(table, p, draw.uniform_or(0, 1, {0.0, 1.0}));
  check_digby(table, p, draw.log_uniform(1e-9, 0.99));
  check_sand(table, p, p.porosity * draw.uniform(0.01, 0.99));
  const double e = draw.log_uniform(1e-12, 1e-2), ratio = draw.log_uniform(1e-8, 1e8);
  check_norris_johnson(table, p, e * ratio / (1 + ratio), e / (1 + ratio));
}

void check_sphere_models(Table& table, Draw& draw, std::size_t k) {
  check_cement(table, draw, CementScheme::at_contacts, "cement at contacts");
  check_cement(table, draw, CementScheme::surface_layer, "cement in a layer");
  check_saturation(table, draw);
  check_relations(table, draw);
  check_jenkins(table, draw);
  check_walton(table, draw);
  if (k % 10 == 0)
    check_batch(table, draw);
}

} // namespace accuracy
