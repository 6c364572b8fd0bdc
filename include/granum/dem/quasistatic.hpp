// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/core/stop.hpp>
#include <granum/core/vec3.hpp>
#include <granum/dem/engine.hpp>

/// Runs of the engine that end in equilibrium, with measures of how quasi-static they were.
namespace granum::dem {

struct QuasistaticOptions {
  double inertial_number =
      5e-4; ///< largest strain rate times d sqrt(density/p), p the target's mean stress [1]
  double force_tolerance = 1e-6;  ///< mean residual force on a grain / mean contact force [1]
  double stress_tolerance = 1e-6; ///< of each servo-controlled normal stress, relative to the mean target [1]
  std::size_t max_steps = 400000;
  /// For deform only. Negligible change of stress [Pa]: a run ends as `settled` when, twice in succession,
  /// the change of no stress component over settle_steps differs by more than this from the change over the
  /// settle_steps before. The specimen is then at rest, or creeps steadily. 0: only forces are checked.
  double settled_stress = 0;
  std::size_t settle_steps = 1000;
  double time_step_fraction = default_time_step_fraction; ///< of the stability limit, in (0, 1]
  StopRequest stop_requested = {}; ///< true ends the run early, with the outcome `stopped`
};

enum class Outcome {
  converged,
  settled,    ///< steady stress, although forces exceed their tolerance: a rattler moves
  step_limit, ///< tolerances not reached within max_steps
  unstable,   ///< a velocity or a stress was no longer finite
  stopped,    ///< by stop_requested
};

struct [[nodiscard]] QuasistaticReport {
  Outcome outcome = Outcome::step_limit;
  std::size_t steps = 0;
  double unbalanced_force_ratio = 0;  ///< at the end [1]
  double largest_inertial_number = 0; ///< over the run [1]
  Mat3 last_stress;                   ///< at the end, for any outcome [Pa]

  [[nodiscard]] bool converged() const { return outcome == Outcome::converged; }
  /// Stress at the end of the run [Pa].
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

/// Shears the cell by a small strain (x becomes (1 + strain) x) in ramp_steps steps while servos control the
/// normal stresses at the boundaries, and continues until these have their targets and the grains are at
/// rest.
/// Assumes   a strain without diagonal: the servos control the lengths.
/// \param    target  normal stresses [Pa], each > 0
/// \throws   InvalidArgument for a target or option that is not positive
/// Checked by tests/dem/test_quasistatic.cpp
QuasistaticReport shear_at_stress(Engine& engine, const Mat3& strain, std::size_t ramp_steps,
                                  const Vec3& target, const QuasistaticOptions& options = {});

/// Deforms the cell by a small strain (x becomes (1 + strain) x) in ramp_steps steps, and brings the grains
/// to rest at fixed cell. Here strain is the displacement gradient, extension positive.
/// \throws   InvalidArgument for an option that is not positive, or a settled_stress that is negative
/// Checked by tests/dem/test_quasistatic.cpp
QuasistaticReport deform(Engine& engine, const Mat3& strain, std::size_t ramp_steps,
                         const QuasistaticOptions& options = {});

} // namespace granum::dem
