// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include <granum/contact/adhesion.hpp>
#include <granum/contact/normal_law.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// Source of k_n of a contact.
enum class StiffnessFrom {
  overlap, ///< as in a DEM code; needs coordinates with many digits
  force,   ///< for files of few digits; needs a quenched state, as viscous parts count as elastic
  ratio,   ///< (3/2) f/d, Hertz without a material: assign_stiffness_of_ratio
};

/// Sets k_n of every contact from a contact law and k_t = ratio k_n: output of DEM codes contains neither.
/// Assumes   the law is valid for all contacts: identical grains, monotonic loading; walls are rigid planes,
///           at which a grain has a contact as with its mirror image.
/// \param    assembly   its contacts are changed
/// \param    ratio      k_t/k_n >= 0 [1], as contact::mindlin_stiffness_ratio gives it
/// \param    from       a contact that does not press (overlap or force <= 0) gets k_n at zero: 0, for the
///                      flat punch its constant
/// \throws   InvalidArgument for an assembly that require_valid rejects or a ratio out of range
/// Accuracy  that of the law.  Checked by tests/packing/test_stiffness.cpp
void assign_stiffness(Assembly& assembly, const contact::NormalLaw& law, double ratio,
                      StiffnessFrom from = StiffnessFrom::overlap);

/// The same for grains of any sizes: each pair has the law of two equal grains of its contact::pair_radius, a
/// wall that of its grain, law.of(law.grain(), radius).
/// Accuracy  that of the law.  Checked by tests/packing/test_stiffness.cpp
void assign_stiffness_by_size(Assembly& assembly, const contact::NormalLaw& law, double ratio,
                              StiffnessFrom from = StiffnessFrom::overlap);

/// The same for spheres of any sizes: Hertz with 1/R* = 1/R_i + 1/R_j of each pair. [Hertz1882]
/// \throws   InvalidArgument also for a material out of range
/// Accuracy  that of the law.  Checked by tests/packing/test_stiffness.cpp
void assign_hertz_stiffness(Assembly& assembly, const contact::GrainMaterial& grain, double ratio,
                            StiffnessFrom from = StiffnessFrom::overlap);

/// The same for grains of several materials: each contact has contact::pair_material of its two grains, a
/// wall the grain's.
/// \param    materials  one for each grain
/// \param    ratio      k_t/k_n of all contacts; without it contact::mindlin_stiffness_ratio of each pair
/// \throws   InvalidArgument also unless there is one material for each grain
void assign_hertz_stiffness(Assembly& assembly, std::span<const contact::GrainMaterial> materials,
                            std::optional<double> ratio, StiffnessFrom from = StiffnessFrom::overlap);

/// The same for spheres that attract each other; k_t = ratio 2 E* a follows the contact area, not k_n.
/// Between pull-off and separation k_n of the JKR theory is below 0, at a wall as with the grain's mirror
/// image.
/// \throws   InvalidArgument also for a surface energy out of range, or from = ratio
/// Accuracy  that of contact::adhesive_contact_at_overlap.  Checked by tests/packing/test_stiffness.cpp
void assign_adhesive_stiffness(Assembly& assembly, const contact::Adhesion& adhesion,
                               std::span<const contact::GrainMaterial> materials, std::optional<double> ratio,
                               StiffnessFrom from = StiffnessFrom::overlap);

/// k_n = (3/2) f/d of Hertz' law without any material, from the force and the overlap of each contact; 0
/// where either is not positive. Walls alike: at a rigid plane f ~ d^(3/2) as well. [Hertz1882]
/// \throws   InvalidArgument for an assembly that require_valid rejects or a ratio out of range
/// Accuracy  that of the overlaps.  Checked by tests/packing/test_stiffness.cpp
void assign_stiffness_of_ratio(Assembly& assembly, double ratio);

/// Moment over angle of contacts that resist rolling or twisting, as given in DEM codes.
struct TurningSpring {
  enum class Of {
    angle,        ///< value is the stiffness [N m], as YADE's kr and LAMMPS' twisting sds
    displacement, ///< value R*^2, R* = R_i R_j/(R_i + R_j); value [N/m], as LAMMPS' rolling sds
    normal,       ///< value k_n R*^2; value [1], as LIGGGHTS' epsd with 2.25 mu_r^2
    marshall,     ///< k_t R* d/2, the value is unused: LAMMPS' twisting marshall
  };
  double value = 0;
  Of of = Of::angle;
};

/// Sets k_r of every contact; at a wall R* is the radius of the grain.
/// Assumes   k_n, k_t and overlaps are set, if the spring needs them.
/// \throws   InvalidArgument for an assembly that require_valid rejects, or a value that is negative
/// Checked by tests/packing/test_stiffness.cpp
void assign_rolling_stiffness(Assembly& assembly, const TurningSpring& spring);
/// Sets k_twist of every contact, likewise.
void assign_twisting_stiffness(Assembly& assembly, const TurningSpring& spring);

} // namespace granum::packing
