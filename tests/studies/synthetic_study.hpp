// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "studies/verify/study.hpp"

namespace granum::studies::test {

/// An isotropic solid of these moduli [Pa].
inline elastic::VoigtStiffness solid(double K, double G) {
  return elastic::voigt(elastic::Isotropic::from_bulk_and_shear(K, G));
}

/// Gives the network of a state these moduli [Pa]; what it has under uniform strain and its bounds stay.
inline void set_network(CompressedState& state, double K, double G) {
  network::Response& response = state.packing.network.value().response;
  response = network::Response(response.affine(), solid(K, G), response.report());
}

/// Gives it these moduli under uniform strain [Pa].
inline void set_uniform_strain(CompressedState& state, double K, double G) {
  network::Response& response = state.packing.network.value().response;
  response = network::Response(solid(K, G), response.last_iterate(), response.report());
}

/// Gives all shear moduli of its network such force terms [Pa].
inline void set_force_terms(CompressedState& state, double geometric, double shedding) {
  network::Response& response = state.packing.network.value().response;
  network::ForceTerms terms;
  for (int plane = 3; plane < 6; ++plane) {
    terms.geometric.matrix(plane, plane) = geometric;
    terms.shedding.matrix(plane, plane) = shedding;
  }
  response = network::Response(response.affine(), response.last_iterate(), response.report(), terms);
}

/// One state of a specimen whose moduli follow G = 200 MPa (p / 100 kPa)^s, with every figure inside the
/// limits of the verdicts.
inline CompressedState power_law_state(double s, double pressure) {
  CompressedState state;
  state.pressure = pressure;
  state.packing.pressure_by_work = pressure;
  state.packing.stress =
      packing::ContactStress{.symmetric = Mat3::diagonal(pressure, pressure, pressure), .tensor = {}};
  state.packing.void_ratio = 0.6;
  state.packing.counts.coordination_number = state.packing.counts.mechanical.coordination_number = 5.5;
  const double G = 200e6 * std::pow(pressure / 100e3, s);
  state.G_closed = 1.3 * G;
  state.K_closed = 1.2 * G;
  state.packing.network = analysis::Network{.response = {solid(1.15 * G, 1.25 * G), solid(1.1 * G, G), {}},
                                            .bulk_bounds = {.lower = 0.9 * G, .upper = 1.15 * G}};
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

} // namespace granum::studies::test
