// SPDX-License-Identifier: GPL-3.0-or-later
// f = c d^(1+1/alpha) with c = 2 G/(1-nu) alpha/(alpha+1) (g/A)^(1/alpha), written as in [Sneddon1965].
#include <granum/contact/power_law.hpp>

#include "packing.hpp"

namespace accuracy {

namespace {

using granum::contact::GrainMaterial;
using granum::contact::PowerLaw;

/// A law and the numbers that made it.
struct Case {
  std::string shape;
  PowerLaw law;
  Real coefficient; ///< c
  Real inverse;     ///< 1/alpha
  std::string where;
};

Case draw_case(Draw& draw, int shape) {
  const GrainMaterial grain{draw.log_uniform(1e6, 1e12), draw.poisson_ratio()};
  const Real bulk = Real(grain.shear_modulus) / (1 - Real(grain.poisson_ratio));
  const std::string material = said("G nu", {grain.shear_modulus, grain.poisson_ratio}) + " ";
  if (shape == 0) {
    const double slope = draw.log_uniform(1e-3, 10);
    return {"cone", PowerLaw::cone(grain, slope), bulk / (pi() * slope), 1,
            material + said("slope", {slope})};
  }
  if (shape == 1) {
    const double radius = draw.log_uniform(1e-9, 1e3);
    return {"sphere", PowerLaw::sphere(grain, radius), 2 * bulk * sqrt(2 * Real(radius)) / 3, Real(1) / 2,
            material + said("R", {radius})};
  }
  if (shape == 2) {
    const double radius = draw.log_uniform(1e-12, 1e2);
    return {"flat", PowerLaw::flat(grain, radius), 2 * bulk * Real(radius), 0,
            material + said("a", {radius})};
  }
  const double alpha = draw.uniform_or(1, 20, {1.0, 1.5, 2.0, 100.0, 1e4});
  const double A = draw.log_uniform(1e-3, 1e6);
  return {"power law, alpha 1..1e4", PowerLaw::general(grain, alpha, A), coefficient(bulk, alpha, A),
          1 / Real(alpha), material + said("alpha A", {alpha, A})};
}

void check_case(Table& table, Draw& draw, const Case& c) {
  const Real b = c.inverse / (1 + c.inverse);
  const double d = draw.log_uniform(1e-15, 1e-2), f = draw.log_uniform(1e-250, 1e12);
  const Real force = c.coefficient * pow(Real(d), 1 + c.inverse);
  At{table, c.shape, c.where}("contact: coefficient", c.law.coefficient(), c.coefficient);
  const At at_d{table, c.shape, c.where + " " + said("d", {d})},
      at_f{table, c.shape, c.where + " " + said("f", {f})};
  at_d("contact: force(overlap)", c.law.force(d), force);
  at_d("contact: stiffness_at_overlap", c.law.stiffness_at_overlap(d), (1 + c.inverse) * force / d);
  at_d("contact: energy", c.law.energy(d), force * d / (2 + c.inverse));
  at_f("contact: stiffness_at_force", c.law.stiffness_at_force(f),
       (1 + c.inverse) * pow(c.coefficient, 1 - b) * pow(Real(f), b));
  at_f("contact: overlap(force)", c.law.overlap(f), pow(Real(f) / c.coefficient, 1 / (1 + c.inverse)));
}

} // namespace

void check_contact(Table& table, Draw& draw, std::size_t samples) {
  for (int shape = 0; shape < 4; ++shape)
    for (std::size_t k = 0; k < (shape == 3 ? samples / 10 : samples / 4); ++k)
      check_case(table, draw, draw_case(draw, shape));
  for (std::size_t k = 0; k < samples; ++k) {
    const double nu = draw.poisson_ratio();
    At{table, "nu in (-1, 0.5]", said("nu", {nu})}("contact: mindlin_stiffness_ratio",
                                                   granum::contact::mindlin_stiffness_ratio(nu),
                                                   2 * (1 - Real(nu)) / (2 - Real(nu)));
  }
}

} // namespace accuracy
