// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/plan/plan.hpp"
#include <granum/contact/normal_law.hpp>

#include "path_run.hpp"

namespace granum::studies {

namespace {

/// Steps that freezing a state and solving its network cost, for 1,000 grains.
constexpr double frozen_point_steps = 1000;
/// Frozen states of a path: to a peak of eta about 1, and past it by axial strain.
constexpr double peak_eta = 1;

/// Time of a path over the mean of all four (measured): longer at lower stresses, and with more frozen states
/// up to a peak.
double share_of(stress::ShearPath path) {
  switch (path) {
  case stress::ShearPath::rtxc:
    return 1.5;
  case stress::ShearPath::txe:
    return 0.6;
  case stress::ShearPath::txc:
  case stress::ShearPath::rtxe:
    break;
  }
  return 0.95;
}

double waves(const Scene& scene) { return std::cbrt(static_cast<double>(scene.study.grains) / 1000); }

} // namespace

double packing_steps(const Scene& scene) {
  return preparation_work(scene) / static_cast<double>(scene.study.grains);
}

double isotropic_steps(const Scene& scene, contact::Shape contact, triaxial::Density density) {
  return specimen_work(scene, density, contact) / static_cast<double>(scene.study.grains);
}

/// The time to a strain follows from the inertial number, the time step from the stiffness of a contact at
/// the mean force; their quotient is the number of steps.
double shear_steps(const Scene& scene, contact::Shape contact, stress::ShearPath path) {
  const contact::NormalLaw contact_law = law(scene, contact);
  const double pressure = scene.study.pressures.back(), diameter = 2 * scene.grain.radius;
  const double rate = scene.shear.inertial_number / (diameter * std::sqrt(scene.grain.density / pressure));
  const double force = diameter * diameter * pressure; // about the mean
  const double mass = scene.grain.density * std::numbers::pi / 6 * diameter * diameter * diameter;
  constexpr double step_over_period = 0.5; // measured
  const double step = step_over_period * std::sqrt(mass / contact_law.stiffness_at_force(force));
  const double points =
      peak_eta / scene.shear.eta_step + scene.shear.largest_strain / scene.shear.strain_step;
  return share_of(path) *
         (scene.shear.largest_strain / (rate * step) + points * frozen_point_steps * waves(scene));
}

double experiment_steps(const Scene& scene) {
  double steps = 0;
  for (const contact::Shape contact : scene.study.contacts) {
    steps += packing_steps(scene);
    for (const triaxial::Density density : scene.study.densities) {
      steps += isotropic_steps(scene, contact, density);
      for (const stress::ShearPath path : scene.shear.paths)
        steps += shear_steps(scene, contact, path);
    }
  }
  return steps * static_cast<double>(scene.study.seeds);
}

} // namespace granum::studies
