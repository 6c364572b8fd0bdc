// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/normal_law.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::analysis {

/// The part of a packing whose contacts are counted in closed forms, in C_n, z* and the mean force. All
/// contacts if b is the same at every force. For rough grains, only those at least 5 % as stiff as a contact
/// of the mean force, because contacts of rough grains begin with almost no force, and many carry almost
/// none. With this share the factors of rung 3 are closest to those of smooth grains (validation/relaxation);
/// the smoother the grains, the fewer contacts are left out.
/// Assumes   the contacts hold their normal forces; the mean that the share refers to is over all contacts.
/// \param    law   of two grains of the mean radius, used for all pairs
/// \return   the assembly without the other contacts between grains; those with walls all stay
/// Checked by tests/analysis/test_counted_part.cpp
[[nodiscard]] packing::Assembly counted_part(const packing::Assembly& assembly,
                                             const contact::NormalLaw& law);

} // namespace granum::analysis
