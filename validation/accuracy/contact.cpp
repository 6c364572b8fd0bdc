// SPDX-License-Identifier: GPL-3.0-or-later
// f = c d^(1+1/alpha) with c = 2 G/(1-nu) alpha/(alpha+1) (g/A)^(1/alpha), written as in [Sneddon1965].
#include <limits>

#include <boost/math/special_functions/gamma.hpp>
#include <granum/contact/power_law.hpp>

#include "harness.hpp"

namespace accuracy {

namespace {

using granum::contact::GrainMaterial;
using granum::contact::PowerLaw;

/// A law and the numbers that made it.
struct Case {
  std::string shape;
  PowerLaw law;
  Real coefficient; ///< c
  Real alpha;       ///< 0 stands for infinity
  std::string where;
};

Real general_coefficient(const GrainMaterial& grain, double alpha, double A) {
  const Real a = alpha;
  const Real log_g = boost::math::lgamma((a + 1) / 2) - boost::math::lgamma(a / 2 + 1) - log(2 * sqrt(pi()));
  return 2 * Real(grain.shear_modulus) / (1 - Real(grain.poisson_ratio)) * a / (a + 1) *
         exp((log_g - log(Real(A))) / a);
}

Case draw_case(Draw& draw, int shape) {
  const GrainMaterial grain{draw.log_uniform(1e6, 1e12), draw.poisson_ratio()};
  const Real bulk = Real(grain.shear_modulus) / (1 - Real(grain.poisson_ratio));
  const std::string material = said({{"G", grain.shear_modulus}, {"nu", grain.poisson_ratio}});
  if (shape == 0) {
    const double slope = draw.log_uniform(1e-3, 10);
    return {"cone", PowerLaw::cone(grain, slope), bulk / (pi() * slope), 1,
            material + " " + said({{"slope", slope}})};
  }
  if (shape == 1) {
    const double radius = draw.log_uniform(1e-9, 1e3);
    return {"sphere", PowerLaw::sphere(grain, radius), 2 * bulk * sqrt(2 * Real(radius)) / 3, 2,
            material + " " + said({{"R", radius}})};
  }
  if (shape == 2) {
    const double radius = draw.log_uniform(1e-12, 1e2);
    return {"flat", PowerLaw::flat(grain, radius), 2 * bulk * Real(radius), 0,
            material + " " + said({{"a", radius}})};
  }
  const double alpha = draw.uniform_or(1, 20, {1.0, 1.5, 2.0, 100.0, 1e4});
  const double A = draw.log_uniform(1e-3, 1e6);
  return {"power law", PowerLaw::general(grain, alpha, A), general_coefficient(grain, alpha, A), alpha,
          material + " " + said({{"alpha", alpha}, {"A", A}})};
}

void check_case(Table& table, Draw& draw, const Case& c) {
  const Real inverse = c.alpha == 0 ? Real(0) : 1 / c.alpha;
  const Real b = inverse / (1 + inverse);
  const double d = draw.log_uniform(1e-15, 1e-2), f = draw.log_uniform(1e-250, 1e12);
  const std::string at_d = c.where + " " + said({{"d", d}}), at_f = c.where + " " + said({{"f", f}});
  const std::string domain = c.shape == "power law" ? "power law, alpha 1..1e4" : c.shape;
  table.take("contact: coefficient", domain, closed_form, c.law.coefficient(), c.coefficient, c.where);
  const Real force = c.coefficient * pow(Real(d), 1 + inverse);
  table.take("contact: force(overlap)", domain, closed_form, c.law.force(d), force, at_d);
  table.take("contact: stiffness_at_overlap", domain, closed_form, c.law.stiffness_at_overlap(d),
             (1 + inverse) * force / d, at_d);
  table.take("contact: energy", domain, closed_form, c.law.energy(d), force * d / (2 + inverse), at_d);
  table.take("contact: stiffness_at_force", domain, closed_form, c.law.stiffness_at_force(f),
             (1 + inverse) * pow(c.coefficient, 1 - b) * pow(Real(f), b), at_f);
  table.take("contact: overlap(force)", domain, closed_form, c.law.overlap(f),
             pow(Real(f) / c.coefficient, 1 / (1 + inverse)), at_f);
}

} // namespace

void check_contact(Table& table, std::size_t samples) {
  Draw draw(1);
  for (int shape = 0; shape < 4; ++shape)
    for (std::size_t k = 0; k < (shape == 3 ? samples / 10 : samples / 4); ++k)
      check_case(table, draw, draw_case(draw, shape));
  for (std::size_t k = 0; k < samples; ++k) {
    const double nu = draw.poisson_ratio();
    table.take("contact: mindlin_stiffness_ratio", "nu in (-1, 0.5]", closed_form,
               granum::contact::mindlin_stiffness_ratio(nu), 2 * (1 - Real(nu)) / (2 - Real(nu)),
               said({{"nu", nu}}));
  }
}

} // namespace accuracy
