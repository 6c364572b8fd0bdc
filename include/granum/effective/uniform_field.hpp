// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/error.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

namespace granum::effective {

/// Contacts of equal stiffness in all directions.
struct UniformContacts {
  double prefactor = State::unset;            ///< P = N_c <l^2>/V > 0 [1/m]
  double normal_stiffness = State::unset;     ///< k_n >= 0 [N/m]
  double tangential_stiffness = State::unset; ///< k_t in [0, 100 k_n] [N/m]
  double fabric_anisotropy = 0;               ///< a in (-7/3, 7/5)
  /// <l>^2/<l^2> in (0, 1]: P of uniform stress over that of uniform strain; of several materials times the
  /// harmonic mean of their stiffnesses over the mean
  double branch_evenness = 1;
};

/// A stiffness and its validity notes.
struct Estimate {
  elastic::TransverselyIsotropic stiffness;
  Validity validity;
};

/// Stiffness if every contact follows the mean strain and no grain spins; all contacts equally stiff:
/// C_ijkl = P <(k_n-k_t) n_i n_j n_k n_l
///             + k_t/4 (n_i n_k d_jl + n_i n_l d_jk + n_j n_k d_il + n_j n_l d_ik)>,
/// an upper bound of the true stiffness.                                             [Walton1987; Chang1995]
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  8 ulp (C12 and C13 of the larger C11 and C33).
/// Checked by validation/accuracy, tests/effective/test_uniform_field.cpp
[[nodiscard]] elastic::TransverselyIsotropic uniform_strain_stiffness(const UniformContacts& contacts);

/// The same if all grains share one spin, the one of least energy: a tighter upper bound. In a plane ij
///   C_ijij = P [<(k_n-k_t) n_i^2 n_j^2> + A_i A_j/(A_i+A_j)],  A_i = <k_t n_i^2>,
/// where uniform strain has (A_i+A_j)/4 for the last term. Only C44 differs, and only if A_1 != A_3 because
/// of fabric or of a stiffness that depends on direction.
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  8 ulp (C12 and C13 of the larger C11 and C33).
/// Checked by validation/accuracy, tests/effective/test_free_spin.cpp
[[nodiscard]] elastic::TransverselyIsotropic free_spin_stiffness(const UniformContacts& contacts);

/// Stiffness if the contact forces are df = V/(N_c <l>) dstress F^-1 n, for any length of the branch,
/// all contacts equally stiff: from the complementary energy (1/2V) sum (df_n^2/k_n + df_t^2/k_t). Its
/// shear moduli vanish with k_t. The sources call it the lower estimate. It is no lower bound, because its
/// forces do not balance on each grain.
/// [ChangLiao1994] for isotropic fabric, [Chang1995] with fabric; [YimsiriSoga2000].
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  8 ulp (C12 and C13 of the larger C11 and C33). G_hh, E_v and E_h, differences of the five
///           constants, vanish with r = k_t/k_n and lose digits on the way: relative 1e-15 (1 + 1/r).
/// Checked by validation/accuracy, tests/effective/test_uniform_field.cpp
[[nodiscard]] elastic::TransverselyIsotropic uniform_stress_stiffness(const UniformContacts& contacts);

/// The contacts of a state, all with the stiffness at the mean force: rungs 0 and 1 of the ladder.
/// uniform_strain and uniform_stress use k_n(f_n(gamma)) instead. The two are equal only where the static
/// forces do not depend on direction (a = 0 and stress_v = stress_h) or the law is linear.
/// \throws   InvalidArgument as require_valid(State), and if C_n = 0
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_uniform_field.cpp
[[nodiscard]] UniformContacts uniform_contacts(const State& state);

/// Stiffness under uniform strain with k_n(gamma) = k_n(f_n(gamma)) of the static force field and
/// k_t = tangential_ratio k_n. Fabric alone makes the forces depend on direction: with a != 0, contacts in
/// sparse directions carry more force, even at stress_v = stress_h. Unloaded (both stresses 0): exactly 0, or
/// the constant of a flat punch. Without contacts (C_n = 0): 0.                        [Chung2014; Chang1995]
/// Assumes   grains do not spin on average; C_n and a were determined in this state.
/// \throws   InvalidArgument as require_valid(State)
/// Accuracy  relative 1e-12.  Checked by tests/effective/test_directional.cpp
[[nodiscard]] Estimate uniform_strain(const State& state);

/// The same with a free mean spin (see free_spin_stiffness): nowhere stiffer than uniform_strain.
/// \throws   InvalidArgument as require_valid(State)
/// Accuracy  relative 1e-12.  Checked by tests/effective/test_free_spin.cpp
[[nodiscard]] Estimate free_spin(const State& state);

/// Stiffness under the static hypothesis with the same k_n(f_n(gamma)); see uniform_strain and
/// uniform_stress_stiffness. Adds a note if k_t = 0, where the shear moduli vanish by construction.
/// Contacts of several materials count by the harmonic mean of their stiffnesses.
///                                                                           [ChangLiao1994; YimsiriSoga2000]
/// \throws   InvalidArgument as require_valid(State)
/// Accuracy  relative 1e-12; G_hh, E_v and E_h, which vanish with r = k_t/k_n, relative 1e-12 (1 + 1/r).
///            Checked by tests/effective/test_directional.cpp
[[nodiscard]] Estimate uniform_stress(const State& state);

/// An isotropic packing: a State with one stress and no fabric.
struct IsotropicPacking {
  contact::NormalLaw law;                    ///< normal contact of two grains
  double tangential_ratio = State::unset;    ///< k_t/k_n >= 0
  double radius = State::unset;              ///< R > 0 of a grain, or the radius that `contacts` refer to [m]
  double void_ratio = State::unset;          ///< e > 0
  double coordination_number = State::unset; ///< C_n >= 0
  double pressure = State::unset;            ///< p >= 0 [Pa]
  sizes::ContactMeans contacts = {};         ///< default: equal grains
};

struct IsotropicModuli {
  double bulk_modulus = 0;  ///< K [Pa]
  double shear_modulus = 0; ///< G [Pa]
};

/// K = P k_n/9 and G = P (2 k_n + 3 k_t)/30 only: fast, for the many calls of a fit or a table. The same
/// values as uniform_strain, without validity notes. K has no cancellation at any k_t/k_n.
/// [Walton1987; Digby1981]
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  8 ulp.  Checked by tests/effective/test_uniform_field.cpp
[[nodiscard]] IsotropicModuli uniform_strain_moduli(const IsotropicPacking& packing);

/// \file
/// Contact forces of a uniform strain, the counterpart of the static hypothesis.

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
