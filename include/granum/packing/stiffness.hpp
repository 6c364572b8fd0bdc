// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/power_law.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// What k_n of a contact is taken from.
enum class StiffnessFrom {
  overlap, ///< what a DEM code does itself; needs coordinates of many digits
  force,   ///< for files of few digits; needs a quenched state, as viscous parts count as elastic
};

/// Sets k_n of every contact from a contact law and k_t = ratio k_n: output of DEM codes holds neither.
/// Assumes   the law holds for all contacts: identical grains, monotonic loading; walls are rigid planes, at
///           which a grain stands as before its mirror image.
/// \param    assembly   its contacts are changed
/// \param    ratio      k_t/k_n >= 0 [1], as contact::mindlin_stiffness_ratio gives it
/// \param    from       a contact that does not press (overlap or force <= 0) gets k_n at zero: 0, for the
///                      flat punch its constant
/// \throws   InvalidArgument for an assembly that require_valid rejects or a ratio out of range
/// Accuracy  that of contact::PowerLaw.  Checked by tests/packing/test_stiffness.cpp
void assign_stiffness(Assembly& assembly, const contact::PowerLaw& law, double ratio,
                      StiffnessFrom from = StiffnessFrom::overlap);

/// The same for spheres of any sizes: Hertz with 1/R* = 1/R_i + 1/R_j of each pair. [Hertz1882]
/// \throws   InvalidArgument also for a material out of range
/// Accuracy  that of contact::PowerLaw.  Checked by tests/packing/test_stiffness.cpp
void assign_hertz_stiffness(Assembly& assembly, const contact::GrainMaterial& grain, double ratio,
                            StiffnessFrom from = StiffnessFrom::overlap);

} // namespace granum::packing
