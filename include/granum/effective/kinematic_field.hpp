// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>

/// Contact forces of a uniform strain, the counterpart of the static hypothesis.
namespace granum::effective {

/// Forces of contacts that have followed a mean strain on a proportional path from zero, without spin and
/// without slip: d = l (strain_h sin^2 gamma + strain_v cos^2 gamma), f_n = c d^(1+1/alpha), and since k_t
/// grows along the path, f_t = alpha/(1+alpha) k_t d_t with d_t = l (strain_h - strain_v) sin gamma cos
/// gamma. Only for contact laws of the power family.
struct KinematicForceField {
  contact::PowerLaw law;
  double tangential_ratio = 0; ///< k_t/k_n
  double branch_length = 0;    ///< <l^2>/<l>, of equal grains 2 R [m]
  double strain_v = 0;         ///< compression positive
  double strain_h = 0;         ///< in both horizontal directions

  /// d at n3 = cos gamma [m]; n3 in [-1, 1], not checked.
  [[nodiscard]] double overlap(double n3) const;
  /// f_n at n3 [N].
  [[nodiscard]] double normal_force(double n3) const { return law.force(overlap(n3)); }
  /// f_t along growing gamma at n3 >= 0 [N].
  [[nodiscard]] double tangential_force(double n3) const;
};

/// The field whose mean stress sum f_i n_j l/V equals that of the state; zero strain if the state has no
/// stress. Both strains grow in proportion, as in [NorrisJohnson1997] for spheres without fabric. The
/// tangential forces of [JenkinsStrack1993] are linear in d_t and lack the factor alpha/(1+alpha).
/// Assumes   all contacts of the fabric carry force: C_n and a were determined in this state, so a strain
///           that opens some contacts contradicts it. This limits the stress ratio: hardly at k_t = k_n; for
///           spheres at k_t = 0 and a = 0 to stress_v/stress_h in about (2/5, 4).
/// \throws   InvalidArgument as require_valid, for a law of another kind, if C_n = 0, or if the strains of
///           all-compressed directions (ratio strain_v/strain_h within [1e-4, 1e4]) cannot give the stress
///           ratio; the message states the possible range
/// Accuracy  relative 1e-12 for the strains.  Checked by tests/effective/test_kinematic_field.cpp
[[nodiscard]] KinematicForceField kinematic_force_field(const State& state);

/// Stiffness under uniform strain with k_n(gamma) of the kinematic field: rung 2 with forces from the same
/// hypothesis as the moduli. It is (1+alpha)/alpha times the secant stiffness that links the field's stress
/// to its strain. Unloaded, without contacts and for flat punches as uniform_strain.
/// \throws   InvalidArgument as kinematic_force_field, but not for C_n = 0
/// Accuracy  relative 1e-11.  Checked by tests/effective/test_kinematic_field.cpp
[[nodiscard]] Estimate uniform_strain_kinematic(const State& state);

/// Stiffness under the static hypothesis with the same k_n(gamma). It is not self-consistent; it serves to
/// show which part of the difference between uniform_strain and uniform_stress is due to the forces.
/// \throws   InvalidArgument as kinematic_force_field, but not for C_n = 0
/// Accuracy  relative 1e-11.  Checked by tests/effective/test_kinematic_field.cpp
[[nodiscard]] Estimate uniform_stress_kinematic(const State& state);

} // namespace granum::effective
