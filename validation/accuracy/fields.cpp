// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms in a, k_n and k_t as sums of the moments of E(gamma; a), [ChangLiao1994] for uniform stress;
// by direction; with the kinematic force field; and derivatives.
#include <granum/effective/exponents.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>

#include "packing.hpp"

namespace accuracy {

namespace {

using granum::effective::Hypothesis;
using granum::effective::Modulus;
using granum::effective::State;
using granum::effective::UniformContacts;

const char* const far_forces = "forces 1 to 1e4 apart, a in [-1, 1]";

void check_uniform_contacts(Table& table, Draw& draw) {
  const double a = draw.anisotropy(), r = draw.ratio();
  UniformContacts sheared{.prefactor = draw.log_uniform(1, 1e9),
                          .normal_stiffness = draw.log_uniform(1e-3, 1e9),
                          .tangential_stiffness = 0,
                          .fabric_anisotropy = a};
  sheared.tangential_stiffness = r * sheared.normal_stiffness;
  const Real scale = Real(sheared.prefactor) * Real(sheared.normal_stiffness);
  const Real ratio = Real(sheared.tangential_stiffness) / Real(sheared.normal_stiffness);
  const Moments m = fabric_moments(Real(a));
  const At at{table, "a in [-1, 1], k_t/k_n 0 to 2", said("a r", {a, r})};
  compare(at, "uniform_strain_stiffness", uniform_strain_stiffness(sheared),
          strain_stiffness(scale, ratio, m));
  compare(at, "free_spin_stiffness", free_spin_stiffness(sheared), free_spin_stiffness(scale, ratio, m));
  if (r > 0)
    compare(at, "uniform_stress_stiffness", uniform_stress_stiffness(sheared),
            stress_stiffness(scale, ratio, m, m));
}

void check_isotropic_state(Table& table, Draw& draw) {
  const double nu = draw.poisson_ratio(), p = draw.pressure(), R = draw.log_uniform(1e-9, 1e3);
  const granum::contact::GrainMaterial grain{draw.log_uniform(1e6, 1e12), nu};
  const State state{.law = granum::contact::PowerLaw::sphere(grain, R),
                    .tangential_ratio = draw.ratio(),
                    .radius = R,
                    .void_ratio = draw.log_uniform(0.05, 5),
                    .coordination_number = draw.coordination_number(),
                    .stress_v = p,
                    .stress_h = p};
  const Real contacts = Real(*state.coordination_number) / (1 + Real(state.void_ratio));
  const Moduli m = hertzian(grain, contacts, p, state.tangential_ratio);
  const At at{table, "spheres, p 1e-300 to 1e12 Pa",
              said("p R e C_n r G nu", {p, R, state.void_ratio, *state.coordination_number,
                                        state.tangential_ratio, grain.shear_modulus, nu}),
              stiffness_form};
  const auto c = uniform_strain(state).stiffness;
  at("uniform_strain isotropic K", c.bulk_modulus(), m.K);
  at("uniform_strain isotropic G", c.G_vh(), m.G);
  const Real P = 3 * contacts / (2 * pi() * Real(R));
  At{table, "as above", at.where}("prefactor", prefactor(state), P);
  if (p * R * R > 1e-290)
    At{table, "4 pi R^2 p/C_n above 1e-290 N", at.where}("mean_contact_force", mean_contact_force(state),
                                                         6 * Real(p) * Real(R) / P);
}

void check_directional_case(Table& table, Draw& draw) {
  const granum::contact::GrainMaterial grain{30e9, 0.15};
  const double alpha = draw.uniform_or(1, 8, {1.0, 2.0}), p = draw.log_uniform(1, 1e7);
  const double spread = draw.log_uniform(1e-4, 1e4), a = draw.anisotropy();
  const Real F33 = fabric_moments(Real(a)).m2, F11 = (1 - F33) / 2;
  const State state{.law = granum::contact::PowerLaw::general(grain, alpha, 1000),
                    .tangential_ratio = draw.uniform_or(0.01, 2, {1.0}),
                    .radius = 5e-4,
                    .void_ratio = 0.6,
                    .coordination_number = 5,
                    .fabric_anisotropy = a,
                    .stress_v = p,
                    .stress_h = p / spread * static_cast<double>(F11 / F33) * 1.0001};
  if ((spread > 1 ? spread : 1 / spread) > 0.999e4)
    return;
  const Packing packing{grain.shear_modulus,
                        grain.poisson_ratio,
                        alpha,
                        1000,
                        state.tangential_ratio,
                        state.radius,
                        state.void_ratio,
                        *state.coordination_number,
                        a,
                        state.stress_v,
                        state.stress_h};
  const At at{table, far_forces,
              said("alpha a stress_v stress_h", {alpha, a, state.stress_v, state.stress_h}), quadrature};
  compare(at, "uniform_strain directional", uniform_strain(state).stiffness,
          static_stiffness(packing, Hypothesis::uniform_strain));
  compare(at, "uniform_stress directional", uniform_stress(state).stiffness,
          static_stiffness(packing, Hypothesis::uniform_stress));
}

// ---- derivatives, by differences of 50-digit values at five points, whose error is 1e-24 ----

constexpr Modulus moduli[] = {Modulus::K, Modulus::G_hh, Modulus::G_vh, Modulus::E_v, Modulus::E_h};

/// Logarithmic derivative of each of `moduli` by a member of a packing.
struct Slopes {
  Real of[5];
};
Slopes slopes(const Packing& packing, Hypothesis hypothesis, Real Packing::*member) {
  const Real step = Real(1) / 1000000;
  Slopes sum{};
  for (const int k : {-2, -1, 1, 2}) {
    Packing moved = packing;
    moved.*member *= 1 + k * step;
    const Five c = static_stiffness(moved, hypothesis);
    const Real weight = Real(k == 1 ? 8 : k == -1 ? -8 : k == 2 ? -1 : 1) / (12 * step);
    for (int m = 0; m < 5; ++m)
      sum.of[m] += weight * modulus(c, moduli[m]);
  }
  const Five c = static_stiffness(packing, hypothesis);
  for (int m = 0; m < 5; ++m)
    sum.of[m] /= modulus(c, moduli[m]);
  return sum;
}

void check_exponents(Table& table, const PackingCase& drawn, Hypothesis hypothesis, const std::string& name,
                     granum::effective::StressExponents (*exponents)(const State&, Modulus)) {
  const Slopes v = slopes(drawn.packing, hypothesis, &Packing::stress_v);
  const Slopes h = slopes(drawn.packing, hypothesis, &Packing::stress_h);
  const At at{table, "K, G and E, of 1, forces up to 1e4 apart", drawn.where, derivative};
  for (int m = 0; m < 5; ++m) {
    const granum::effective::StressExponents found = exponents(drawn.state, moduli[m]);
    at.of(1, name + " m, n", found.stress_v, v.of[m]);
    at.of(1, name + " m, n", found.stress_h, h.of[m]);
    at.of(1, name + " s", found.sum(), 1 / (1 + drawn.packing.alpha));
  }
}

// ---- the kinematic force field ----
// Strains are drawn, the stresses they need worked out and rounded, and the strains put right for what the
// rounding moved by one step of Newton's rule, whose error is the square of that.

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

void check_kinematic_case(Table& table, Draw& draw) {
  PackingCase drawn = draw_packing(draw);
  const double v = draw.log_uniform(1e-12, 1e-2), ratio = draw.log_uniform(1e-2, 1e2);
  const Packing& p = drawn.packing;
  const Stresses first = stresses(p, v, Real(v) / ratio);
  const Real step("1e-12");
  const Stresses moved = stresses(p, v * exp(step), Real(v) / ratio);
  const Real slope =
      log(moved.v / first.v * first.h / moved.h) / step; // of ln of both ratios, of stress and strain
  drawn.state.stress_v = static_cast<double>(first.v);
  drawn.state.stress_h = static_cast<double>(first.h);
  // Below a slope of 0.1 the strains that belong to given stresses are ill-determined.
  if (!(drawn.state.stress_v > 0 && drawn.state.stress_h > 0 && slope > 0.1))
    return;
  const Real missed = log(Real(drawn.state.stress_v) / first.v * first.h / drawn.state.stress_h);
  const Real h_over_v = exp(-missed / slope) / ratio;
  const Stresses turned = stresses(p, v, v * h_over_v);
  const Real load = (Real(drawn.state.stress_v) + 2 * Real(drawn.state.stress_h)) / (turned.v + 2 * turned.h);
  const Real strain_v = v * pow(load, p.alpha / (1 + p.alpha)), strain_h = strain_v * h_over_v;

  const At at{table, "strains 0.01 to 100 apart, slope > 0.1",
              drawn.where + " " + said("strain_v strain_v/strain_h", {v, ratio}), derivative};
  const auto field = kinematic_force_field(drawn.state);
  at("kinematic_force_field strains", field.strain_v, strain_v);
  at("kinematic_force_field strains", field.strain_h, strain_h);
  const Strained s = strained(p, strain_v, strain_h);
  compare(at, "uniform_strain_kinematic", uniform_strain_kinematic(drawn.state).stiffness,
          strain_stiffness(s.scale, p.r, weighted_moments(p.a, s.h, 1 / p.alpha)));
  if (p.r > 1e-3)
    compare(at, "uniform_stress_kinematic", uniform_stress_kinematic(drawn.state).stiffness,
            stress_stiffness(s.scale, p.r, fabric_moments(p.a), weighted_moments(p.a, s.h, -1 / p.alpha)));
}

} // namespace

void check_uniform_field(Table& table, Draw& draw, std::size_t /*sample*/) {
  check_uniform_contacts(table, draw);
  check_isotropic_state(table, draw);
}

void check_directional(Table& table, Draw& draw, std::size_t /*sample*/) {
  check_directional_case(table, draw);
}

void check_static_field(Table& table, Draw& draw, std::size_t /*sample*/) {
  const PackingCase drawn = draw_packing(draw);
  compare({table, far_forces, drawn.where, quadrature}, "free_spin(state)", free_spin(drawn.state).stiffness,
          static_stiffness(drawn.packing, Hypothesis::free_spin));
}

void check_derivatives(Table& table, Draw& draw, std::size_t /*sample*/) {
  PackingCase drawn = draw_packing(draw);
  if (drawn.packing.r < 0.01) { // E and G of uniform stress vanish there
    drawn.state.tangential_ratio = 0.5;
    drawn.packing.r = 0.5;
  }
  check_exponents(table, drawn, Hypothesis::uniform_strain, "uniform_strain_exponents",
                  granum::effective::uniform_strain_exponents);
  check_exponents(table, drawn, Hypothesis::free_spin, "free_spin_exponents",
                  granum::effective::free_spin_exponents);
  check_exponents(table, drawn, Hypothesis::uniform_stress, "uniform_stress_exponents",
                  granum::effective::uniform_stress_exponents);
}

void check_kinematic(Table& table, Draw& draw, std::size_t /*sample*/) { check_kinematic_case(table, draw); }

} // namespace accuracy
