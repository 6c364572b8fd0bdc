// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms in a, k_n and k_t as sums of the moments of E(gamma; a); [ChangLiao1994] for uniform stress.
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>

#include "harness.hpp"
#include "packing.hpp"

namespace accuracy {

namespace {

using granum::effective::State;
using granum::effective::UniformContacts;

void check_uniform_contacts(Table& table, Draw& draw) {
  const double a = draw.anisotropy(), r = draw.ratio();
  const UniformContacts contacts{.prefactor = draw.log_uniform(1, 1e9),
                                 .normal_stiffness = draw.log_uniform(1e-3, 1e9),
                                 .tangential_stiffness = 0,
                                 .fabric_anisotropy = a};
  UniformContacts sheared = contacts;
  sheared.tangential_stiffness = r * contacts.normal_stiffness;
  const Real scale = Real(contacts.prefactor) * Real(contacts.normal_stiffness);
  const Real ratio = Real(sheared.tangential_stiffness) / Real(contacts.normal_stiffness);
  const Moments m = fabric_moments(Real(a));
  const std::string at = said({{"a", a}, {"r", r}});
  const std::string domain = "a in [-1, 1], k_t/k_n 0 to 2";
  compare(table, "uniform_strain_stiffness", domain, closed_form, uniform_strain_stiffness(sheared),
          strain_stiffness(scale, ratio, m), at);
  compare(table, "free_spin_stiffness", domain, closed_form, free_spin_stiffness(sheared),
          free_spin_stiffness(scale, ratio, m), at);
  if (r > 0)
    compare(table, "uniform_stress_stiffness", domain, closed_form, uniform_stress_stiffness(sheared),
            stress_stiffness(scale, ratio, m, m), at);
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
  const Real C = *state.coordination_number, phi = 1 / (1 + Real(state.void_ratio));
  const Real shear = Real(grain.shear_modulus) / (1 - Real(nu));
  // K^3 = (C phi G/(1-nu))^2 p/(18 pi^2), without force and radius.                             [Walton1987]
  const Real K = cbrt(C * C * phi * phi * shear * shear * p / (18 * pi() * pi()));
  const Real G = K * 3 * (2 + 3 * Real(state.tangential_ratio)) / 10;
  const std::string at = said({{"p", p},
                               {"R", R},
                               {"e", state.void_ratio},
                               {"C_n", *state.coordination_number},
                               {"r", state.tangential_ratio},
                               {"G", grain.shear_modulus},
                               {"nu", nu}});
  const std::string domain = "spheres, p 1e-300 to 1e12 Pa";
  const auto c = uniform_strain(state).stiffness;
  table.take("uniform_strain isotropic K", domain, stiffness_form, c.bulk_modulus(), K, at);
  table.take("uniform_strain isotropic G", domain, stiffness_form, c.G_vh(), G, at);
  const Real P = 3 * C * phi / (2 * pi() * Real(R));
  table.take("prefactor", "as above", closed_form, prefactor(state), P, at);
  if (p * R * R > 1e-290)
    table.take("mean_contact_force", "4 pi R^2 p/C_n above 1e-290 N", closed_form, mean_contact_force(state),
               6 * Real(p) * Real(R) / P, at);
}

} // namespace

void check_uniform_field(Table& table, std::size_t samples) {
  Draw draw(4);
  for (std::size_t k = 0; k < samples; ++k) {
    check_uniform_contacts(table, draw);
    check_isotropic_state(table, draw);
  }
}

void check_directional(Table& table, std::size_t samples) {
  Draw draw(5);
  const std::string domain = "forces 1 to 1e4 apart, a in [-1, 1]";
  for (std::size_t k = 0; k < samples; ++k) {
    const granum::contact::GrainMaterial grain{30e9, 0.15};
    const double alpha = draw.uniform_or(1, 8, {1.0, 2.0});
    const double p = draw.log_uniform(1, 1e7);
    const double spread = draw.log_uniform(1e-4, 1e4);
    const double a = draw.anisotropy();
    const Moments fabric = fabric_moments(Real(a));
    const Real F33 = fabric.m2, F11 = (1 - F33) / 2;
    const State state{.law = granum::contact::PowerLaw::general(grain, alpha, 1000),
                      .tangential_ratio = draw.uniform_or(0.01, 2, {1.0}),
                      .radius = 5e-4,
                      .void_ratio = 0.6,
                      .coordination_number = 5,
                      .fabric_anisotropy = a,
                      .stress_v = p,
                      .stress_h = p / spread * static_cast<double>(F11 / F33) * 1.0001};
    const double ratio = spread > 1 ? spread : 1 / spread;
    if (ratio > 0.999e4)
      continue;
    const Real P =
        3 * Real(*state.coordination_number) / (2 * pi() * Real(state.radius) * (1 + Real(state.void_ratio)));
    const Real horizontal = 2 * Real(state.radius) / P * Real(state.stress_h) / F11;
    const Real vertical = 2 * Real(state.radius) / P * Real(state.stress_v) / F33;
    const Real b = 1 / (1 + Real(alpha));
    const Real k_ref =
        (1 + 1 / Real(alpha)) * pow(Real(state.law.power_law()->coefficient()), 1 - b) * pow(vertical, b);
    const Real spread_of_forces = horizontal / vertical;
    const std::string at =
        said({{"alpha", alpha}, {"a", a}, {"stress_v", state.stress_v}, {"stress_h", state.stress_h}});
    const Real r = state.tangential_ratio;
    compare(table, "uniform_strain directional", domain, quadrature, uniform_strain(state).stiffness,
            strain_stiffness(P * k_ref, r, weighted_moments(Real(a), spread_of_forces, b)), at);
    compare(table, "uniform_stress directional", domain, quadrature, uniform_stress(state).stiffness,
            stress_stiffness(P * k_ref, r, fabric, weighted_moments(Real(a), spread_of_forces, -b)), at);
  }
}

} // namespace accuracy
