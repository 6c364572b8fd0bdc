// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include <granum/verify/study.hpp>

namespace granum::verify::test {

/// One state of a specimen whose moduli follow G = 200 MPa (p / 100 kPa)^s, with every figure inside the
/// limits of the verdicts.
inline StateResult power_law_state(double s, double pressure) {
  StateResult state;
  state.pressure = state.pressure_by_work = state.pressure_by_contacts = pressure;
  state.void_ratio = 0.6;
  state.coordination_number = state.mechanical_coordination_number = 5.5;
  const double G = 200e6 * std::pow(pressure / 100e3, s);
  state.G_closed = 1.3 * G;
  state.K_closed = 1.2 * G;
  state.G_uniform_strain = 1.25 * G;
  state.K_uniform_strain = state.K_upper = 1.15 * G;
  state.G_network = state.G_hh_network = state.G_vh_network = G;
  state.K_network = 1.1 * G;
  state.K_lower = 0.9 * G;
  state.probes = Probes{G, G, G, 1e-6};
  return state;
}

inline SpecimenResult power_law_specimen(contact::Shape contact, triaxial::Density density,
                                         std::uint64_t seed, double s, const std::vector<double>& pressures) {
  SpecimenResult specimen{contact, density, seed, {}, {}};
  for (const double pressure : pressures)
    specimen.states.push_back(power_law_state(s, pressure));
  return specimen;
}

} // namespace granum::verify::test
