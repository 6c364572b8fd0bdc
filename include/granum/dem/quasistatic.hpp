// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/contact/normal_law.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/vec3.hpp>
#include <granum/dem/engine.hpp>
#include <granum/dem/specimen.hpp>

/// Specimens at rest: runs of the engine that end in equilibrium, with measures of how quasi-static they
/// were, and minima of the energy.
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

struct MinimiseOptions {
  double force_tolerance = 1e-9;    ///< mean residual force on a grain / mean contact force [1]
  double pressure_tolerance = 1e-9; ///< relative, where a pressure is prescribed [1]
  double overlap_tolerance =
      1e-7; ///< largest overlap, over the radius of a grain of size 1, that is neglected [1]
  std::size_t max_steps = 200000;
  StopRequest stop_requested = {}; ///< true ends the relaxation early; the report has `stopped` then
};

/// Result of a relaxation. Its state is the last good one in any case.
struct [[nodiscard]] RelaxReport {
  bool converged = false;
  bool stopped = false; ///< by stop_requested
  std::size_t steps = 0;
  double unbalanced_force_ratio =
      0;                    ///< mean residual force on a grain / mean contact force; 0 without contacts
  double last_pressure = 0; ///< mean contact stress at the end, converged or not [Pa]

  /// Mean contact stress of the relaxed state [Pa].
  /// \throws   NotConverged unless converged
  [[nodiscard]] double pressure() const;
};

/// Minimises the elastic energy of frictionless spheres in a fixed cell by FIRE.
/// [Bitzek2006]
/// Assumes   no friction, also at walls. Rotations and contact histories are cleared in the state.
/// Converged when forces are in balance, or when no overlap exceeds the tolerance (below jamming).
/// \throws   InvalidArgument for a state that is empty or too small for its cell
/// Checked by tests/dem/test_minimise.cpp
RelaxReport minimise_energy(Specimen& state, const contact::NormalLaw& law,
                            const MinimiseOptions& options = {});

/// Minimises the enthalpy (energy + p V) over the positions and the size of the cell.
/// \param    pressure  p > 0 [Pa]
RelaxReport minimise_enthalpy(Specimen& state, const contact::NormalLaw& law, double pressure,
                              const MinimiseOptions& options = {});

} // namespace granum::dem
