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

dem::State sticking(dem::State state) {
  if (state.walls && state.walls->friction_coefficient > 0)
    state.walls->friction_coefficient = std::numeric_limits<double>::infinity();
  return state;
}

double chosen_amplitude(const dem::Engine& engine, const dem::Material& material) {
  const double overlap = material.law.overlap(engine.figures().mean_normal_force);
  return 1e-4 * overlap / engine.diameter();
}

} // namespace

FrozenState freeze_in_place(const dem::State& state, const dem::Material& material, double force_tolerance) {
  dem::Engine engine(sticking(state), sticking(material));
  FrozenState frozen;
  frozen.report = dem::deform(engine, Mat3{}, 0, {.force_tolerance = force_tolerance, .max_steps = 40000});
  engine.rest();
  frozen.state = engine.state();
  if (state.walls)
    frozen.state.walls->friction_coefficient = state.walls->friction_coefficient;
  return frozen;
}

ProbeResult probe(const dem::State& state, const dem::Material& material, ShearMode mode,
                  const ProbeOptions& options) {
  require_non_negative("amplitude", options.amplitude);
  dem::Engine engine =
      options.sliding ? dem::Engine(state, material) : dem::Engine(sticking(state), sticking(material));
  dem::QuasistaticOptions relax;
  relax.force_tolerance = options.force_tolerance;
  relax.stress_tolerance = options.force_tolerance;
  relax.max_steps = options.max_steps;

  ProbeResult result;
  result.amplitude = options.amplitude > 0 ? options.amplitude : chosen_amplitude(engine, material);
  result.converged = true;
  const auto [stacked, moving] = plane(mode);
  const auto shear_stress = [&](const dem::QuasistaticReport& report) {
    result.converged = result.converged && report.converged();
    result.steps += report.steps;
    result.unbalanced_force_ratio = std::max(result.unbalanced_force_ratio, report.unbalanced_force_ratio);
    return -(report.stress(moving, stacked) + report.stress(stacked, moving)) / 2;
  };
  const double start = shear_stress(dem::deform(engine, Mat3{}, 0, relax));
  const Vec3 held = engine.figures().boundary_stress;
  const bool keep = options.loop_points > 0;
  if (keep)
    result.loop.push_back({0, 0});
  /// To a strain given in quarters of the cycle; returns the stress there.
  const auto leg = [&](int from, int to) {
    const std::size_t pieces = keep ? options.loop_points * static_cast<std::size_t>(std::abs(to - from)) : 1;
    const double piece = (to - from) * result.amplitude / static_cast<double>(pieces);
    Mat3 gradient;
    gradient(moving, stacked) = piece;
    double stress = 0;
    for (std::size_t k = 1; k <= pieces; ++k) {
      stress = shear_stress(options.hold_normal_stress
                                ? dem::shear_at_stress(engine, gradient, options.ramp_steps, held, relax)
                                : dem::deform(engine, gradient, options.ramp_steps, relax));
      if (keep)
        result.loop.push_back({from * result.amplitude + static_cast<double>(k) * piece, stress - start});
    }
    return stress;
  };
  const double up = leg(0, 1);
  const double down = leg(1, -1);
  const double end = leg(-1, 0);
  if (keep)
    leg(0, 1);
  result.shear_modulus = (up - down) / (2 * result.amplitude);
  result.opening = std::abs(end - start) / std::abs(up - down);
  return result;
}

} // namespace granum::triaxial
