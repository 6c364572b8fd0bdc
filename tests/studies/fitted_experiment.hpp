// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "studies/reproduce/experiment.hpp"

/// An experiment made up by hand, whose fits are known: G_vh = C p_a f(e) (s_h/p_a)^m (s_v/p_a)^n and
/// G_hh = G_vh with s_h for both.
namespace granum::studies {

struct Synthetic {
  double C = 700, m = 0.21, n = 0.14;
  double void_ratio = 0.56;
  double coordination_number = 5.8;
  double peak_eta = 1.05; ///< in compression; -0.75 of it in extension
};

inline StateRecord synthetic_point(const Synthetic& s, double stress_v, double stress_h,
                                   double axial_strain) {
  StateRecord point;
  point.at.stress = point.stress = {.v = stress_v, .h = stress_h};
  point.at.axial_strain = axial_strain;
  point.void_ratio = point.interior_void_ratio = s.void_ratio;
  point.micro = {.coordination_number = s.coordination_number,
                 .mechanical_coordination_number = s.coordination_number + 0.1,
                 .rattler_fraction = 0.02,
                 .fabric_anisotropy = 0.01,
                 .fabric_anisotropy_error = 0.02,
                 .sliding_fraction = 0};
  point.coordination_number_all = s.coordination_number;
  point.coordination_error = 0.05;
  constexpr double p_a = 100e3;
  const double factor = s.C * p_a * (2.17 - s.void_ratio) * (2.17 - s.void_ratio) / (1 + s.void_ratio);
  const double G_vh = factor * std::pow(stress_h / p_a, s.m) * std::pow(stress_v / p_a, s.n);
  const double G_hh = factor * std::pow(stress_h / p_a, s.m + s.n);
  for (const auto& [index, value] :
       {std::pair{std::size_t{21}, G_vh}, {std::size_t{28}, G_vh}, {std::size_t{35}, G_hh}}) {
    point.network[index] = value;
    point.affine[index] = 1.4 * value;
  }
  point.probes = Probes{.G_hh = G_hh, .G_hv = G_vh, .G_vh = G_vh, .amplitude = 1e-6};
  return point;
}

inline ExperimentSpecimen synthetic_specimen(const Scene& scene, contact::Shape contact,
                                             triaxial::Density density, std::uint64_t seed,
                                             const Synthetic& s = {}) {
  ExperimentSpecimen specimen{contact, density, seed, {}, {}};
  PathRun iso;
  for (const double pressure : scene.study.pressures)
    iso.points.push_back(synthetic_point(s, pressure, pressure, 0));
  specimen.runs.push_back(iso);
  for (const stress::ShearPath path : scene.shear.paths) {
    PathRun run;
    run.path = path;
    const double sense = stress::is_compression(path) ? 1 : -1;
    const double peak = sense > 0 ? s.peak_eta : 0.75 * s.peak_eta;
    const double strain_sense = path == stress::ShearPath::txc || path == stress::ShearPath::rtxc ? 1 : -1;
    double strain = 0;
    for (int k = 1; scene.shear.eta_step * k <= peak; ++k) {
      strain = strain_sense * 1e-4 * k;
      const stress::AxialStress stress =
          stress::stress_on_path(path, scene.study.pressures.back(), sense * scene.shear.eta_step * k);
      run.points.push_back(synthetic_point(s, stress.v, stress.h, strain));
      run.curve.push_back(run.points.back().at);
    }
    run.peak = run.points.back().at;
    run.peak.stress = stress::stress_on_path(path, scene.study.pressures.back(), sense * peak);
    // Past the peak: contacts lost, the rest turned towards the larger stress.
    StateRecord last = run.points.back();
    last.at.axial_strain = strain_sense * scene.shear.largest_strain;
    last.micro.coordination_number *= 0.75;
    last.micro.fabric_anisotropy = sense * 0.4;
    run.points.push_back(last);
    run.curve.push_back(last.at);
    specimen.runs.push_back(run);
  }
  return specimen;
}

inline Experiment synthetic_experiment(const Scene& scene = {}, const Synthetic& s = {}) {
  Experiment experiment{.scene = scene, .specimens = {}};
  for (const contact::Shape contact : scene.study.contacts)
    for (const triaxial::Density density : scene.study.densities)
      for (std::size_t k = 0; k < scene.study.seeds; ++k)
        experiment.specimens.push_back(
            synthetic_specimen(scene, contact, density, scene.study.first_seed + k, s));
  return experiment;
}

} // namespace granum::studies
