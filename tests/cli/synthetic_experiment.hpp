// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

#include "studies/reproduce/experiment.hpp"
#include <granum/elastic/transverse_isotropic.hpp>

/// An experiment whose numbers follow from formulas, so that tests can say what its figures must show.
namespace synthetic {

using namespace granum;
using namespace granum::studies;

/// Stiffness of an isotropic solid with that shear modulus, as rows of its Voigt matrix [Pa].
inline elastic::TransverselyIsotropic solid(double G) { return {3 * G, 3 * G, G, G, G}; }

inline std::array<double, 36> rows(const elastic::TransverselyIsotropic& c) {
  const elastic::VoigtStiffness full = voigt(c);
  std::array<double, 36> out{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out[static_cast<std::size_t>(6 * i + j)] = full.matrix(i, j);
  return out;
}

/// A frozen state: G = 100 MPa sqrt(p'/100 kPa), half of uniform strain.
inline StateRecord point(const stress::AxialStress& stress) {
  StateRecord out;
  const double eta = stress.ratio(), G = 1e8 * std::sqrt(stress.mean() / 1e5);
  out.at.stress = out.stress = stress;
  out.at.axial_strain = 1e-3 * eta;
  out.void_ratio = 0.56;
  out.micro.coordination_number = 6 - 0.5 * std::abs(eta);
  out.micro.mechanical_coordination_number = 6.1 - 0.5 * std::abs(eta);
  out.micro.fabric_anisotropy = 0.1 * eta;
  out.micro.fabric_anisotropy_error = 0.02;
  out.coordination_number_all = out.micro.coordination_number;
  out.coordination_error = 0.05;
  out.fabric = Mat3::diagonal(0.3, 0.3, 0.4);
  for (std::size_t k = 0; k < polar_bins; ++k)
    out.contacts += out.polar_counts[k] = static_cast<std::uint32_t>(3 + 2 * k);
  out.network = rows(solid(G));
  out.affine = rows(solid(2 * G));
  out.closed =
      ClosedForms{.uniform_strain = solid(2 * G), .uniform_stress = solid(G), .relaxed = solid(1.1 * G)};
  return out;
}

inline PathRun iso_run(const Scene& scene) {
  PathRun run;
  for (const double p : scene.study.pressures)
    run.points.push_back(point({p, p}));
  return run;
}

/// |eta| rises to 0.8 in eight states and falls back in two more.
inline PathRun shear_run(const Scene& scene, stress::ShearPath path) {
  PathRun run;
  run.path = path;
  const double sense = stress::is_compression(path) ? 1 : -1;
  for (const double eta : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.75, 0.78}) {
    run.points.push_back(point(stress::stress_on_path(path, scene.study.pressures.back(), sense * eta)));
    triaxial::PathPoint& at = run.points.back().at;
    at.step = 100 * run.points.size();
    at.axial_strain = sense * 1e-3 * static_cast<double>(run.points.size());
    at.volumetric_strain = -at.axial_strain / 2;
    run.curve.push_back(at);
  }
  const double G = run.points[4].G_vh();
  run.points[4].probes = Probes{.G_hh = 1.01 * G, .G_hv = 1.02 * G, .G_vh = 1.03 * G, .amplitude = 1e-7};
  run.peak = run.points[7].at;
  if (path == stress::ShearPath::txc)
    for (const double eta : {0.0, 0.5})
      run.loops.push_back(
          {.eta = eta, .amplitude = 1e-5, .points = {{0, 0}, {1e-5, 2e3}, {-1e-5, -2e3}, {1e-5, 2e3}}});
  return run;
}

/// Eight grains at the corners of a smaller cube in a cell of 4 mm, one of them a cell's length away.
inline dem::Specimen state() {
  dem::Specimen out;
  out.cell = Mat3::diagonal(4e-3, 4e-3, 4e-3);
  out.radius = 0.5e-3;
  for (int k = 0; k < 8; ++k)
    out.position.push_back({1e-3 + 2e-3 * (k & 1), 1e-3 + 2e-3 * ((k >> 1) & 1), 1e-3 + 2e-3 * (k >> 2)});
  out.position[3].x += 4e-3;
  return out;
}

inline Experiment experiment() {
  Experiment out;
  out.scene.study.pressures = {25e3, 50e3, 75e3, 100e3};
  for (const contact::Shape contact : out.scene.study.contacts)
    for (const triaxial::Density density : out.scene.study.densities) {
      ExperimentSpecimen specimen{
          .contact = contact, .density = density, .seed = 1, .end_of_iso = state(), .runs = {}};
      specimen.runs.push_back(iso_run(out.scene));
      for (const stress::ShearPath path : out.scene.shear.paths)
        specimen.runs.push_back(shear_run(out.scene, path));
      out.specimens.push_back(std::move(specimen));
    }
  return out;
}

} // namespace synthetic
