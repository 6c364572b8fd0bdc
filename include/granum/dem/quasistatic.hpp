// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/core/stop_request.hpp>
#include <granum/core/vec3.hpp>
#include <granum/dem/engine.hpp>

/// Runs of the engine that end in equilibrium, with the figures that say how quasi-static they were.
namespace granum::dem {

struct QuasistaticOptions {
  double inertial_number =
      5e-4; ///< largest strain rate times d sqrt(density/p), p the target's mean stress [1]
  double force_tolerance = 1e-6;  ///< mean residual force on a grain / mean contact force [1]
  double stress_tolerance = 1e-6; ///< of each servo-controlled normal stress, relative to the mean target [1]
  std::size_t max_steps = 400000;
  /// Only of deform. Stress that no longer matters [Pa]: a run ends as `settled` once no component of the
  /// stress changes by more than this beyond what it changed by in the spell of settle_steps before, twice in
  /// turn. What is left is rest, or a steady creep. 0: only forces are asked.
  double settled_stress = 0;
  std::size_t settle_steps = 1000;
  double time_step_fraction = default_time_step_fraction; ///< of the stability limit, in (0, 1]
  StopRequest stop_requested = {}; ///< true ends the run early: the report then says `stopped`
};

enum class Outcome {
  converged,
  settled,    ///< the stress is steady although forces are beyond their tolerance: a rattler moves
  step_limit, ///< tolerances not reached within max_steps
  unstable,   ///< a velocity or a stress was no longer finite
  stopped,    ///< stop_requested said so
};

struct [[nodiscard]] QuasistaticReport {
  Outcome outcome = Outcome::step_limit;
  std::size_t steps = 0;
  double unbalanced_force_ratio = 0;  ///< at the end [1]
  double largest_inertial_number = 0; ///< over the run [1]
  Mat3 last_stress;                   ///< at the end, whatever the outcome [Pa]

  [[nodiscard]] bool converged() const { return outcome == Outcome::converged; }
  /// Stress of the state that the run has come to [Pa].
  /// \throws   NotConverged unless the outcome is converged or settled
  [[nodiscard]] const Mat3& stress() const;
};

/// Brings the normal stresses at the boundaries (StepFigures::boundary_stress) to their targets, each by a
/// servo on its cell edge, and the grains to rest.
/// Assumes   an orthogonal cell along the axes.
/// \param    target  normal stresses [Pa], each > 0
/// \throws   InvalidArgument for a target or option that is not positive
/// Checked by tests/dem/test_quasistatic.cpp
QuasistaticReport equilibrate(Engine& engine, const Vec3& target, const QuasistaticOptions& options = {});

/// Shears the cell by a small strain (x becomes (1 + strain) x) in ramp_steps steps while the servos hold the
/// normal stresses at the boundaries, and goes on until these have their targets and the grains rest.
/// Assumes   a strain without diagonal: lengths are the servos' business.
/// \param    target  normal stresses [Pa], each > 0
/// \throws   InvalidArgument for a target or option that is not positive
/// Checked by tests/dem/test_quasistatic.cpp
QuasistaticReport shear_at_stress(Engine& engine, const Mat3& strain, std::size_t ramp_steps,
                                  const Vec3& target, const QuasistaticOptions& options = {});

/// Deforms the cell by a small strain (x becomes (1 + strain) x) in ramp_steps steps, and lets the grains
/// come to rest at fixed cell. Strain is here the displacement gradient, extension positive.
/// \throws   InvalidArgument for an option that is not positive, or a settled_stress that is negative
/// Checked by tests/dem/test_quasistatic.cpp
QuasistaticReport deform(Engine& engine, const Mat3& strain, std::size_t ramp_steps,
                         const QuasistaticOptions& options = {});

} // namespace granum::dem
