// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/probe.hpp>

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

double chosen_amplitude(const dem::Engine& engine, const dem::Material& material) {
  const double overlap = material.law.overlap(engine.figures().mean_normal_force);
  return 0.005 * overlap / engine.diameter();
}

} // namespace

ProbeResult probe(const dem::State& state, const dem::Material& material, ShearMode mode,
                  const ProbeOptions& options) {
  require_non_negative("amplitude", options.amplitude);
  dem::Material probed = material;
  if (!options.sliding && probed.tangential())
    probed.friction_coefficient = std::numeric_limits<double>::infinity();
  dem::Engine engine(state, probed);
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
