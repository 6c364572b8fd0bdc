// SPDX-License-Identifier: GPL-3.0-or-later
// Strains are drawn, the stresses they need worked out and rounded, and the strains put right for what the
// rounding moved by one step of Newton's rule, whose error is the square of that.
#include <granum/effective/uniform_field.hpp>

#include "packing.hpp"

namespace accuracy {

namespace {

/// Stiffness scale and moments at strains (v, h): k_n/k_ref = (h/v sin^2 + cos^2)^(1/alpha).
struct Strained {
  Real scale; ///< P k_n of a vertical contact
  Real h;     ///< strain_h/strain_v
};

Strained strained(const Packing& p, const Real& v, const Real& h) {
  return {prefactor(p) * stiffness_at_overlap(p, 2 * p.R * v), h / v};
}

struct Stresses {
  Real v, h;
};

/// alpha/(1+alpha) C strain.
Stresses stresses(const Packing& p, const Real& v, const Real& h) {
  const Strained s = strained(p, v, h);
  const Five c = strain_stiffness(s.scale, p.r, weighted_moments(p.a, s.h, 1 / p.alpha));
  const Real secant = p.alpha / (1 + p.alpha);
  return {secant * (c.C33 * v + 2 * c.C13 * h), secant * ((c.C11 + c.C12) * h + c.C13 * v)};
}

/// d ln(stress_v/stress_h) by d ln(strain_v/strain_h), and the stresses.
struct Slope {
  Stresses at;
  Real value;
};
Slope slope(const Packing& p, const Real& v, const Real& h) {
  const Real step("1e-12");
  const Stresses here = stresses(p, v, h), moved = stresses(p, v * exp(step), h);
  return {here, log(moved.v / here.v * here.h / moved.h) / step};
}

void check_case(Table& table, Draw& draw) {
  PackingCase drawn = draw_packing(draw);
  const double v = draw.log_uniform(1e-12, 1e-2), ratio = draw.log_uniform(1e-2, 1e2);
  Packing& p = drawn.packing;
  const Slope first = slope(p, v, Real(v) / ratio);
  drawn.state.stress_v = static_cast<double>(first.at.v);
  drawn.state.stress_h = static_cast<double>(first.at.h);
  // Below a slope of 0.1 the strains that belong to given stresses are ill-determined.
  if (!(drawn.state.stress_v > 0 && drawn.state.stress_h > 0 && first.value > 0.1))
    return;
  const Real missed = log(Real(drawn.state.stress_v) / first.at.v * first.at.h / drawn.state.stress_h);
  const Real h_over_v = exp(-missed / first.value) / ratio;
  const Stresses turned = stresses(p, v, v * h_over_v);
  const Real load = (Real(drawn.state.stress_v) + 2 * Real(drawn.state.stress_h)) / (turned.v + 2 * turned.h);
  const Real strain_v = v * pow(load, p.alpha / (1 + p.alpha)), strain_h = strain_v * h_over_v;

  const std::string at = drawn.where + " " + said({{"strain_v", v}, {"strain_v/strain_h", ratio}});
  const std::string domain = "strains 0.01 to 100 apart, slope > 0.1";
  const auto field = kinematic_force_field(drawn.state);
  table.take("kinematic_force_field strains", domain, kinematic_strain, field.strain_v, strain_v, at);
  table.take("kinematic_force_field strains", domain, kinematic_strain, field.strain_h, strain_h, at);
  const Strained s = strained(p, strain_v, strain_h);
  compare(table, "uniform_strain_kinematic", domain, kinematic_strain,
          uniform_strain_kinematic(drawn.state).stiffness,
          strain_stiffness(s.scale, p.r, weighted_moments(p.a, s.h, 1 / p.alpha)), at);
  if (p.r > 1e-3)
    compare(table, "uniform_stress_kinematic", domain, kinematic_strain,
            uniform_stress_kinematic(drawn.state).stiffness,
            stress_stiffness(s.scale, p.r, fabric_moments(p.a), weighted_moments(p.a, s.h, -1 / p.alpha)),
            at);
}

} // namespace

void check_kinematic(Table& table, std::size_t samples) {
  Draw draw(9);
  for (std::size_t k = 0; k < samples; ++k)
    check_case(table, draw);
}

} // namespace accuracy
