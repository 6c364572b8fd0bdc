// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/probe.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <granum/core/check.hpp>

namespace granum::triaxial {

namespace {

struct Plane {
  int stacked;
  int moving;
};

Plane plane(ShearMode mode) {
  switch (mode) {
  case ShearMode::hh:
    return {0, 1};
  case ShearMode::hv:
    return {0, 2};
  case ShearMode::vh:
    break;
  }
  return {2, 0};
}

dem::Material sticking(dem::Material material) {
  if (material.tangential())
    material.friction_coefficient = std::numeric_limits<double>::infinity();
  return material;
}

double chosen_amplitude(const dem::Engine& engine, const dem::Material& material) {
  const double overlap = material.law.overlap(engine.figures().mean_normal_force);
  return 1e-4 * overlap / engine.diameter();
}

} // namespace

FrozenState freeze_in_place(const dem::State& state, const dem::Material& material, double force_tolerance) {
  dem::Engine engine(state, sticking(material));
  FrozenState frozen;
  frozen.report = dem::deform(engine, Mat3{}, 0, {.force_tolerance = force_tolerance, .max_steps = 40000});
  engine.rest();
  frozen.state = engine.state();
  return frozen;
}

ProbeResult probe(const dem::State& state, const dem::Material& material, ShearMode mode,
                  const ProbeOptions& options) {
  require_non_negative("amplitude", options.amplitude);
  dem::Engine engine(state, options.sliding ? material : sticking(material));
  dem::QuasistaticOptions relax;
  relax.force_tolerance = options.force_tolerance;
  relax.max_steps = options.max_steps;

  ProbeResult result;
  result.amplitude = options.amplitude > 0 ? options.amplitude : chosen_amplitude(engine, material);
  result.converged = true;
  const auto [stacked, moving] = plane(mode);
  const auto leg = [&](double strain) {
    Mat3 gradient;
    gradient(moving, stacked) = strain;
    const dem::QuasistaticReport report =
        dem::deform(engine, gradient, strain == 0 ? 0 : options.ramp_steps, relax);
    result.converged = result.converged && report.converged();
    result.steps += report.steps;
    result.unbalanced_force_ratio = std::max(result.unbalanced_force_ratio, report.unbalanced_force_ratio);
    return -(report.stress(moving, stacked) + report.stress(stacked, moving)) / 2;
  };
  const double start = leg(0);
  const double up = leg(result.amplitude);
  const double down = leg(-2 * result.amplitude);
  const double end = leg(result.amplitude);
  result.shear_modulus = (up - down) / (2 * result.amplitude);
  result.opening = std::abs(end - start) / std::abs(up - down);
  return result;
}

} // namespace granum::triaxial
